#!/bin/sh
# What conversions and mixtures link on a Cortex-M0: the logarithm and the powers of 2
# only where they are used. The bytes of all that is linked are printed beside.
set -eu
. tests/tap
build=${BUILD:-build}
library=$build/cortex-m0/libqvol.a
bytes=$build/cortex-m0/port/bytes.o

# links FUNCTION WANTED: "log", "exp", both or none.
links() {
    arm-none-eabi-ld --gc-sections -e "$1" -u "$1" "$library" "$bytes" \
        "$(arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb -print-libgcc-file-name)" -o "$work/linked"
    found=$(arm-none-eabi-nm "$work/linked" |
        sed -n 's/.* fx_depth_of_transmittance$/log/p; s/.* fx_transmittance$/exp/p' |
        sort -r | paste -s -d ' ' -)
    echo "# $1: $(arm-none-eabi-size "$work/linked" | awk 'NR == 2 { print $1 }') bytes"
    check "$1 links ${2:-neither log nor exp}" test "$found" = "$2"
}

make -s TARGET=cortex-m0 BUILD="$build" OPTIMISE=-Os "$library" "$bytes" >&2
links qv_mix ''
links qv_mixture_to_voxel ''
links qv_extinction_to_extinction ''
links qv_opacity_to_extinction log
links qv_extinction_of log
links qv_extinction_to_opacity exp
links qv_opacity_to_opacity 'log exp'
finish
