#!/bin/sh
# Instructions on the emulated devices: everything that qv_render_some executes for an 8x8
# frame of rays of about 40 samples, divided by the samples. "full": no sample is skipped;
# "sparse": as many as told. "inside" and "ray" part "full" in what each sample costs inside
# a ray, and what each ray costs besides: set-up and pixel.
#
#     tests/bench/device.sh           a Markdown table of both devices
#     tests/bench/device.sh TARGET    lines "STORAGE MODE SCENE INSTRUCTIONS" of one; on an
#                                     AVR, of some modes, in cycles
#     tests/bench/device.sh TARGET all    the same of all modes, on an AVR by several programs
set -eu
: "${BUILD:=build}" "${OPTIMISE:=-O2}"
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

count() { # count TARGET [PROGRAM]
    out=$BUILD/devices$OPTIMISE
    program=$out/$1/${2:-bench}.elf
    make -s TARGET="$1" OPTIMISE="$OPTIMISE" BUILD="$out" "$program" >&2
    EMULATOR_REPORT=$work/regions toolchain/emulate "$1" "$program" >"$work/scenes" \
        2>"$work/messages" ||
        { cat "$work/scenes" "$work/messages" >&2; exit 1; }
    paste -d ' ' "$work/scenes" "$work/regions" |
        awk '{ rays = $4; samples = $5; executed = $11 == "cycles" ? $12 : $10; mode = $1 " " $2 }
            $3 != "fine" { print mode, $3, sprintf("%.0f", executed / samples) }
            $3 == "full" { full = executed; taken = samples }
            $3 == "fine" {
                inside = (executed - full) / (samples - taken)
                print mode, "inside", sprintf("%.0f", inside)
                print mode, "ray", sprintf("%.0f", (full - inside * taken) / rays)
            }'
}

# A row for each mode, a column for each storage and device, "FULL / SPARSE" in each.
rows() {
    paste -d ' ' "$work/cortex-m3" "$work/cortex-m0" | awk '
        { stored = $1 ~ /t[0-9]/; column = $1; sub(/rgbt/, "rgba", column); sub(/_t8/, "", column)
          sub(/_t/, "_", column); sub(/associated/, "rgba", column); row = $2 (stored ? ", stored" : "") }
        !(row in seen) { seen[row] = 1; name[rows++] = row }
        { cell[row, column, 3, $3] = $4; cell[row, column, 0, $3] = $8 }
        END {
            columns = split("rgba8 rgba16 indexed8 indexed8_16", column_name)
            for (r = 0; r < rows; r++) {
                printf "| %s |", name[r]
                for (core = 3; core >= 0; core -= 3)
                    for (c = 1; c <= columns; c++) {
                        at = name[r] SUBSEP column_name[c] SUBSEP core
                        if ((at, "full") in cell)
                            printf " %d / %d |", cell[at, "full"], cell[at, "sparse"]
                        else
                            printf " - |"
                    }
                print ""
            }
        }'
}

if [ "${2:-}" = all ]; then
    for program in $(make -s TARGET="$1" print-TARGET_BENCHES); do
        count "$1" "$program"
    done
    exit
fi
if [ $# -eq 1 ]; then
    count "$1"
    exit
fi
count cortex-m3 >"$work/cortex-m3"
count cortex-m0 >"$work/cortex-m0"

skipped=$(awk '$3 == "sparse" { all += $5; clear += $6 } END { printf "%.0f", 100 * clear / all }' \
    "$work/scenes")
echo "Instructions a sample ($(arm-none-eabi-gcc --version | head -n 1), $OPTIMISE), where"
echo "every sample is taken / where $skipped % lie in cells that are skipped; \"stored\" is of voxels"
echo "that hold extinction; modes that weigh by length take steps of 1/4 of the unit distance:"
echo
echo "| sampling | Cortex-M3, 8 bits | 16 bits | indexed8 | indexed8_16 |" \
    "Cortex-M0, 8 bits | 16 bits | indexed8 | indexed8_16 |"
echo "|---|---|---|---|---|---|---|---|---|"
rows
