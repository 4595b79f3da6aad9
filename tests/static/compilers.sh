#!/bin/sh
# The library, its tests and the command compile without a warning: gcc and clang, four levels
# of optimisation (which warnings depend on). As 32-bit programs, where offsets and
# sizes are narrower, the unit tests and golden scenes also pass.
set -eu
. tests/tap

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

makes() { # makes COMPILER OPTIMISE CFLAGS TARGET...: without a warning
    compiler=$1 optimise=$2 cflags=$3
    shift 3
    rm -rf "$work/build"
    make -s -j2 BUILD="$work/build" CC="$compiler" OPTIMISE="$optimise" CFLAGS="$cflags" "$@" \
        >"$work/messages" 2>&1 || { tail -n 20 "$work/messages" && return 1; }
    ! grep -i warning "$work/messages"
}

for compiler in gcc clang; do
    for optimise in -O0 -O2 -Os -O3; do
        # shellcheck disable=SC2046
        check "$compiler $optimise" makes $compiler $optimise "" $(objects) "$work/build/host/qvol"
    done
done
check "gcc -O2 -m32" makes gcc -O2 -m32 check
finish
