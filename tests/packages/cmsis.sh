#!/bin/sh
# The CMSIS-Pack: its description and its files, in a csolution project of its own.
set -eu
. tests/packages/common
export CMSIS_PACK_ROOT="$work/packs"

# The schema is ARM's and not packaged: PACK_XSD=FILE names a copy of it.
by_the_schema() {
    xmllint --noout ${PACK_XSD:+--schema "$PACK_XSD"} "$DIST/cmsis/qvol/qvol.qvol.pdsc"
}

check "the example draws here" expected
check "the description is XML${PACK_XSD:+ by PACK.xsd}" by_the_schema
check "port/README.md has lines for CMSIS-Pack" lines CMSIS-Pack
check "they build the example" follow
check "the firmware draws the picture" runs_on cortex-m0 "$site/ball/out/ball.elf"
check "the library is whole" holds_everything arm-none-eabi-nm "$site"/ball/out/*.o
finish
