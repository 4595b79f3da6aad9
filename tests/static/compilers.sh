#!/bin/sh
# The library, its tests and the command compile without a warning: gcc and clang, four levels
# of optimisation (which warnings depend on). As 32-bit programs, where offsets and
# sizes are narrower, the unit tests and golden scenes also pass.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
unset MAKEFLAGS MFLAGS MAKELEVEL # of a make that runs this script
number=0
failed=0

# The objects of the library and of its tests on this machine.
objects() {
    for file in core/*.c fixedpoint/*.c; do
        echo "$work/build/host/${file%.c}.o"
    done
    for file in tests/unit/*.c tests/reference/*.c tests/accuracy/*.c tests/golden/[!g]*.c \
        tests/golden/golden_host.c; do
        echo "$work/build/tests/${file%.c}.o"
    done
}

makes() { # makes COMPILER OPTIMISE CFLAGS TARGET...
    number=$((number + 1))
    name="$1 $2${3:+ $3}"
    compiler=$1 optimise=$2 cflags=$3
    shift 3
    rm -rf "$work/build"
    if make -s -j2 BUILD="$work/build" CC="$compiler" OPTIMISE="$optimise" CFLAGS="$cflags" "$@" \
        >"$work/log" 2>&1 && ! grep -i warning "$work/log"; then
        echo "ok $number - $name"
    else
        failed=1
        echo "not ok $number - $name"
        grep -e error -e warning -e 'not ok' "$work/log" | head -n 20 | sed 's/^/# /'
    fi
}

for compiler in gcc clang; do
    for optimise in -O0 -O2 -Os -O3; do
        # shellcheck disable=SC2046
        makes $compiler $optimise "" $(objects) "$work/build/host/qvol"
    done
done
makes gcc -O2 -m32 check
echo "1..$number"
exit $failed
