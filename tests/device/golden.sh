#!/bin/sh
# The golden scenes on the emulated Cortex-M0 (16 KB of RAM) and Cortex-M3, small
# and fast builds: the checksums of the host.
set -eu
build=${BUILD:-build}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
number=0
failed=0

# run TARGET BOARD OPTIMISE: one result for each scene, renumbered.
run() {
    top=$build/golden$3
    code=0
    make -s TARGET="$1" OPTIMISE="$3" BUILD="$top" "$top/$1/golden.elf" >&2 &&
        toolchain/emulate "$2" "$top/$1/golden.elf" >"$work/tap" || code=$?
    [ -f "$work/tap" ] || : >"$work/tap"
    while read -r line; do
        case $line in
        ok\ *)
            number=$((number + 1))
            echo "ok $number - $1 $3 ${line#*- }"
            ;;
        not\ ok\ *)
            number=$((number + 1))
            failed=$((failed + 1))
            echo "not ok $number - $1 $3 ${line#*- }"
            ;;
        \#*) echo "# $1 $3: ${line#\# }" ;;
        esac
    done <"$work/tap"
    number=$((number + 1))
    if [ "$code" -eq 0 ] && grep -q '^1\.\.' "$work/tap"; then
        echo "ok $number - $1 $3 ran to its end"
    else
        failed=$((failed + 1))
        echo "not ok $number - $1 $3 ran to its end (exit code $code)"
    fi
    rm -f "$work/tap"
}

for optimise in -Os -O3; do
    run cortex-m0 microbit $optimise
    run cortex-m3 lm3s6965evb $optimise
done
echo "1..$number"
[ "$failed" -eq 0 ]
