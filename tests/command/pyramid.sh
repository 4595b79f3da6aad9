#!/bin/sh
# Levels of detail: made in memory and written by `qvol pyramid`, raw and as C arrays.
. tests/command/common
cd "$work" || exit 1
"$PYTHON" - <<'PY'
from volumes import *
write("in_12x10x8_uint8.raw", packed(blob()))
write("slab_16x16x16_uint8.raw", packed([200] * 4096))
write("wall_16x16x16_uint8.raw", packed([255 if y == 6 else 0 for z in range(16) for y in range(16) for x in range(16)]))
write("one_1x1x1_uint8.raw", b"\xc8")
write("big_48x48x48_uint8.raw", packed(blob((48, 48, 48))))
write("even.tf", b"0 250 120 60 0\n199 250 120 60 0\n200 250 120 60 0.06\n255 250 120 60 0.06\n")
write("solid.tf", b"0 255 255 255 0\n254 255 255 255 0\n255 255 255 255 1\n")
PY
IN=in_12x10x8_uint8.raw
VIEW="--size 40x30 --azimuth 20 --elevation 10"
DIMS="--dims 12x10x8"

draw() { # draw OUT IN OPTION...
    out=$1 in=$2
    shift 2
    rm -f "$out"
    # shellcheck disable=SC2086
    "$QVOL" render "$in" -o "$out" $VIEW "$@"
}
read_again() { # the options with which the report says that the file is read
    "$PYTHON" -c 'import json, shlex, sys; print(shlex.join(json.load(open(sys.argv[1]))["read"]))' "$1"
}

# What a level holds, against real arithmetic.
cat >levels.py <<'END'
"""levels.py FILE REPORT: each level is the filtered one before."""
import json, math, struct, sys
data, report = open(sys.argv[1], "rb").read(), json.load(open(sys.argv[2]))
taps = {"box2": (0, 32, 32, 0), "box4": (16, 16, 16, 16), "quad4": (13, 19, 19, 13)}[report["pyramid"]["filter"]]
domain = report["pyramid"]["domain"]
stored = domain == "opacity" or report["volume"]["storage"].startswith("rgbt")
wide = report["volume"]["storage"].endswith("16")
full, form = (65535, "H") if wide else (255, "B")

def level(offset, size):
    voxels = math.prod(size)
    values = struct.unpack(f"<{4 * voxels}{form}", data[offset:offset + 4 * voxels * (1 + wide)])
    return {(i % size[0], i // size[0] % size[1], i // size[0] // size[1]): values[4 * i:4 * i + 4] for i in range(voxels)}

def weight(a):
    return a if stored or a == 0 else -math.log2(1 - a / full) if a < full else 64

def channel(w):
    return w if stored else full * (1 - 2.0 ** -w)

def mirrored(i, n):
    while not 0 <= i < n:
        i = -1 - i if i < 0 else 2 * n - 1 - i
    return i

finer, size, end = level(0, report["volume"]["size"]), report["volume"]["size"], report["volume"]["bytes"]
worst = 0
for entry in report["pyramid"]["levels"]:
    coarser = level(entry["offset"], entry["size"])
    assert entry["size"] == [(n + 1) // 2 for n in size] and entry["offset"] == end
    for (x, y, z), voxel in coarser.items():
        sums = [0] * 4
        for k, wz in enumerate(taps):
            for j, wy in enumerate(taps):
                for i, wx in enumerate(taps):
                    at = tuple(mirrored(2 * c + t - 1, n) for c, t, n in zip((x, y, z), (i, j, k), size))
                    rgba = finer[at]
                    w = weight(rgba[3]) * wx * wy * wz
                    sums = [s + w * c for s, c in zip(sums, (*rgba[:3], 1))]
        exact = [s / sums[3] if sums[3] else 0 for s in sums[:3]] + [channel(sums[3] / 64 ** 3)]
        worst = max([worst] + [abs(e - v) for e, v in zip(exact, voxel)])
    finer, size, end = coarser, entry["size"], end + entry["bytes"]
assert size == [1, 1, 1] and end == len(data) == report["output"]["bytes"]
print("# worst", worst)
assert worst <= (.505 if stored else .6)
END
made() { # made FILTER DOMAIN OPTION...
    filter=$1 domain=$2
    shift 2
    "$QVOL" pyramid $IN -o levels.bin --tf surface --filter "$filter" --domain "$domain" --json=levels.json "$@"
    check "levels: $filter, $domain $*" "$PYTHON" levels.py levels.bin levels.json
}
for filter in box2 box4 quad4; do
    made $filter extinction
    made $filter opacity
done
made box4 extinction --storage rgba8
made quad4 extinction --storage rgbt16
made box2 extinction --storage rgbt8

# The file draws what the levels made in memory draw.
round_trip() { # round_trip LEVEL MODE MAKE-OPTION...
    level=$1 mode=$2
    shift 2
    rm -f p.bin* a.pam b.pam
    "$QVOL" pyramid $IN -o p.bin --tf surface --spacing 1x1x2 --json=p.json "$@"
    eval "draw a.pam p.bin --level $level --sampling $mode $(read_again p.json)"
    # shellcheck disable=SC2046
    draw b.pam $IN --tf surface --spacing 1x1x2 --level "$level" --sampling "$mode" \
        $(echo "$*" | sed 's/--endian [a-z]*//')
    check "level $level, $mode, from a file: $*" cmp a.pam b.pam
}
for level in 0 1 1.5 4 auto; do
    round_trip $level weighted
done
round_trip 1.5 extinction --storage rgba8
round_trip 1.5 extinction --storage rgbt16 --endian big
round_trip 1.5 extinction --storage rgbt8 --extinction 20
round_trip 1 bspline-extinction --filter quad4
round_trip 2 bspline-weighted --filter box2 --domain opacity --unit-distance 2
round_trip 1.5 weighted --storage indexed8
round_trip 1.5 weighted --storage indexed8 --palette-bits 16 --endian big
round_trip 2.5 extinction --storage indexed8 --palette-bits 16 --extinction auto --endian big
"$QVOL" pyramid $IN -o p.bin --tf surface
# shellcheck disable=SC2086
draw a.pam p.bin $DIMS --type rgba16le
draw b.pam $IN --tf surface
check "without --level the file is its volume" cmp a.pam b.pam
# shellcheck disable=SC2002,SC2086
cat p.bin | "$QVOL" render - $DIMS --type rgba16le --level 1 -o a.pam --size 8x8
# shellcheck disable=SC2086
"$QVOL" render p.bin $DIMS --type rgba16le --level 1 -o b.pam --size 8x8
check "levels from a pipe" cmp a.pam b.pam
check "info tells of levels" sh -c \
    '"$1" info p.bin --dims 12x10x8 --type rgba16le | grep -q "^levels  *1144 bytes"' - "$QVOL"
tail -c +8641 p.bin >level2.bin
draw a.pam p.bin --skip 8640 --dims 3x3x2 --type rgba16le
draw b.pam level2.bin --dims 3x3x2 --type rgba16le
check "a level alone, by its offset and size" cmp a.pam b.pam
"$QVOL" pyramid level2.bin --dims 3x3x2 --type rgba16le -o again.bin
check "levels of a level are the pyramid's" cmp level2.bin again.bin
"$QVOL" pyramid $IN -o one.bin --tf surface --threads 1
check "--threads changes no byte" cmp p.bin one.bin
"$QVOL" pyramid $IN -o - --tf surface >stdout.bin
check "standard output" cmp p.bin stdout.bin

# Each option of `render` changes the picture, or is the default.
draw base.pam $IN --tf surface --level 1
changes() {
    draw new.pam $IN --tf surface --level 1 "$@" || echo "# failed: $*" >&2
    differs "level 1: changes the picture: $*" base.pam new.pam
}
same() {
    draw new.pam $IN --tf surface --level 1 "$@"
    check "level 1: changes no byte: $*" cmp base.pam new.pam
}
changes --level 1.25
changes --level 0
changes --filter box2
same --filter box4
changes --filter quad4
changes --domain opacity
same --domain extinction
same --sampling weighted
changes --sampling extinction
changes --sampling bspline-weighted
same --threads 1
draw a.pam $IN --tf surface --level 1 --sampling bspline-extinction
draw b.pam $IN --tf surface --level 1 --sampling bspline-extinction --filter quad4
check "quad4 is the default of B-splines" cmp a.pam b.pam
draw a.pam $IN --tf surface
draw b.pam $IN --tf surface --level 0
check "level 0 is the volume" "$QVOL" compare -q a.pam b.pam --tolerance 1

# Every level of a homogeneous slab is the same picture; a thin wall stays opaque.
for mode in weighted extinction bspline-weighted bspline-extinction; do
    draw base.pam slab_16x16x16_uint8.raw --tf ./even.tf --sampling $mode --unit-distance 1
    for level in 0 0.5 1 2 3.75 4; do
        draw a.pam slab_16x16x16_uint8.raw --tf ./even.tf --sampling $mode --unit-distance 1 --level $level
        check "slab, $mode, level $level" "$QVOL" compare -q base.pam a.pam --tolerance 1
    done
done
brightest() { # brightest DOMAIN: of the wall on level 3
    "$QVOL" render wall_16x16x16_uint8.raw -o - --as raw --size 24x24 --format l8 --tf ./solid.tf --level 3 \
        --sampling extinction --unit-distance 1 --domain "$1" | od -An -v -tu1 | tr -s ' ' '\n' | sort -n | tail -n 1
}
check "the wall is opaque on level 3: $(brightest extinction)" test "$(brightest extinction)" -ge 252
check "but not in a pyramid of opacity: $(brightest opacity)" test "$(brightest opacity)" -le 200

# auto: as wide as a pixel.
"$QVOL" render big_48x48x48_uint8.raw -o a.pam --size 12x12 --tf surface --level auto --json=a.json
"$QVOL" render big_48x48x48_uint8.raw -o b.pam --size 12x12 --tf surface --level auto --perspective 30 --json=b.json
check "--level auto follows the pixel" "$PYTHON" -c '
import json, math
a, b = (json.load(open(n)) for n in ("a.json", "b.json"))
level = 256 * math.log2(a["camera"]["view"]["pitch_q16"] / 65536)
assert abs(a["sampling"]["level_q8"] - level) < 1 and a["sampling"]["level_distance"] == 0, level
assert b["sampling"]["level_q8"] == 0 and b["sampling"]["level_distance"] > 0
assert len(a["pyramid"]["levels"]) == 6 and a["pyramid"]["filter"] == "box4" and a["sampling"]["by_length"]
assert a["pyramid"]["levels"][2] == {"level": 3, "storage": "rgba16", "size": [6, 6, 6],
    "spacing": [8, 8, 8], "offset": 8 * (24**3 + 12**3), "bytes": 8 * 6**3}'

# C arrays.
cat >main.c <<'END'
#include <stdio.h>
#ifdef VOLUME_HEADER
#include VOLUME_HEADER
#else
#include "qvol.h"
extern const qv_volume p_volume;
extern const qv_pyramid p_pyramid;
#endif
int main(void)
{
    qv_volume last;
    if (qv_pyramid_level(&last, &p_volume, &p_pyramid, p_pyramid.levels) != QV_OK || last.size[0] != 1)
        return 1;
    fwrite(p_volume.voxels, 1, (size_t)p_volume.voxels_bytes, stdout);
    fwrite(p_pyramid.voxels, 1, (size_t)p_pyramid.bytes, stdout);
    if (p_volume.palette_bytes > 0)
        fwrite(p_volume.palette, 1, p_volume.palette_bytes, stdout);
    return 0;
}
END
SOURCES="$TESTS/../../core $TESTS/../../fixedpoint"
STRICT="-std=c99 -pedantic -Wall -Wextra -Werror -Wconversion -Wcast-qual -Wno-unused-const-variable"
for folder in $SOURCES; do
    FLAGS="${FLAGS:-} -I$folder"
done
# shellcheck disable=SC2086
check "the library compiles" "$CC" -std=c99 -c $FLAGS "$TESTS"/../../core/*.c "$TESTS"/../../fixedpoint/*.c
array() { # array ENDING OPTION...
    ending=$1
    shift
    rm -f p.* program
    "$QVOL" pyramid $IN -o p.$ending "$@"
    "$QVOL" pyramid $IN -o p.bin "$@"
    if [ "$ending" = h ]; then
        extra="-DVOLUME_HEADER=\"p.h\""
    else
        extra=p.c
    fi
    # shellcheck disable=SC2086
    check "C arrays, .$ending $*: compile" "$CC" $STRICT $FLAGS -I. main.c $extra ./*.o -o program
    ./program >held
    [ ! -e p.bin.palette ] || cat p.bin.palette >>p.bin
    check "C arrays, .$ending $*: hold the raw file's bytes" cmp held p.bin
}
array c
array h --storage rgba8 --filter quad4
array c --storage indexed8 --palette-bits 16
array h --storage indexed8 --extinction auto
array c --storage rgbt16
check "the comment tells levels, filter and domain" \
    grep -q "levels  *1 to 4, filter box4, domain extinction" p.c

# What is refused. Files that lie about their levels are among those of bad_input.
refuses "beyond the last level" 2 ": --level: 4.5 is beyond the last level, 4" \
    "$QVOL" render $IN -o a.pam --level 4.5
refuses "levels of one voxel" 1 "one_1x1x1_uint8.raw: levels: a single voxel" \
    "$QVOL" pyramid one_1x1x1_uint8.raw -o a.bin
refuses "opacity of extinction" 2 ": --domain: the volume holds extinction" \
    "$QVOL" pyramid $IN -o a.bin --storage rgbt8 --domain opacity
"$QVOL" pyramid $IN -o p.bin --tf surface
READ="$DIMS --type rgba16le -o a.pam --size 8x8"
# shellcheck disable=SC2086
refuses "another filter" 2 ": --filter: the input has its levels" \
    "$QVOL" render p.bin $READ --level 1 --filter box2
# shellcheck disable=SC2086
refuses "another domain" 2 ": --domain: the input has its levels" \
    "$QVOL" render p.bin $READ --level 1 --domain opacity
head -c 8640 p.bin >short.bin
# shellcheck disable=SC2086
check "fewer levels will do" "$QVOL" render short.bin $READ --level 1
# shellcheck disable=SC2086
refuses "fewer levels than --level" 2 "beyond the last level, 1" "$QVOL" render short.bin $READ --level 2
refuses "report and levels in one file" 2 ": --json: report and voxels cannot both" \
    "$QVOL" pyramid $IN -o - --json
refuses "palette without a file" 2 "needs a file beside" "$QVOL" pyramid $IN -o - --storage indexed8
refuses "no output of pyramid" 2 "missing" "$QVOL" pyramid $IN
check "no file is left" sh -c '! ls | grep -e "\.tmp$"'
finish
