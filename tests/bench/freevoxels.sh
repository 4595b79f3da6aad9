#!/bin/sh
# What FreeVoxels cost: instructions, counted exactly, of attenuation a voxel and direction and of
# splats, on the emulated devices and on this machine; time on this machine beside memcpy and
# rays; bytes of memory.
#
#     tests/bench/freevoxels.sh                 Markdown tables
#     tests/bench/freevoxels.sh TARGET    lines "NAME|PIXELS|INSTRUCTIONS|CYCLES|STACK" of one
set -eu
: "${BUILD:=build}" "${OPTIMISE:=-O2}" "${CC:=cc}"
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# divide FILE FILE: regions by what they are counted in, less the first, which is empty. Of an AVR
# the cycles too, of a Cortex-M the bytes of stack; else a dash.
divide() {
    grep '|' "$1" | paste -d '|' - "$2" | awk -F'|' '
        { split($5, region, " "); count = region[4] }
        NR == 1 { empty = count; empty_cycles = region[6]; next }
        { cycles = region[5] == "cycles" ? sprintf("%.0f", (region[6] - empty_cycles) / $2) : "-"
          stack = region[5] == "stack" ? region[6] : "-"
          printf "%s|%s|%s|%s|%s\n", $1, $3, count == "-" ? count : sprintf("%.0f", \
              (count - empty) / $2), cycles, stack }'
}

# count TARGET: to $work/TARGET.
count() {
    out=$BUILD/devices$OPTIMISE
    make -s TARGET="$1" OPTIMISE="$OPTIMISE" BUILD="$out" "$out/$1/freevoxels.elf" >&2
    EMULATOR_REPORT=$work/regions toolchain/emulate "$1" "$out/$1/freevoxels.elf" >"$work/results" \
        2>"$work/messages" || { cat "$work/results" "$work/messages" >&2; exit 1; }
    divide "$work/results" "$work/regions" >"$work/$1"
}

library() { # that of this machine
    make -s BUILD="$BUILD/bench-host" OPTIMISE=-O2 CFLAGS= lib >&2
}

# Instructions of this machine, one by one; where programs may not trace others there are none.
count_here() {
    library
    $CC -std=c99 -D_DEFAULT_SOURCE -O2 tests/emulator/steps.c -o "$work/steps"
    $CC -std=c99 -D_POSIX_C_SOURCE=200809L -O2 -Icore -Ifixedpoint -Iport \
        tests/bench/freevoxels_device.c tests/bench/board_steps.c port/crc32.c \
        port/ball.c tests/device/ball_make.c tests/device/ball_host.c \
        "$BUILD/bench-host/host/libqvol.a" -o "$work/program"
    : >"$work/host"
    if "$work/steps" "$work/program" "out=$work/regions" >"$work/results"; then
        divide "$work/results" "$work/regions" >"$work/host"
    fi
}

figure() { # figure TARGET LINE COLUMN
    value=$(sed -n "$2p" "$work/$1" | cut -d '|' -f "$3")
    echo "${value:--}"
}

row() { # row LINE
    pixels=$(figure cortex-m3 "$1" 2)
    [ "$pixels" != 0 ] || pixels=-
    echo "| $(figure cortex-m3 "$1" 1) | $pixels | $(figure cortex-m0 "$1" 3) |" \
        "$(figure cortex-m3 "$1" 3) | $(figure avr "$1" 3) | $(figure avr "$1" 4) |" \
        "$(figure host "$1" 3) | $(figure cortex-m3 "$1" 5) |"
}

if [ $# -eq 1 ]; then
    count "$1"
    cat "$work/$1"
    exit
fi
count avr
count cortex-m0
count cortex-m3
context=$(sed -n 's/^context //p' "$work/results")
count_here

cat <<END
Instructions a voxel ($(arm-none-eabi-gcc --version | head -n 1),
$(avr-gcc --version | head -n 1), here $($CC --version | head -n 1); $OPTIMISE): of a direction; of one
splat by \`qv_splat\`, its checks included; of a block of 13x13x13 voxels; of a voxel that is lit.
Opacities are stored, in 8 bits, for a unit distance; the kernel is linear where nothing else is
said; pixels are those that change. A \`qv_splats\` takes $context bytes on a Cortex-M; the stack is
what a Cortex-M3 takes below the call.

| what | pixels | M0 | M3 | AVR | AVR cycles | here | stack |
|---|---|---|---|---|---|---|---|
END
line=0
while [ $line -lt "$(wc -l <"$work/cortex-m3")" ]; do
    line=$((line + 1))
    row $line
done
echo
echo "This machine ($($CC --version | head -n 1), -O2, one thread), in one run:"
echo
$CC -std=c99 -D_POSIX_C_SOURCE=200809L -O2 -Icore tests/bench/freevoxels_host.c \
    "$BUILD/bench-host/host/libqvol.a" -o "$work/times"
"$work/times"
