#!/bin/sh
# `make install`: what it puts where, and that a program of ten lines builds and runs
# with nothing but what pkg-config tells.
set -eu
. tests/tap
: "${CC:=cc}"
prefix=$work/prefix

cat >"$work/list" <<'END'
bin/qvol
bin/qvol-mpi
include/qvol.h
lib/libqvol.a
lib/pkgconfig/qvol.pc
END
for file in tests/vectors/*.csv tests/vectors/*.tsv; do
    echo "share/qvol/vectors/$(basename "$file")"
done | LC_ALL=C sort >>"$work/list"

cat >"$work/program.c" <<'END'
#include <qvol.h>
#include <stdio.h>
int main(void)
{
    qv_volume empty = {0};
    printf("%s\n", qv_version());
    return qv_volume_check(&empty) == QV_ERROR_NULL ? 0 : 1;
}
END

installs() { # installs VARIABLE=VALUE...
    make -s BUILD="${BUILD:-build}" install "$@"
}

listed() {
    (cd "$prefix" && find . -type f | sed 's|^\./||' | LC_ALL=C sort) | diff "$work/list" -
}

compiles() {
    # shellcheck disable=SC2046
    "$CC" -std=c99 "$work/program.c" $(pkg-config --cflags --libs qvol) -o "$work/program"
}

one_version() {
    version=$(pkg-config --modversion qvol)
    echo "pkg-config: $version"
    "$work/program" | grep -Fx "$version" && "$prefix/bin/qvol" --version | grep -Fx "qvol $version"
}

# DESTDIR goes before the prefix and leaves no trace in what is installed.
staged() {
    installs DESTDIR="$work/stage" PREFIX=/opt/qvol && [ -x "$work/stage/opt/qvol/bin/qvol" ] &&
        grep -Fx 'prefix=/opt/qvol' "$work/stage/opt/qvol/lib/pkgconfig/qvol.pc"
}

export PKG_CONFIG_PATH="$prefix/lib/pkgconfig"
check "make install" installs PREFIX="$prefix"
check "header, archive, pkg-config file, commands and vectors, nothing else" listed
check "a program compiles with what pkg-config tells" compiles
check "program, command and pkg-config name one version" one_version
check "the installed command finds the installed vectors" "$prefix/bin/qvol" vectors show weights-00000
check "make install with DESTDIR" staged
finish
