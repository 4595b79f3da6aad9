#!/bin/sh
# Marches in vectors or in assembly beside those in C, on the emulated devices that have them:
# random rays, bit by bit. The golden scenes hold them to the host's pictures.
set -eu
. tests/tap
build=${BUILD:-build}

run() { # run TARGET
    code=0
    : >"$work/tap"
    make -s TARGET="$1" BUILD="$build" "$build/$1/marches.elf" >&2 &&
        toolchain/emulate "$1" "$build/$1/marches.elf" >"$work/tap" || code=$?
    while read -r line; do
        case $line in
        ok\ *) outcome 0 "$1: ${line#*- }" ;;
        not\ ok\ *) outcome 1 "$1: ${line#*- }" ;;
        \#*) echo "$line" ;;
        esac
    done <"$work/tap"
    outcome $code "$1: marches ran to its end"
}

for target in cortex-m0 cortex-m3 cortex-m4 cortex-m55 rv32imc; do
    run $target
done
finish
