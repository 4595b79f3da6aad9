#!/bin/sh
# precision.sh SECTION...: runs the program of each section in this order and puts together
# PRECISION_OUT/REPORT.md; tables as CSV and plots as PNG lie beside it. A program is given the
# folder: it writes its CSV there and prints its section, in Markdown; it may be a script,
# tests/precision/SECTION/section.sh. A section's plots are drawn by tests/precision/SECTION/*.gp.
set -eu
cd "$(dirname "$0")/../.."
: "${BUILD:=build}"
OUT=${PRECISION_OUT:-$BUILD/precision}
SOURCES=tests/precision

section() { # section NAME
    program=$SOURCES/$1/section.sh
    [ -e "$program" ] || program=$BUILD/tests/precision/$1
    "$program" "$OUT" >"$OUT/$1.md"
    for plot in "$SOURCES/$1"/*.gp; do
        [ ! -e "$plot" ] || gnuplot -c "$plot" "$OUT"
    done
}

mkdir -p "$OUT"
for name in "$@"; do
    section "$name"
done
{
    cat "$SOURCES/preface.md"
    for name in "$@"; do
        echo
        cat "$OUT/$name.md"
    done
} >"$OUT/REPORT.md"
echo "Wrote to $OUT:"
(cd "$OUT" && find . -maxdepth 1 -type f | sort | sed 's/^/  /')
