#!/bin/sh
# A picture of FreeVoxels on the emulated Cortex-M0, M3 and ATmega1284P, small and fast builds:
# voxels and their bytes from program memory, in blocks and as a stream, and the attenuation of
# one direction; then each subject of tests/bench/freevoxels.sh. The results of this machine, by
# checksum; an AVR's cycles and RAM are printed.
set -eu
. tests/tap
: "${BUILD:=build}" "${CC:=cc}"

VOXELS=2197 # of port/ball.h
STRIPS=4    # of a frame of port/firmware_ball.c, each of all voxels
RAM=16384
GAP=256        # bytes that stay between data and stack: shorter ones may be paint by chance
CLOCK=20000000 # the most that an ATmega1284P takes
EMULATOR_SECONDS=${EMULATOR_SECONDS:-900}
export BUILD EMULATOR_SECONDS

compile() { # compile FIRMWARE PROGRAM: for this machine
    $CC -std=c99 -O2 -Icore -Ifixedpoint -Iport "$1" port/crc32.c \
        tests/bench/board_host.c port/ball.c tests/device/ball_make.c \
        tests/device/ball_host.c core/*.c fixedpoint/*.c -o "$2"
}

on_host() {
    compile port/firmware_ball.c "$work/ball" && "$work/ball" >"$work/expected" &&
        [ "$(grep -c '^[a-z]* [0-9]*$' "$work/expected")" -eq 3 ]
}

# Lines "NAME|DIVISOR|PIXELS|CHECKSUM".
subjects_on_host() {
    compile tests/bench/freevoxels_device.c "$work/subjects" &&
        "$work/subjects" | grep '|' >"$work/subjects_expected" &&
        [ "$(grep -c '|[0-9]*|[0-9]*|[0-9]*$' "$work/subjects_expected")" -ge 29 ]
}

subjects() { # subjects TARGET: the results of this machine
    top=$BUILD/devices-O2
    make -s TARGET="$1" OPTIMISE=-O2 BUILD="$top" "$top/$1/freevoxels.elf" &&
        toolchain/emulate "$1" "$top/$1/freevoxels.elf" >"$work/results" &&
        grep '|' "$work/results" | diff "$work/subjects_expected" -
}

# One picture, whatever the order of the voxels.
one_picture() {
    awk '$1 == "block" { block = $2 } $1 == "stream" { stream = $2 }
         END { exit !(block != "" && block == stream) }' "$work/expected"
}

runs() { # runs TARGET OPTIMISE: the results of this machine
    top=$BUILD/devices$2
    make -s TARGET="$1" OPTIMISE="$2" BUILD="$top" "$top/$1/ball.elf" &&
        EMULATOR_REPORT=$work/$1$2 toolchain/emulate "$1" "$top/$1/ball.elf" >"$work/results" &&
        diff "$work/expected" "$work/results"
}

# What data and stack leave of the RAM was never written.
fits() { # fits OPTIMISE
    used=$(awk '$2 == 2 { print $8 }' "$work/avr$1")
    echo "${used:-nothing} of $RAM bytes used"
    [ "${used:-0}" -gt 4096 ] && [ "$used" -le $((RAM - GAP)) ]
}

figures() { # figures OPTIMISE
    awk -v what="# freevoxels on avr $1" -v voxels=$VOXELS -v strips=$STRIPS -v clock=$CLOCK '
        $2 < 2 { printf "%s, frame %s: %.0f cycles a voxel and strip, %.1f s at %d MHz\n", what,
                     $2 == 0 ? "by blocks" : "from a stream", $6 / voxels / strips, $6 / clock,
                     clock / 1000000 }
        $2 == 2 { printf "%s, attenuation: %.0f cycles a voxel and direction\n", what, $6 / voxels
                  printf "%s: %d bytes of RAM\n", what, $8 }' "$work/avr$1"
}

check "freevoxels on this machine" on_host
check "freevoxels: blocks and a stream make one picture" one_picture
for optimise in -Os -O2; do
    check "freevoxels on cortex-m0 $optimise" runs cortex-m0 $optimise
    check "freevoxels on cortex-m3 $optimise" runs cortex-m3 $optimise
    check "freevoxels on avr $optimise" runs avr $optimise
    check "freevoxels on avr $optimise: data and stack fit the RAM" fits $optimise
    figures $optimise
done
check "subjects of freevoxels on this machine" subjects_on_host
check "subjects of freevoxels on cortex-m0" subjects cortex-m0
check "subjects of freevoxels on cortex-m3" subjects cortex-m3
check "subjects of freevoxels on avr" subjects avr
finish
