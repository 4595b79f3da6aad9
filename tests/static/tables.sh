#!/bin/sh
# The tables of fixedpoint are what their generator writes, byte for byte, and
# take at most 1.5 KB beside the optional one for 8-bit opacities, at most 1 KB.
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
finish
