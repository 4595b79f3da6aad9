#!/bin/sh
# What the smallest firmware takes on a Cortex-M0 (-Os, indexed8, weighted, RGB565
# alone): flash and RAM from the linker's map, stack from an emulated run.
#
#     tests/static/size.sh            checks the limits, in TAP
#     tests/static/size.sh --table    prints every function's share
#     tests/static/size.sh --readme   prints the figures as a Markdown table
set -eu
. tests/tap
build=${BUILD:-build}
out=$build/cortex-m0
plugin=$build/emulator/count.so

# Code and tables as measured before there were other modes: what is not named costs nothing.
ORTHOGRAPHIC_LIMIT=4042
PERSPECTIVE_LIMIT=4842
CONTEXT_LIMIT=256
STACK_LIMIT=512

# measure CAMERA: figures of one program as lines "NAME NUMBER" in $work/CAMERA.
measure() {
    toolchain/size_report "$out/size_$1.map" >"$work/$1"
    EMULATOR_OPTIONS="-plugin $plugin,out=$work/regions" \
        toolchain/emulate microbit "$out/size_$1.elf" >>"$work/$1"
    awk 'BEGIN { split("rotation camera init render", call) }
         { print "stack_" call[$2 + 1], $6 }' "$work/regions" >>"$work/$1"
}

figure() { # figure CAMERA NAME
    awk -v name="$2" '$1 == name { print $2 }' "$work/$1"
}

limit() { # limit CAMERA NAME MOST
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
}

readme() {
    echo "Bytes on a Cortex-M0 ($(arm-none-eabi-gcc --version | head -n 1), -Os), indexed8, weighted,"
    echo "RGB565 alone; compiler's helpers included:"
    echo
    echo "| camera | code and tables | .data, .bss | context | stack below qv_render |"
    echo "|---|---|---|---|---|"
    for camera in orthographic perspective; do
        echo "| $camera | $(figure $camera code) | $(figure $camera data), $(figure $camera bss) |" \
            "$(figure $camera context) | $(figure $camera stack_render) |"
    done
}

limits() {
    limit orthographic code $ORTHOGRAPHIC_LIMIT
    limit perspective code $PERSPECTIVE_LIMIT
    for camera in orthographic perspective; do
        limit $camera data 0
        limit $camera bss 0
        limit $camera context $CONTEXT_LIMIT
        for call in rotation camera init render; do
            limit $camera stack_$call $STACK_LIMIT
        done
    done
    finish
}

make -s TARGET=cortex-m0 BUILD="$build" OPTIMISE=-Os "$plugin" \
    "$out/size_orthographic.elf" "$out/size_perspective.elf" >&2
measure orthographic
measure perspective
case ${1:-} in
--table) table ;;
--readme) readme ;;
*) limits ;;
esac
