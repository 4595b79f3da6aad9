#!/bin/sh
# qvol render --cache: the bytes of voxels in memory, and how many are read.
. tests/command/common

cd "$work" || exit 1
"$PYTHON" -c '
import struct
with open("ball.raw", "wb") as f:
    for z in range(20):
        for y in range(18):
            for x in range(16):
                d = (x - 8) ** 2 + (y - 9) ** 2 + (z - 10) ** 2
                f.write(struct.pack("B", max(0, 255 - 3 * d)))'
VIEW="--dims 16x18x20 --type u8 --quiet --size 40x40 --azimuth 30 --elevation 20"

# shellcheck disable=SC2086
same() { # same NAME OPTIONS: as without a cache
    "$QVOL" render ball.raw $VIEW $2 -o memory.pam &&
        "$QVOL" render ball.raw $VIEW $2 $3 -o pages.pam --json=report.json
    cmp -s memory.pam pages.pam
    outcome $? "$1, $3: the same bytes"
}

number() { # number NAME: of the report of the last picture
    "$PYTHON" -c 'import json, sys; print(json.load(open("report.json"))["pages"][sys.argv[1]])' "$1"
}

for cache in "--cache 8" "--cache 40 --page 4x2x8" "--cache 3 --page 4096x4096x1" \
    "--cache 1 --page 32x32x32"; do
    same "nearest" "--sampling nearest --storage rgba8" "$cache"
    same "weighted" "--storage indexed8" "$cache"
    same "separate from the back" "--sampling separate --order back-to-front" "$cache"
    same "corrected" "--unit-distance 2" "$cache"
    same "extinction" "--sampling extinction --unit-distance 1" "$cache"
    same "stored extinction" "--storage rgbt16" "$cache"
    same "B-spline" "--sampling bspline-extinction --unit-distance 1" "$cache"
    same "slices" "--compositing slices" "$cache"
done

same "one page" "--storage indexed8" "--cache 1 --page 4096x4096x4096"
[ "$(number reads)" = 1 ] && [ "$(number file_reads)" = 1 ] && [ "$(number file_bytes)" = 5760 ]
outcome $? "one page is read once, all at once"
same "few pages" "--storage indexed8" "--cache 8 --page 4x4x4"
few=$(number reads)
same "many pages" "--storage indexed8" "--cache 100 --page 4x4x4"
many=$(number reads)
echo "# reads through 8 pages: $few, through 100: $many" >&2
[ "$few" -gt "$many" ] && [ "$many" -ge 50 ]
outcome $? "fewer pages are read more often"

refuses "a page without a cache" 2 "needs --cache" "$QVOL" render ball.raw $VIEW -o a.pam --page 8x8x8
refuses "widths that are no powers of 2" 2 "power of 2" "$QVOL" render ball.raw $VIEW -o a.pam --cache 8 \
    --page 6x8x8
refuses "fewer pages than a sample needs" 2 "7 pages are fewer" "$QVOL" render ball.raw $VIEW -o a.pam \
    --cache 7
refuses "pages and levels" 2 "needs voxels" "$QVOL" render ball.raw $VIEW -o a.pam --cache 8 --level 1
finish
