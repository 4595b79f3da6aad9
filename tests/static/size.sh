#!/bin/sh
# What the smallest firmware takes on a Cortex-M0 (-Os, indexed8, RGB565 alone; weighted by rays
# of either camera, or splats): flash and RAM from the linker's map, stack from an emulated run.
#
#     tests/static/size.sh            checks the limits, in TAP
#     tests/static/size.sh --table    prints every function's share
#     tests/static/size.sh --readme   prints the figures as a Markdown table
set -eu
. tests/tap
build=${BUILD:-build}
out=$build/cortex-m0

# Code and tables as measured before there were other modes: what is not named costs nothing, but
# for the 16 bytes by which qv_render tells of voxels that could not be read, and those that the
# test of the first corner takes.
ORTHOGRAPHIC_LIMIT=4096
PERSPECTIVE_LIMIT=4842
CONTEXT_LIMIT=256
STACK_LIMIT=512
SPLATS_LIMIT=14592
SPLATS_CONTEXT_LIMIT=576

RAYS_CALLS="rotation camera init render"
SPLATS_CALLS="splat_init splat_block read_out"

# measure PROGRAM CALLS: its figures as lines "NAME NUMBER" in $work/PROGRAM.
measure() {
    toolchain/size_report "$out/size_$1.map" >"$work/$1"
    EMULATOR_REPORT=$work/regions toolchain/emulate cortex-m0 "$out/size_$1.elf" >>"$work/$1"
    awk -v calls="$2" 'BEGIN { split(calls, call) }
         { print "stack_" call[$2 + 1], $6 }' "$work/regions" >>"$work/$1"
}

figure() { # figure PROGRAM NAME
    awk -v name="$2" '$1 == name { print $2 }' "$work/$1"
}

limit() { # limit PROGRAM NAME MOST
    value=$(figure "$1" "$2")
    status=0
    { [ -n "$value" ] && [ "$value" -le "$3" ]; } || status=1
    outcome $status "$1 $2: ${value:-unknown} of $3 bytes"
}

table() {
    for camera in orthographic perspective; do
        echo "Cortex-M0 -Os, indexed8, weighted, RGB565, $camera, in bytes"
        cat "$work/$camera"
        echo
    done
    echo "Cortex-M0 -Os, indexed8, splats, orthographic between directions, RGB565, in bytes"
    cat "$work/splats"
}

readme() {
    echo "Bytes on a Cortex-M0 ($(arm-none-eabi-gcc --version | head -n 1), -Os), indexed8, RGB565"
    echo "alone; compiler's helpers included. Stack below \`qv_render\` or \`qv_splat_block\`:"
    echo
    echo "| program | code and tables | .data, .bss | context | stack |"
    echo "|---|---|---|---|---|"
    readme_row orthographic "weighted, orthographic" stack_render
    readme_row perspective "weighted, perspective" stack_render
    readme_row splats "splats (\`qv_splat_init\`: $(figure splats stack_splat_init) of stack)" \
        stack_splat_block
}

readme_row() { # readme_row PROGRAM TITLE STACK
    echo "| $2 | $(figure "$1" code) | $(figure "$1" data), $(figure "$1" bss) |" \
        "$(figure "$1" context) | $(figure "$1" "$3") |"
}

limits() {
    limit orthographic code $ORTHOGRAPHIC_LIMIT
    limit perspective code $PERSPECTIVE_LIMIT
    for camera in orthographic perspective; do
        limit $camera data 0
        limit $camera bss 0
        limit $camera context $CONTEXT_LIMIT
        for call in $RAYS_CALLS; do
            limit $camera stack_$call $STACK_LIMIT
        done
    done
    limit splats code $SPLATS_LIMIT
    limit splats data 0
    limit splats bss 0
    limit splats context $SPLATS_CONTEXT_LIMIT
    for call in $SPLATS_CALLS; do
        limit splats stack_$call $STACK_LIMIT
    done
    finish
}

make -s TARGET=cortex-m0 BUILD="$build" OPTIMISE=-Os \
    "$out/size_orthographic.elf" "$out/size_perspective.elf" "$out/size_splats.elf" >&2
measure orthographic "$RAYS_CALLS"
measure perspective "$RAYS_CALLS"
measure splats "$SPLATS_CALLS"
case ${1:-} in
--table) table ;;
--readme) readme ;;
*) limits ;;
esac
