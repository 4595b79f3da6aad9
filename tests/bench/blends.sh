#!/bin/sh
# What a blend of slices costs, each beside the blend of 8 bits that an engineer writes by
# hand: instructions a pixel, counted exactly in emulated runs; bytes of RAM and flash.
#
#     tests/bench/blends.sh                 a Markdown table of all devices
#     tests/bench/blends.sh TARGET    lines "NAME|INSTRUCTIONS|CYCLES" of one
set -eu
: "${BUILD:=build}" "${OPTIMISE:=-O2}"
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

PIXELS=512 # blended in a region: those of blends_device.c

# count TARGET: what a pixel takes; the cycles are those of an AVR, else nothing.
count() {
    out=$BUILD/devices$OPTIMISE
    make -s TARGET="$1" OPTIMISE="$OPTIMISE" BUILD="$out" "$out/$1/blends.elf" >&2
    EMULATOR_REPORT=$work/regions toolchain/emulate "$1" "$out/$1/blends.elf" >"$work/results" \
        2>"$work/messages" || { cat "$work/results" "$work/messages" >&2; exit 1; }
    paste -d '|' "$work/results" "$work/regions" | awk -F'|' -v pixels=$PIXELS '
        { split($5, region, " ")
          cycles = region[5] == "cycles" ? sprintf("%.0f", region[6] / pixels) : "-"
          printf "%s|%.1f|%s\n", $1, region[4] / pixels, cycles }'
}

figure() { # figure TARGET NAME COLUMN
    awk -F'|' -v name="$2" -v column="$3" '$1 == name { print $column }' "$work/$1"
}

ram() { # ram NAME: "PIXEL + BESIDE" in bytes
    awk -F'|' -v name="$1" '$1 == name { print $2, "+", $3 }' "$work/results"
}

# flash SYMBOL...: "CODE + TABLES" in bytes of what a program links that names these, but for
# memset and memcpy; nothing else that is called is missing.
flash() {
    roots=
    for symbol; do
        roots="$roots -u $symbol"
    done
    # shellcheck disable=SC2086 # several options
    arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb -nostdlib -r -Wl,--gc-sections -Wl,-e,"$1" $roots \
        "$BUILD/cortex-m0/libqvol.a" -lgcc -o "$work/linked"
    if arm-none-eabi-nm -u "$work/linked" | grep -v -e ' memset$' -e ' memcpy$' >&2; then
        return 1
    fi
    arm-none-eabi-size -A "$work/linked" | awk '
        /^\.text/ { code += $2 } /^\.(rodata|data)/ { tables += $2 }
        END { print code + 0, "+", tables + 0 }'
}

# symbols NAME: what a program names for it.
symbols() {
    case $1 in
    by_hand*) ;;
    over_* | under_*) echo "qv_$1" ;;
    *) echo "qv_${1% *} qv_technique_${1#* } qv_moment_opacity" ;;
    esac
}

row() { # row NAME
    named=$(symbols "$1")
    # shellcheck disable=SC2086 # several symbols
    bytes=$([ -z "$named" ] && echo - || flash $named)
    ratio=$(awk -v cost="$(figure cortex-m3 "$1" 2)" -v base="$(figure cortex-m3 by_hand_rgb 2)" \
        'BEGIN { printf "%.2f", cost / base }')
    printf '| %s | %.0f | %.0f | %s | %.0f | %s | %s | %s |\n' "$1" \
        "$(figure cortex-m0 "$1" 2)" "$(figure cortex-m3 "$1" 2)" "$ratio" \
        "$(figure avr "$1" 2)" "$(figure avr "$1" 3)" "$(ram "$1")" "$bytes"
}

if [ $# -eq 1 ]; then
    count "$1"
    exit
fi
count cortex-m0 >"$work/cortex-m0"
count cortex-m3 >"$work/cortex-m3"
count avr >"$work/avr"
make -s TARGET=cortex-m0 OPTIMISE=-Os BUILD="$BUILD" lib >&2

cat <<END
Blending a slice into a frame buffer: instructions a pixel
($(arm-none-eabi-gcc --version | head -n 1), $(avr-gcc --version | head -n 1); $OPTIMISE),
loop, dither value and call included. by_hand is what one writes by hand for 8 bits, equation 1
(rgba: 6 and 7) in a loop of its own. Bytes of RAM are those of a pixel and beside it; of flash, code
and tables on a Cortex-M0 at -Os. A dither table takes, in flash or RAM, 256 bytes a slice of its
period, with colours 1024.

| blend | M0 | M3 | of by_hand_rgb | AVR | AVR cycles | RAM | flash |
|---|---|---|---|---|---|---|---|
END
cut -d '|' -f 1 "$work/results" | while read -r name; do
    row "$name"
done
