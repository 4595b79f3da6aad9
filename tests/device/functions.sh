#!/bin/sh
# The functions of optical depth on the emulated Cortex-M0 and M3, small and fast
# builds: the results of this machine, by checksum.
set -eu
. tests/tap
: "${BUILD:=build}" "${CC:=cc}"

# What the firmware needs of a board, for this machine.
cat >"$work/host.c" <<'END'
#include <stdio.h>
#include "measure.h"
#include "semihosting.h"
void measure_begin(void) {}
void measure_end(void) {}
void console_text(const char *text) { fputs(text, stdout); }
void console_decimal(uint32_t value) { printf("%lu", (unsigned long)value); }
END
$CC -std=c99 -O2 -Ifixedpoint -Iport/cortex-m "$work/host.c" tests/bench/functions_device.c \
    fixedpoint/*.c -o "$work/host"
"$work/host" >"$work/expected"

runs() { # runs TARGET BOARD OPTIMISE: the results of this machine
    top=$BUILD/functions$3
    make -s TARGET="$1" OPTIMISE="$3" BUILD="$top" "$top/$1/functions.elf" &&
        toolchain/emulate "$2" "$top/$1/functions.elf" >"$work/results" &&
        diff "$work/expected" "$work/results" && [ "$(wc -l <"$work/results")" -ge 8 ]
}

for optimise in -Os -O3; do
    check "functions of optical depth on cortex-m0 $optimise" runs cortex-m0 microbit $optimise
    check "functions of optical depth on cortex-m3 $optimise" runs cortex-m3 lm3s6965evb $optimise
done
finish
