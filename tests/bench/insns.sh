#!/bin/sh
# What the library executes on each emulated target, counted exactly (-O2): instructions, on an
# AVR cycles.
#
#     tests/bench/insns.sh lines TARGET...      lines "TARGET STORAGE MODE WHAT COUNT"
#     tests/bench/insns.sh samples TARGET...    the same without blends
#     tests/bench/insns.sh table                such lines, from standard input, as Markdown
#
# WHAT is "inside", a sample inside a ray; "ray", all that a ray costs besides: its set-up and its
# pixel; or "pixel", a blended one: then STORAGE is "blend" and MODE names it. STORAGE "float"
# is the same arithmetic in floats (float_device.c), in software where the target has no unit.
set -eu
: "${BUILD:=build}" "${OPTIMISE:=-O2}"
export BUILD OPTIMISE
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

samples() { # samples TARGET
    tests/bench/device.sh "$1" >"$work/samples"
    awk -v target="$1" '$3 == "inside" || $3 == "ray" { print target, $0 }' "$work/samples"
}

blends() { # blends TARGET
    tests/bench/blends.sh "$1" >"$work/blends"
    awk -F'|' -v target="$1" '{ gsub(/ /, "_", $1); count = $3 == "-" ? $2 : $3
        printf "%s blend %s pixel %.0f\n", target, $1, count }' "$work/blends"
}

# The difference of two runs, one with more samples.
floats() { # floats TARGET
    out=$BUILD/bench$OPTIMISE
    make -s TARGET="$1" OPTIMISE="$OPTIMISE" BUILD="$out" "$out/$1/float.elf" >&2
    EMULATOR_REPORT=$work/regions toolchain/emulate "$1" "$out/$1/float.elf" >"$work/float"
    awk -v target="$1" '
        NR == FNR { samples = $3 - $2; next }
        { count[FNR] = $5 == "cycles" ? $6 : $4 }
        END { printf "%s float weighted inside %.0f\n", target, (count[2] - count[1]) / samples }' \
        "$work/float" "$work/regions"
}

table() {
    awk '
        !($1 in column) { column[$1] = ++columns; target[columns] = $1 }
        $4 == "pixel" { row = "blend " $3 }
        $2 == "float" { row = "the same in float: sample inside a ray"; float[$1] = $5 }
        $4 == "inside" && $2 != "float" { row = $3 " " $2 ": sample inside a ray" }
        $4 == "ray" { row = $3 " " $2 ": ray and pixel" }
        !(row in seen) { seen[row] = 1; name[++rows] = row }
        { cell[row, $1] = $5 }
        END {
            printf "| instructions (avr: cycles) |"
            for (c = 1; c <= columns; c++)
                printf " %s |", target[c]
            printf "\n|---|"
            for (c = 1; c <= columns; c++)
                printf "---|"
            print ""
            for (r = 1; r <= rows; r++) {
                printf "| %s |", name[r]
                for (c = 1; c <= columns; c++)
                    printf " %s |", ((name[r], target[c]) in cell) ? cell[name[r], target[c]] : "-"
                print ""
            }
            printf "| ratio of float to weighted rgba8 |"
            for (c = 1; c <= columns; c++) {
                whole = cell["weighted rgba8: sample inside a ray", target[c]]
                printf " %s |", whole ? sprintf("%.1f", float[target[c]] / whole) : "-"
            }
            print ""
        }'
}

kind=${1:-}
case $kind in
lines | samples)
    shift
    for target; do
        samples "$target"
        [ "$kind" = samples ] || blends "$target"
        floats "$target"
    done
    ;;
table) table ;;
*)
    echo "usage: tests/bench/insns.sh lines TARGET... | samples TARGET... | table" >&2
    exit 2
    ;;
esac
