#!/bin/sh
# Writes the figures of README.md between their markers: sizes, speeds, costs of blends
# and of FreeVoxels, and what to choose.
set -eu
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# replace NAME: what stands between <!-- NAME --> and <!-- /NAME --> by the file NAME.
replace() {
    awk -v name="$1" -v file="$work/$1" '
        $0 == "<!-- /" name " -->" { inside = 0 }
        !inside { print }
        $0 == "<!-- " name " -->" { inside = 1; while ((getline line < file) > 0) print line }
    ' README.md >"$work/README.md"
    cp "$work/README.md" README.md
}

make -s size-lines >"$work/lines"
tests/size/sizes.sh readme <"$work/lines" >"$work/sizes"
tests/bench/bench.sh >"$work/speeds"
tests/bench/blends.sh >"$work/blends"
tests/bench/freevoxels.sh >"$work/freevoxels"
tests/bench/choose.sh >"$work/choices"
cc=${CC:-cc}
$cc -std=c99 -Icore tests/bench/recommendations.c "${BUILD:-build}/host/libqvol.a" -o "$work/ask"
"$work/ask" >"$work/recommendations"
replace recommendations
replace sizes
replace speeds
replace blends
replace freevoxels
replace choices
