#!/bin/sh
# Sampling of associated colours in assembly beside the same in C, on the emulated devices that have
# it, with and without DSP instructions: random passages, bit by bit.
set -eu
. tests/tap
build=${BUILD:-build}

same() { # same TARGET
    make -s TARGET="$1" BUILD="$build" "$build/$1/passages.elf" &&
        toolchain/emulate "$1" "$build/$1/passages.elf" >"$work/said" &&
        grep '^#' "$work/said" && grep -q '^ok 1 ' "$work/said"
}

for target in cortex-m0 cortex-m3-mps2 cortex-m4; do
    check "$target: passages are what they are in C" same $target
done
finish
