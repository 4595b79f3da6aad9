#!/bin/sh
# A target is added by one file: the example of toolchain/TARGETS.md, in a copy of the tree, is
# built, run and counted.
set -eu
. tests/tap
: "${BUILD:=build}"

tree=$work/tree
file=$tree/toolchain/cortex-m0plus.mk
mkdir "$tree"
cp -r Makefile core fixedpoint port tests toolchain "$tree"
sed -n 's/^    //; /^# toolchain\/cortex-m0plus.mk/,/^include/p' toolchain/TARGETS.md >"$file"

is_listed() {
    make -s -C "$tree" print-DEVICES | tr ' ' '\n' | grep -x cortex-m0plus
}

run_new() {
    cd "$tree"
    export BUILD=build
    make -s TARGET=cortex-m0plus build/cortex-m0plus/functions.elf &&
        EMULATOR_REPORT=$work/regions toolchain/emulate cortex-m0plus \
            build/cortex-m0plus/functions.elf >"$work/new"
}

run_old() {
    top=$BUILD/devices-Os
    make -s TARGET=cortex-m0 BUILD="$top" "$top/cortex-m0/functions.elf" &&
        toolchain/emulate cortex-m0 "$top/cortex-m0/functions.elf" >"$work/old"
}

runs() { # the results of the Cortex-M0, with counts
    (run_new) && run_old && diff "$work/old" "$work/new" &&
        grep -q 'instructions [1-9]' "$work/regions"
}

check "example of toolchain/TARGETS.md: one file" grep -q '^TARGET_CPU' "$file"
check "example of toolchain/TARGETS.md: is a target" is_listed
check "example of toolchain/TARGETS.md: builds, runs and counts" runs
finish
