#!/bin/sh
# What blends cost, by exact counts of the emulated Cortex-M3: the dithered blend of 8 bits beside
# the plain one that an engineer writes by hand. Every blend gives the results of this
# machine, by checksum, on the Cortex-M0, M3 and AVR, and divides nowhere.
set -eu
. tests/tap
: "${BUILD:=build}" "${CC:=cc}"

$CC -std=c99 -O2 -Icore -Ifixedpoint -Iport tests/bench/board_host.c tests/bench/blends_device.c \
    core/*.c fixedpoint/*.c -o "$work/host"
"$work/host" >"$work/expected"

runs() { # runs TARGET OPTIMISE: the results of this machine
    top=$BUILD/devices$2
    make -s TARGET="$1" OPTIMISE="$2" BUILD="$top" "$top/$1/blends.elf" &&
        toolchain/emulate "$1" "$top/$1/blends.elf" >"$work/results" &&
        diff "$work/expected" "$work/results" && [ "$(wc -l <"$work/results")" -ge 26 ]
}

undivided() { # undivided PREFIX TARGET: no instruction and no helper that divides
    for name in blend_over blend_under blend_hardware dither buffer; do
        "$1-objdump" -dr "$BUILD/devices-O2/$2/core/$name.o" >"$work/code" &&
            grep -q '<blend_\|<qv_' "$work/code" &&
            ! grep -E '[us]div|__aeabi_u?l?i?div|__u?div(mod)?[qhsd]' "$work/code" || return 1
    done
}

counted() {
    BUILD=$BUILD tests/bench/blends.sh cortex-m3 >"$work/counts"
}

at_most() { # at_most TIMES NAME BASE: instructions of one beside those of the other
    status=0
    awk -F'|' -v most="$1" -v name="$2" -v base="$3" '
        $1 == name { cost = $2 }
        $1 == base { plain = $2 }
        END { printf "# %s: %s instructions a pixel, %s: %s\n", name, cost, base, plain
              exit !(plain > 0 && cost > 0 && cost <= most * plain) }' "$work/counts" || status=1
    outcome $status "$2 takes at most $1 times the instructions of $3"
}

for optimise in -Os -O2; do
    check "blends on cortex-m0 $optimise" runs cortex-m0 $optimise
    check "blends on cortex-m3 $optimise" runs cortex-m3 $optimise
    check "blends on avr $optimise" runs avr $optimise
done
check "no division on cortex-m0" undivided arm-none-eabi cortex-m0
check "no division on cortex-m3" undivided arm-none-eabi cortex-m3
check "no division on avr" undivided avr avr
check "instructions of every blend" counted
at_most 2 over_rgb888 by_hand_rgb
at_most 2 over_rgba8888 by_hand_rgba
finish
