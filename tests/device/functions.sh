#!/bin/sh
# The functions of optical depth on the emulated Cortex-M0 and M3, small and fast
# builds: the results of this machine, by checksum.
set -eu
: "${BUILD:=build}" "${CC:=cc}"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
number=0
failed=0

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

# run TARGET BOARD OPTIMISE
run() {
    top=$BUILD/functions$3
    number=$((number + 1))
    if make -s TARGET="$1" OPTIMISE="$3" BUILD="$top" "$top/$1/functions.elf" >&2 &&
        toolchain/emulate "$2" "$top/$1/functions.elf" >"$work/results" 2>"$work/messages" &&
        cmp -s "$work/expected" "$work/results" && [ "$(wc -l <"$work/results")" -ge 8 ]; then
        echo "ok $number - functions of optical depth on $1 $3"
    else
        failed=1
        echo "not ok $number - functions of optical depth on $1 $3"
        diff "$work/expected" "$work/results" | sed 's/^/# /'
    fi
}

for optimise in -Os -O3; do
    run cortex-m0 microbit $optimise
    run cortex-m3 lm3s6965evb $optimise
done
echo "1..$number"
exit $failed
