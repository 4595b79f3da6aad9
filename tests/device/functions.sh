#!/bin/sh
# The functions of optical depth on the emulated Cortex-M0, M3 and AVR, small and fast
# builds: the results of this machine, by checksum.
set -eu
. tests/tap
: "${BUILD:=build}" "${CC:=cc}"

$CC -std=c99 -O2 -Ifixedpoint -Iport tests/bench/board_host.c \
    tests/bench/functions_device.c fixedpoint/*.c -o "$work/host"
"$work/host" >"$work/expected"

runs() { # runs TARGET BOARD OPTIMISE: the results of this machine
    top=$BUILD/functions$3
    make -s TARGET="$1" OPTIMISE="$3" BUILD="$top" "$top/$1/functions.elf" &&
        toolchain/emulate "$2" "$top/$1/functions.elf" >"$work/results" &&
        diff "$work/expected" "$work/results" && [ "$(wc -l <"$work/results")" -ge 9 ]
}

make -s TARGET=avr BUILD="$BUILD" "$BUILD/emulator/avr" >&2
for optimise in -Os -O3; do
    check "functions of optical depth on cortex-m0 $optimise" runs cortex-m0 microbit $optimise
    check "functions of optical depth on cortex-m3 $optimise" runs cortex-m3 lm3s6965evb $optimise
    check "functions of optical depth on avr $optimise" runs avr atmega1284p $optimise
done
finish
