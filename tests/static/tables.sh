#!/bin/sh
# The tables of fixedpoint are what their generator writes, byte for byte, and
# take at most 1.5 KB beside the optional one for 8-bit opacities, at most 1 KB. A
# program links those that what it names reads, and no other.
set -eu
. tests/tap
: "${BUILD:=build}"
LIMIT=1536
LIMIT8=1024

bytes() { # what the arrays of the generated headers on standard input take
    awk '/^FX_TABLE uint/ { wide = $2 == "uint32_t" ? 4 : 2; split($3, part, /[][]/); sum += wide * part[2] }
         END { print sum + 0 }'
}

make -s BUILD="$BUILD" "$BUILD/tests/tables/tables" >&2
"$BUILD/tests/tables/tables" "$work"
for file in "$work"/*.h; do
    name=fixedpoint/$(basename "$file")
    status=0
    cmp -s "$file" "$name" || status=1
    outcome $status "$name is what the generator writes"
done
[ "$number" -eq "$(find fixedpoint -name 'fx_*_table.h' | wc -l)" ] || {
    outcome 1 "every table has its generator"
}

total=$(find fixedpoint -name 'fx_*_table.h' ! -name '*8_table.h' -exec cat {} + | bytes)
total8=$(cat fixedpoint/fx_*8_table.h | bytes)
status=0
{ [ "$total" -gt 0 ] && [ "$total" -le $LIMIT ]; } || status=1
outcome $status "tables: $total of $LIMIT bytes"
status=0
{ [ "$total8" -gt 0 ] && [ "$total8" -le $LIMIT8 ]; } || status=1
outcome $status "table of 8-bit opacities: $total8 of $LIMIT8 bytes"

links() { # links NAME [TABLE]...: the tables in a program for a Cortex-M0 that names NAME
    name=$1
    shift
    arm-none-eabi-gcc -mcpu=cortex-m0 -mthumb -nostdlib -r -Wl,--gc-sections,-e,"$name",-u,"$name" \
        "$BUILD/cortex-m0/libqvol.a" -lgcc -o "$work/linked" || return 1
    found=$(arm-none-eabi-nm "$work/linked" | sed -n 's/^[0-9a-f]* [rR] \([a-z0-9]*\)_.*/\1/p' |
        grep -x -e exp -e log -e log8 -e phi | sort -u | xargs)
    echo "$name: '$found', wanted '$*'"
    [ "$found" = "$*" ] && arm-none-eabi-nm "$work/linked" | grep -q " $name\$"
}

make -s TARGET=cortex-m0 BUILD="$BUILD" lib >&2
while read -r name tables; do
    # shellcheck disable=SC2086 # several tables
    check "$name links ${tables:-no table}" links "$name" $tables
done <<'NAMES'
qv_weighted_rgba8
qv_corrected_rgba8 exp log phi
qv_extinction_rgbt8 exp phi
qv_extinction_rgbt16_levels exp phi
qv_extinction_rgba8 exp log8 phi
qv_extinction_rgba16 exp log phi
qv_bspline_weighted_rgba16 exp log phi
qv_bspline_extinction_rgbt16 exp phi
qv_downsample
qv_domain_stored
qv_domain_extinction exp log
qv_opacity_to_extinction log
qv_extinction_to_opacity exp
NAMES
finish
