#!/bin/sh
# A volume larger than the memory left for it, on the emulated Cortex-M0, M3 and ATmega1284P: voxels
# read as if from a card, through pages. The pictures of voxels in memory, and of this machine, by
# checksum, and as many reads; what a sample costs beside one in memory is printed.
set -eu
. tests/tap
: "${BUILD:=build}" "${CC:=cc}"
EMULATOR_SECONDS=${EMULATOR_SECONDS:-900}
export BUILD EMULATOR_SECONDS

on_host() {
    $CC -std=c99 -O2 -Icore -Ifixedpoint -Iport port/firmware_pages.c port/crc32.c \
        tests/bench/board_host.c port/ball.c tests/device/ball_make.c \
        tests/device/ball_host.c core/*.c fixedpoint/*.c -o "$work/pages" &&
        "$work/pages" >"$work/expected" && [ "$(wc -l <"$work/expected")" -eq 4 ]
}

one_picture() {
    awk '{ pictures[$2]++ } END { exit !(length(pictures) == 1) }' "$work/expected"
}

# The cache is smaller than the volume: bricks and slices are read again.
caches_are_small() {
    awk '$1 == "whole" { bricks = $10 == 0 } $1 == "bricks" { small = $10 > 64 }
         $1 == "slices" { thin = $10 > 13 } END { exit !(bricks && small && thin) }' "$work/expected"
}

runs() { # runs TARGET: the results of this machine
    top=$BUILD/ball-Os
    make -s TARGET="$1" OPTIMISE=-Os BUILD="$top" "$top/$1/pages.elf" &&
        EMULATOR_REPORT=$work/$1 toolchain/emulate "$1" "$top/$1/pages.elf" >"$work/results" &&
        diff "$work/expected" "$work/results"
}

figures() { # figures TARGET: everything that a frame takes, by its samples
    paste -d ' ' "$work/expected" "$work/$1" | awk -v what="# pages on $1 -Os" '
        { reads = 0; for (i = 1; i < NF; i++) {
              if ($i == "instructions") executed = $(i + 1)
              if ($i == "reads") reads = $(i + 1) }
          printf "%s, %s: %.0f instructions a sample, %d reads\n", what, $1, executed / $4, reads }'
}

check "pages on this machine" on_host
check "pages: one picture through every cache" one_picture
check "pages: caches smaller than the volume read again" caches_are_small
for target in cortex-m0 cortex-m3 avr; do
    check "pages on $target" runs $target
    figures $target
done
finish
