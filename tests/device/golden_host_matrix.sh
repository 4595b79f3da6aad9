#!/bin/sh
# The golden scenes on this machine by two compilers, without and with
# optimisation, as 64-bit and 32-bit programs: the same checksums.
set -eu
. tests/tap

# passes COMPILER OPTION...
passes() {
    "$@" -std=c99 -Icore -Ifixedpoint -Iport -Itests/golden -Itests/reference \
        core/*.c fixedpoint/*.c port/crc32.c tests/reference/*.c tests/golden/[!g]*.c \
        tests/golden/golden_host.c -lm -o "$work/golden" && "$work/golden"
}

for compiler in gcc clang; do
    for options in "-O0 -m64" "-O3 -m64" "-O0 -m32" "-O3 -m32"; do
        # shellcheck disable=SC2086 # the options are two words
        check "golden scenes: $compiler $options" passes $compiler $options
    done
done
finish
