#!/bin/sh
# The form of the wide product for machines without one, here: unit tests and golden
# scenes give the same bits.
set -u
. tests/tap
check "unit tests and golden scenes with narrow products" \
    make -s BUILD="${BUILD:-build}/narrow" CFLAGS=-DFX_NARROW=1 check
finish
