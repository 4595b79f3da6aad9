#!/bin/sh
# The functions of optical depth on the emulated Cortex-M0, M3 and AVR, small and fast
# builds: the results of this machine, by checksum.
set -eu
. tests/tap
: "${BUILD:=build}" "${CC:=cc}"

$CC -std=c99 -O2 -Ifixedpoint -Iport tests/bench/board_host.c \
    tests/bench/functions_device.c fixedpoint/*.c -o "$work/host"
"$work/host" >"$work/expected"

runs() { # runs TARGET OPTIMISE: the results of this machine
    top=$BUILD/devices$2
    make -s TARGET="$1" OPTIMISE="$2" BUILD="$top" "$top/$1/functions.elf" &&
        toolchain/emulate "$1" "$top/$1/functions.elf" >"$work/results" &&
        diff "$work/expected" "$work/results" && [ "$(wc -l <"$work/results")" -ge 9 ]
}

for optimise in -Os -O2; do
    check "functions of optical depth on cortex-m0 $optimise" runs cortex-m0 $optimise
    check "functions of optical depth on cortex-m3 $optimise" runs cortex-m3 $optimise
    check "functions of optical depth on avr $optimise" runs avr $optimise
done
finish
