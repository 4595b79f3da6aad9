#!/bin/sh
# The form of the wide product for machines without one, here: unit tests and golden
# scenes give the same bits.
set -u
unset MAKEFLAGS MFLAGS MAKELEVEL # of a make that runs this script
log=$(mktemp)
trap 'rm -f "$log"' EXIT
if make -s BUILD="${BUILD:-build}/narrow" CFLAGS=-DFX_NARROW=1 check >"$log" 2>&1; then
    echo "ok - unit tests and golden scenes with narrow products: $(tail -n 1 "$log")"
else
    awk '/not ok|error|failed/ { print "# " $0 }' "$log"
    echo "not ok - unit tests and golden scenes with narrow products"
    exit 1
fi
