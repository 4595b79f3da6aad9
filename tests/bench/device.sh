#!/bin/sh
# Instructions a sample on the emulated devices, as a Markdown table: everything
# that qv_render_some executes for a 16x16 frame of rays of about 40 samples,
# divided by the samples. "full": no sample is skipped; "sparse": as many as told.
set -eu
: "${BUILD:=build}" "${OPTIMISE:=-O2}"
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
plugin=$BUILD/emulator/count.so

count() { # count TARGET BOARD: lines "STORAGE MODE SCENE INSTRUCTIONS" for one device
    out=$BUILD/bench$OPTIMISE
    make -s TARGET="$1" OPTIMISE="$OPTIMISE" BUILD="$out" "$out/$1/bench.elf" >&2
    EMULATOR_OPTIONS="-plugin $plugin,out=$work/regions" \
        toolchain/emulate "$2" "$out/$1/bench.elf" >"$work/scenes" 2>"$work/messages" ||
        { cat "$work/scenes" "$work/messages" >&2; exit 1; }
    paste -d ' ' "$work/scenes" "$work/regions" |
        awk '{ printf "%s %s %s %.0f\n", $1, $2, $3, $9 / $4 }' >"$work/$1"
}

make -s TARGET=cortex-m3 BUILD="$BUILD" "$plugin" >&2
count cortex-m3 lm3s6965evb
count cortex-m0 microbit

skipped=$(awk '$3 == "sparse" { all += $4; clear += $5 } END { printf "%.0f", 100 * clear / all }' \
    "$work/scenes")
echo "Instructions a sample ($(arm-none-eabi-gcc --version | head -n 1), $OPTIMISE); full: every"
echo "sample is taken; sparse: $skipped % lie in cells that are skipped:"
echo
echo "| storage | sampling | Cortex-M3 full | sparse | Cortex-M0 full | sparse |"
echo "|---|---|---|---|---|---|"
paste -d ' ' "$work/cortex-m3" "$work/cortex-m0" |
    awk '$3 == "full"   { m3 = $4; m0 = $8 }
         $3 == "sparse" { printf "| %s | %s | %d | %d | %d | %d |\n", $1, $2, m3, $4, m0, $8 }'
