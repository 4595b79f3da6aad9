#!/bin/sh
# The golden scenes on the emulated Cortex-M0 (16 KB of RAM) and Cortex-M3, small
# and fast builds: the checksums of the host. A program for each set of scenes.
set -eu
. tests/tap
build=${BUILD:-build}

# run TARGET OPTIMISE SET: one result for each scene, and one for the run.
run() {
    top=$build/golden$2
    code=0
    : >"$work/tap"
    make -s TARGET="$1" OPTIMISE="$2" BUILD="$top" "$top/$1/golden_$3.elf" >&2 &&
        toolchain/emulate "$1" "$top/$1/golden_$3.elf" >"$work/tap" || code=$?
    while read -r line; do
        case $line in
        ok\ *) outcome 0 "$1 $2 ${line#*- }" ;;
        not\ ok\ *) outcome 1 "$1 $2 ${line#*- }" ;;
        \#*) echo "# $1 $2 $3: ${line#\# }" ;;
        esac
    done <"$work/tap"
    grep -q '^1\.\.' "$work/tap" || code=1
    outcome $code "$1 $2 golden_$3 ran to its end"
}

for optimise in -Os -O3; do
    for set in steps lengths bsplines slices splats; do
        run cortex-m0 $optimise $set
        run cortex-m3 $optimise $set
    done
done
finish
