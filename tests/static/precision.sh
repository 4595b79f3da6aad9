#!/bin/sh
# The precision report is what its programs write, byte for byte; no measured error is above its
# bound, and no bound is much above what was measured unless a reason stands beside it.
set -u
. tests/tap
BUILD=${BUILD:-build}
PRECISION_OUT=$work/precision
export BUILD PRECISION_OUT

sections=$(make -s print-PRECISION_SECTIONS)
check "the programs are built" make -s BUILD="$BUILD" precision-programs
# shellcheck disable=SC2086 # several sections
check "the report is written" tests/precision/precision.sh $sections
check "it is the committed one" diff -u tests/precision/REPORT.md "$PRECISION_OUT/REPORT.md"

# Every CSV whose head names bound and worst: numbers, before any text that may hold a comma.
# within says how many times the worst the bound may be; reason why it is more all the same.
bounds_hold() {
    awk -F, '
        FNR == 1 { delete at; for (i = 1; i <= NF; i++) at[$i] = i; next }
        !("bound" in at && "worst" in at) { next }
        { rows++; bound = $at["bound"]; worst = $at["worst"] }
        !(worst <= bound) { print FILENAME ": above its bound: " $0; bad = 1 }
        "within" in at && $at["reason"] == 0 && !(bound <= $at["within"] * worst) {
            print FILENAME ": bound too wide: " $0; bad = 1
        }
        END { print rows + 0, "rows"; exit bad || rows < 1 }' "$@"
}
check "no error is above its bound" bounds_hold "$PRECISION_OUT"/*.csv

# What a section must reach: lines "- reached: what" or "- MISSED: what".
sed -nE 's,^- (reached|MISSED): ,,p' "$PRECISION_OUT/REPORT.md" >"$work/goals"
check "goals are named" test -s "$work/goals"
while read -r goal; do
    check "reached: $goal" grep -qxF -e "- reached: $goal" "$PRECISION_OUT/REPORT.md"
done <"$work/goals"

plots_hold() {
    /usr/bin/python3 -c '
import sys
from PIL import Image
for name in sys.argv[1:]:
    low, high = Image.open(name).convert("L").getextrema()
    print(name, low, high)
    assert high > low
' "$@"
}
check "the plots are drawn" plots_hold "$PRECISION_OUT"/*.png
finish
