#!/bin/sh
# The golden scenes on this machine by two compilers, without and with
# optimisation, as 64-bit and 32-bit programs: the same checksums.
set -eu
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
number=0
failed=0

for compiler in gcc clang; do
    for options in "-O0 -m64" "-O3 -m64" "-O0 -m32" "-O3 -m32"; do
        number=$((number + 1))
        name="golden scenes: $compiler $options"
        rm -f "$work/tap"
        # shellcheck disable=SC2086 # the options are two words
        if $compiler -std=c99 $options -Icore -Ifixedpoint -Iport -Itests/golden -Itests/reference \
            core/*.c fixedpoint/*.c port/crc32.c tests/reference/*.c tests/golden/scenes.c \
            tests/golden/volume.c tests/golden/render.c tests/golden/golden_host.c \
            -lm -o "$work/golden" && "$work/golden" >"$work/tap"; then
            echo "ok $number - $name"
        else
            failed=$((failed + 1))
            echo "not ok $number - $name"
            grep -s '^not ok' "$work/tap" | sed 's/^/# /' || :
        fi
    done
done
echo "1..$number"
[ "$failed" -eq 0 ]
