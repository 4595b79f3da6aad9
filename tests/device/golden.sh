#!/bin/sh
# The golden scenes on every target: each gives the checksum of golden.h, whole, in strips and in
# whatever ways else its runner takes. Prints a matrix of kinds of scenes by targets. The levels of
# optimisation are those of TARGET_LEVELS in toolchain/TARGET.mk.
#
#     tests/device/golden.sh                          all targets
#     tests/device/golden.sh TARGET LEVEL FOLDER      what one says, into FOLDER/TARGET.LEVEL
#
#     GOLDEN_TARGETS    these targets alone
#     GOLDEN_LEVELS     these levels instead of each target's own, such as "-O0 -O3"
set -eu
: "${BUILD:=build}" "${EMULATOR_SECONDS:=900}"
export BUILD EMULATOR_SECONDS
unset MAKEFLAGS MFLAGS MAKELEVEL # of a make that runs the script

# A program for each set of scenes. What fails ends before the last line, "end".
run() { # run TARGET LEVEL
    top=$BUILD/devices$2
    make -s TARGET="$1" OPTIMISE="$2" BUILD="$top" golden
    for set in $(make -s TARGET="$1" print-TARGET_GOLDEN); do
        toolchain/emulate "$1" "$top/$1/golden_$set.elf"
    done
    echo end
}

# Lines "TARGET LEVEL". Emulators are built here, before several runs use them.
list_runs() {
    for target in ${GOLDEN_TARGETS:-$(make -s print-DEVICES)}; do
        [ -n "$(make -s TARGET="$target" print-TARGET_GOLDEN)" ] || continue
        make -s TARGET="$target" BUILD="$BUILD" emulator >/dev/null
        for level in ${GOLDEN_LEVELS:-$(make -s TARGET="$target" print-TARGET_LEVELS)}; do
            echo "$target $level"
        done
    done
}

if [ $# -eq 3 ]; then
    run "$1" "$2" >"$3/$1.$2" 2>&1
    exit
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
trap 'exit 1' INT TERM
list_runs >"$work/runs"
mkdir "$work/said"
# A run that fails has not said "end".
xargs -P "$(getconf _NPROCESSORS_ONLN)" -I{} sh -c "sh '$0' {} '$work/said'" <"$work/runs" || true
/usr/bin/python3 tests/device/golden_matrix.py tests/golden/golden.h "$work/said" "$work/runs"
