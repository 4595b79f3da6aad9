#!/bin/sh
# The library and the unit tests compile without a warning: gcc and clang, four
# levels of optimisation (which warnings depend on), and 32 bits.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset MAKEFLAGS MFLAGS MAKELEVEL # of a make that runs this script
number=0
failed=0

# What a build with all warnings makes of each file.
objects() {
    for file in core/*.c fixedpoint/*.c; do
        echo "$work/build/host/${file%.c}.o"
    done
    for file in tests/unit/*.c; do
        echo "$work/build/tests/${file%.c}.o"
    done
}

compiles() { # compiles COMPILER OPTIMISE CFLAGS
    number=$((number + 1))
    rm -rf "$work/build"
    # shellcheck disable=SC2046
    if make -s -j2 BUILD="$work/build" CC="$1" OPTIMISE="$2" CFLAGS="$3" $(objects) \
        >"$work/log" 2>&1 && ! grep -i warning "$work/log"; then
        echo "ok $number - $1 $2${3:+ $3}"
    else
        failed=1
        echo "not ok $number - $1 $2${3:+ $3}"
        grep -v '^  CC' "$work/log" | head -n 20 | sed 's/^/# /'
    fi
}

for compiler in gcc clang; do
    for optimise in -O0 -O2 -Os -O3; do
        compiles $compiler $optimise ""
    done
done
compiles gcc -O2 -m32
echo "1..$number"
exit $failed
