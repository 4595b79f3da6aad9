#!/bin/sh
# Twins in assembly beside the C that they stand for: millions of random samples on the
# emulated cores, to the bit.
set -eu
. tests/tap
build=${BUILD:-build}

agree() { # agree TARGET
    make -s TARGET="$1" BUILD="$build" "$build/$1/twin.elf" >&2
    code=0
    toolchain/emulate "$1" "$build/$1/twin.elf" >"$work/tap" || code=$?
    while read -r line; do
        case $line in
        ok\ *) outcome 0 "$1: ${line#*- }" ;;
        not\ ok\ *) outcome 1 "$1: ${line#*- }" ;;
        esac
    done <"$work/tap"
    grep -q '^1\.\.' "$work/tap" || code=1
    outcome $code "$1: ran to its end"
}

for target in cortex-m3 cortex-m4; do
    agree $target
done
finish
