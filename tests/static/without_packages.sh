#!/bin/sh
# A machine with a C compiler, make and the basic tools, and no other package: the
# library, its tests and the command build there, and the command draws the same.
#
# The machine is a root directory of its own: the files of those packages and of
# all that they depend on, copied from this Debian system. Needs root for chroot.
set -eu
. tests/tap
PACKAGES="gcc libc6-dev make dash coreutils findutils diffutils grep sed mawk"
: "${QVOL:=build/host/qvol}"
root=$work/root

# ---- The machine --------------------------------------------------------------

# The packages and what they depend on; of alternatives the first.
closure() {
    dpkg-query -W -f '${Package}\t${Pre-Depends},${Depends}\n' | awk -v wanted="$PACKAGES" '
        { depends[$1] = depends[$1] "," substr($0, length($1) + 2) }
        END {
            count = split(wanted, queue, " ")
            for (i = 1; i <= count; i++) {
                if (queue[i] in seen || !(queue[i] in depends))
                    continue
                seen[queue[i]]
                print queue[i]
                n = split(depends[queue[i]], list, ",")
                for (j = 1; j <= n; j++) {
                    sub(/^ +/, "", list[j])
                    sub(/[ :|(].*$/, "", list[j])
                    if (list[j] != "")
                        queue[++count] = list[j]
                }
            }
        }'
}

furnish() {
    mkdir -p "$root/dev" "$root/tmp" "$root/work"
    for directory in bin sbin lib lib64; do
        mkdir -p "$root/usr/$directory"
        ln -s "usr/$directory" "$root/$directory"
    done
    # shellcheck disable=SC2046
    dpkg -L $(closure) | grep '^/' | grep -v '^/usr/share/' | sort -u |
        while read -r file; do
            if [ ! -d "$file" ] || [ -h "$file" ]; then
                echo "${file#/}"
            fi
        done >"$work/files"
    tar -cf - -C / --no-recursion -T "$work/files" --transform 's|^\(s\?bin\|lib\(64\)\?\)/|usr/&|' |
        tar -xf - -C "$root"
    ln -s gcc "$root/usr/bin/cc"
    ln -s mawk "$root/usr/bin/awk"
    mknod -m 666 "$root/dev/null" c 1 3 || : >"$root/dev/null" # a file does as well
    tar -cf - Makefile core fixedpoint port tests toolchain | tar -xf - -C "$root/work"
}

# inside COMMAND...: in the new machine's copy of this project.
inside() {
    chroot "$root" /usr/bin/env -i PATH=/usr/bin LC_ALL=C sh -c 'cd /work && exec "$@"' - "$@"
}

# ---- Tests --------------------------------------------------------------------

hides_the_packages() {
    for header in png.h zlib.h nifti2_io.h teem/nrrd.h cmocka.h string.h; do
        echo "#include <$header>" | inside cc -E -I/usr/include/nifti - >/dev/null || echo "$header"
    done >"$work/hidden" 2>/dev/null
    tr '\n' ' ' <"$work/hidden"
    [ "$(wc -l <"$work/hidden")" -eq 5 ] && ! grep -q string.h "$work/hidden"
}

checks() {
    inside make -s check | tee "$work/check"
    grep -q '^[1-9][0-9]* passed, 0 failed$' "$work/check"
}

# Any bytes are a volume: these are a piece of text. Not one plain colour comes of it.
draws_the_same() {
    head -c 4096 "$root/work/core/qvol.h" >"$root/work/$RAW"
    set -- render $RAW -q --tf surface --shade --size 48x40 --azimuth 30 -o
    inside build/host/qvol "$@" without.pam &&
        (cd "$root/work" && "$ordinary" "$@" with.pam) &&
        cmp "$root/work/without.pam" "$root/work/with.pam" &&
        [ "$(od -An -v -t u1 -w1 "$root/work/with.pam" | sort -u | wc -l)" -ge 64 ]
}

# refuses STATUS COMMAND...: one line that names a package, and no file.
refuses() {
    expected=$1
    shift
    status=0
    inside "$@" >"$work/output" 2>"$work/error" || status=$?
    cat "$work/output" "$work/error"
    [ $status -eq "$expected" ] && [ ! -s "$work/output" ] &&
        [ "$(wc -l <"$work/error")" -eq 1 ] && grep -q 'needs the package' "$work/error" &&
        [ ! -e "$root/work/out.png" ]
}

RAW=text_16x16x16_uint8.raw
ordinary=$(realpath "$QVOL")
check "without packages: a root directory of the compiler and its like" furnish
check "without packages: headers of other packages are hidden" hides_the_packages
check "without packages: make" inside make -s
check "without packages: make lib" inside make -s lib
check "without packages: make check" checks
check "without packages: a raw volume is drawn as PAM, like by the ordinary command" draws_the_same
check "without packages: PNG is refused in a line" refuses 2 build/host/qvol render $RAW -o out.png
{ printf '\134\001\0\0' && head -c 340 /dev/zero && printf 'n+1\0'; } >"$root/work/in.nii"
check "without packages: NIfTI is refused in a line" refuses 1 build/host/qvol info in.nii
finish
