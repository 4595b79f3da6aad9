#!/bin/sh
# Slices in frame buffers of few bits: against rays, against the paper's figures, and what
# each option does.
. tests/command/common
cd "$work" || exit 1
"$PYTHON" - <<'PY'
from volumes import *
size = 24, 20, 16
write("in_24x20x16_uint8.raw", packed(blob(size)))
for depth in 100, 200:
    write(f"fog_4x{depth}x4_uint8.raw", packed([255] * 16 * depth))
write("slab_16x16x16_uint8.raw", packed([255] * 4096))
write("one.tf", b"0 255 255 255 0.00392156863\n")
write("thin.tf", b"0 255 255 255 0.0015686\n")
write("bands.tf", b"0 255 0 0 0\n60 255 0 0 .1\n120 0 255 0 .4\n180 0 0 255 .2\n")
write("empty.tf", b"0 255 255 255 0\n")
write("rgba_24x20x16.raw", bytes(v // 3 for v in blob(size) for _ in range(4)))
PY
IN=in_24x20x16_uint8.raw
VIEW="--size 70x50 --azimuth 25 --elevation 15 --tf fog"

draw() { # draw OUT OPTION...
    out=$1
    shift
    rm -f "$out"
    # shellcheck disable=SC2086
    "$QVOL" render $IN -o "$out" $VIEW "$@" || echo "# failed: $*" >&2
}
slices() { # slices OUT OPTION...
    out=$1
    shift
    draw "$out" --compositing slices "$@"
}
alike() { # alike NAME A B [LEVELS]: the pictures differ by at most so much
    check "$1" "$QVOL" compare -q "$2" "$3" --tolerance "${4:-1}"
}
cat >mostly.py <<'PY'
"""mostly.py A B: less than 1 % of the bytes differ by more than 1, and there is something."""
import sys
a, b = (open(name, "rb").read() for name in sys.argv[1:])
far = sum(abs(x - y) > 1 for x, y in zip(a, b))
sys.exit(len(a) != len(b) or far * 100 > len(a) or max(a[len(a) // 2:]) < 12)
PY
mostly() { # mostly NAME A B
    check "$1" "$PYTHON" mostly.py "$2" "$3"
}

# Wide frame buffers show what rays show, in every mode.
for mode in nearest separate weighted extinction bspline-weighted bspline-extinction; do
    draw rays.pam --sampling $mode --termination 0
    slices a.pam --sampling $mode --framebuffer 24
    alike "24 bits, $mode" rays.pam a.pam
done
for options in "--perspective 40" "--background 405060" "--background 4050ff --tf bone" "--storage rgbt16" \
    "--storage indexed8" "--step 0.5 --phase 0.3" "--unit-distance 2" "--level 1.5" "--perspective 50 --level auto"; do
    # shellcheck disable=SC2086
    draw rays.pam $options --termination 0
    for bits in 16 24; do
        # shellcheck disable=SC2086
        slices a.pam $options --framebuffer $bits
        alike "$bits bits, $options" rays.pam a.pam
        # shellcheck disable=SC2086
        slices a.pam $options --framebuffer $bits --order front-to-back
        alike "$bits bits front to back, $options" rays.pam a.pam
    done
done
for share in 0.5 0.75; do
    draw rays.pam --tf bone --termination $share
    for bits in 16 24; do
        slices a.pam --tf bone --framebuffer $bits --order front-to-back --termination $share
        alike "$bits bits, pixels end where rays end: $share" rays.pam a.pam
    done
done
draw rays.pam --termination 0
for options in "--dither feedback" "--framebuffer 12" "--dither feedback --residual 4" "--framebuffer 16 --dither none"; do
    # shellcheck disable=SC2086
    slices a.pam $options
    alike "$options" rays.pam a.pam 2
done
slices a.pam
alike "8 bits, dithered rounding" rays.pam a.pam 6
draw rays.pam --termination 0 --unit-distance 1
slices a.pam --slices 100 --dither none
"$QVOL" compare -q rays.pam a.pam --tolerance 12
check "8 bits without dither are worse" test $? -eq 1
draw rays.raw --background transparent --as raw --termination 0
for bits in 12 16 24; do
    slices a.raw --background transparent --as raw --framebuffer $bits
    mostly "$bits bits over nothing" rays.raw a.raw
done
slices a.raw --background transparent --as raw --framebuffer 16 --order front-to-back
mostly "front to back over nothing" rays.raw a.raw
for format in rgb565be grey4 mono-horizontal mono-vertical; do
    draw rays.pam --format $format --termination 0
    slices a.pam --format $format --framebuffer 24
    mostly "$format is read out" rays.pam a.pam
done

# The paper's figures: 1/255 a slice stops at 128, and two bricks show 161.
level() { # level NAME VALUE IN OPTION...: of the pixel in the middle
    test_name=$1 value=$2 in=$3
    shift 3
    rm -f a.raw
    "$QVOL" render "$in" -o a.raw --size 1x1 --zoom 64 --sampling nearest --compositing slices --tf ./one.tf "$@"
    check "$test_name" test "$(od -A n -t u1 a.raw | tr -s ' ')" = " $value $value $value"
}
level "100 slices of 1/255" 100 fog_4x100x4_uint8.raw --dither none
level "200 slices of 1/255" 128 fog_4x200x4_uint8.raw --dither none
level "200 slices of 1/255 in 2 bricks" 161 fog_4x200x4_uint8.raw --dither none --bricks 1x2x1
level "200 slices of 1/255 in 2 chunks" 161 fog_4x200x4_uint8.raw --dither none --chunk 100 --phase 0.5
level "100 slices of 1/255, 24 bits" 83 fog_4x100x4_uint8.raw --framebuffer 24
level "200 slices of 1/255, 24 bits" 139 fog_4x200x4_uint8.raw --framebuffer 24
level "200 slices of 1/255 in 2 bricks, 24 bits" 139 fog_4x200x4_uint8.raw --framebuffer 24 --bricks 1x2x1
level "slices of .4/255 vanish" 0 fog_4x200x4_uint8.raw --tf ./thin.tf --dither none
cat >one_value.py <<'PY'
"""one_value.py FILE: all bytes are the same, and not 0."""
import sys
values = set(open(sys.argv[1], "rb").read())
sys.exit(len(values) != 1 or 0 in values)
PY
# Opacities at which pixels that differ by 1/1000 of a level show it.
for opacity in 0.0133059 0.0158236; do
    echo "0 255 255 255 $opacity" >fog.tf
    for options in "--framebuffer 16" "--framebuffer 24" "--order front-to-back" "--order front-to-back --framebuffer 16" \
        "--order front-to-back --framebuffer 24"; do
        # shellcheck disable=SC2086
        "$QVOL" render fog_4x200x4_uint8.raw -o a.raw --size 20x20 --zoom 64 --sampling nearest --tf ./fog.tf \
            --compositing slices --dither none $options
        check "without dither pixels are alike: $options, $opacity" "$PYTHON" one_value.py a.raw
    done
done
"$QVOL" render fog_4x200x4_uint8.raw -o rays.pam --size 20x20 --zoom 30 --sampling nearest --tf ./thin.tf
"$QVOL" render fog_4x200x4_uint8.raw -o a.pam --size 20x20 --zoom 30 --sampling nearest --tf ./thin.tf \
    --compositing slices
alike "slices of .4/255 do not vanish with dither" rays.pam a.pam 6

# A number of slices: as dense whatever it is, in sampling of either kind.
for mode in nearest weighted extinction; do
    IN=slab_16x16x16_uint8.raw
    for bits in 16 24; do
        draw rays.pam --sampling $mode --tf ./thin.tf --step 1 --phase 0.5 --termination 0
        for count in 5 16 40 201; do
            slices a.pam --sampling $mode --tf ./thin.tf --slices $count --framebuffer $bits --azimuth 0 --elevation 0
            draw rays.pam --sampling $mode --tf ./thin.tf --step 1 --phase 0.5 --azimuth 0 --elevation 0
            alike "$count slices, $mode, $bits bits" rays.pam a.pam
        done
    done
    IN=in_24x20x16_uint8.raw
done
slices a.pam --slices 77 --framebuffer 24 --json=a.json
slices a.pam --slices 78 --framebuffer 24 --json=b.json
check "slices lie evenly about the centre of the box" "$PYTHON" -c '
import json
assert [json.load(open(name))["sampling"]["phase_q16"] for name in ("a.json", "b.json")] == [0, 32768]'
check "77 slices are 77 steps of the box's depth" "$PYTHON" -c '
import json
report = json.load(open("a.json"))
forward = report["camera"]["view"]["forward_q30"]
depth = sum(abs(f) * n for f, n in zip(forward, report["volume"]["size"])) / 2**30
assert abs(report["camera"]["step_q16"] / 65536 - depth / 77) < 1e-4
slices = report["slices"]
assert slices["first"] in (-39, -38, -40) and slices["end"] in (39, 40, 41)'
draw rays.pam --unit-distance 3 --termination 0
slices a.pam --slices 150 --unit-distance 3 --framebuffer 24
alike "--slices with --unit-distance" rays.pam a.pam 2

# Bricks and chunks share one grid of slices.
draw rays.pam --sampling nearest --termination 0
for bricks in 1x1x1 2x1x1 1x3x1 1x1x4 3x2x2; do
    slices a.pam --sampling nearest --framebuffer 16 --bricks $bricks
    alike "$bricks bricks, 16 bits" rays.pam a.pam
done
slices a.pam --sampling nearest --framebuffer 24 --bricks 2x2x2 --chunk 5
alike "chunks of bricks" rays.pam a.pam
for options in "--dither none" "--dither random --slope .5" "--dither ordered --slope .5" "--dither bump --slope .5" \
    "--dither bump" "--dither rounding" "--framebuffer 12 --dither none" "--framebuffer 24"; do
    # shellcheck disable=SC2086
    slices a.raw --tf bone --background transparent $options --as raw
    # shellcheck disable=SC2086
    slices b.raw --tf bone --background transparent $options --as raw --bricks 1x1x1
    check "a picture of one brick is the brick: $options" cmp a.raw b.raw
done
for view in "--azimuth 200" "--azimuth 300 --elevation -40" "--elevation 90" "--perspective 40" \
    "--perspective 120 --zoom 3"; do
    # shellcheck disable=SC2086
    draw rays.pam --sampling nearest --tf ./bands.tf $view --termination 0
    # shellcheck disable=SC2086
    slices a.pam --sampling nearest --tf ./bands.tf $view --framebuffer 24 --bricks 3x4x2
    mostly "bricks from the back: $view" rays.pam a.pam
done
draw rays.pam --termination 0
slices a.pam --framebuffer 24 --bricks 2x2x2
alike "interpolation is clamped at the faces of bricks" rays.pam a.pam 3
for size in 1 7 1000; do
    for bits in 12 16 24; do
        slices a.pam --framebuffer $bits --chunk $size
        alike "chunks of $size, $bits bits" rays.pam a.pam
    done
done

# What changes bytes, and what does not.
for options in "" "--dither none" "--framebuffer 565" "--framebuffer 12 --chunk 6" "--dither random --bricks 2x2x1" \
    "--order front-to-back" "--dither bump --slope .85,.9" "--dither feedback --format mono-vertical"; do
    # shellcheck disable=SC2086
    slices base.raw $options --threads 1 --as raw
    for apart in "--threads 3" "--threads 2 --strip 8" "--threads 2 --strip 40"; do
        # shellcheck disable=SC2086
        slices a.raw $options $apart --as raw
        check "the same bytes: $options $apart" cmp base.raw a.raw
    done
done
with() { # with BASE OPTION...
    options=$1
    shift
    # shellcheck disable=SC2086
    slices base.pam $options
    # shellcheck disable=SC2086
    slices a.pam $options "$@"
    differs "changes the picture: $options and $*" base.pam a.pam
}
for kind in none random ordered bump feedback; do
    with "--tf bone" --dither $kind
done
for bits in 12 16 24 565; do
    with "" --framebuffer $bits
done
for sequence in golden hash; do
    with "" --sequence $sequence
    with "--dither feedback --residual 4" --sequence $sequence
done
with "--dither random" --sequence blocks
with "--dither bump" --sequence golden
with "--dither feedback" --residual 4
with "--dither bump" --slope 1
for kind in random ordered "bump --slope 1"; do
    with "--dither $kind" --period 8
    with "--dither $kind" --slope .8
    with "--dither $kind --tf grey" --cutoff 2
    with "--dither $kind" --frame 1
    with "--dither $kind" --still
done
with "--dither bump --slope .9,1.1 --tf bone --step .5" --slope .9
with "" --frame 7
with "" --still
with "" --chunk 4
with "" --bricks 1x2x1
with "" --order front-to-back
with "--tf bone --order front-to-back" --termination .5
slices a.pam --tf bone --order front-to-back --termination 0.0009766
slices b.pam --tf bone --order front-to-back
check "the default termination" cmp a.pam b.pam
slices a.pam --dither bump
slices b.pam --dither rounding
check "opacities that go by what a grey pixel holds are as exact as dithered rounding" cmp a.pam b.pam
slices a.pam --dither ordered --period 32 --slope 1 --cutoff 255 --frame 0
slices b.pam --dither ordered
check "the defaults of alpha dithering" cmp a.pam b.pam
slices a.pam --framebuffer 8 --dither rounding --sequence blocks --order back-to-front
slices b.pam
check "the defaults of slices" cmp a.pam b.pam
draw a.pam --compositing rays
draw b.pam
check "rays are the default" cmp a.pam b.pam

# What the library recommends.
for options in "" "--residual 4" "--residual 8" "--framebuffer 565" "--framebuffer 12" "--framebuffer 16" \
    "--framebuffer 24"; do
    # shellcheck disable=SC2086
    slices a.pam $options --dither auto --json=a.json
    kind=$("$PYTHON" -c '
import json
slices = json.load(open("a.json"))["slices"]
assert slices["dither"]["kind"] == slices["recommended"]["dither"]
print(slices["dither"]["kind"])')
    # shellcheck disable=SC2086
    slices b.pam $options --dither "${kind:-nothing}"
    check "recommended is what is drawn: $options, $kind" cmp a.pam b.pam
done
least() { # least OPACITY OPTION...: the least of a slice, Q0.32
    opacity=$1
    shift
    slices a.pam --step .5 "$@" --json=a.json
    check "the least opacity of a slice, $opacity: $*" "$PYTHON" -c '
import json
import sys
recommended = json.load(open("a.json"))["slices"]["recommended"]
assert recommended["least_opacity_q32"] == int(sys.argv[1]), recommended
assert recommended["slices"] in range(50, 90)
assert recommended["worst_of_fog_x100"] >= 50 and recommended["worst_x100"] >= 50' "$opacity"
}
level8=$((4294967295 / 255)) level16=$((4294967295 / 65535))
least $level8 --sampling nearest --storage rgba8
least $level8 --sampling nearest --storage indexed8
least $((5 * level16)) --sampling nearest --storage rgba16
least $((5 * level16)) --sampling nearest --storage indexed8 --palette-bits 16
least $((255 * level8)) --sampling nearest --tf ./empty.tf
# Interpolation makes any.
least 1
least 1 --sampling separate --storage rgba8
least 1 --sampling extinction
least 1 --storage rgbt16 --unit-distance 1
least 1 --sampling bspline-weighted

# The report.
slices a.pam --framebuffer 12 --chunk 6 --json=a.json
slices b.pam --dither feedback --json=b.json
slices b.pam --dither random --bricks 2x1x1 --period 16 --slope .5 --json=c.json
draw b.pam --json=d.json
slices b.pam --order front-to-back --json=e.json
slices b.pam --order front-to-back --termination .5 --json=f.json
check "the report tells the frame buffer and the dither" "$PYTHON" -c '
import json
a, b, c, d = (json.load(open(name + ".json"))["slices"] for name in "abcd")
assert a["framebuffer"] == {"bits": "12", "pixel_bytes": 6, "bytes": 21000, "bytes_beside": 0}
assert a["chunk"] == 6 and a["bricks"] is None and a["dither"]["sequence"] == "blocks"
assert b["framebuffer"]["bytes"] == b["framebuffer"]["bytes_beside"] == 10500
assert c["bricks"] == [2, 1, 1] and c["framebuffer"]["pixel_bytes"] == 4
assert c["dither"]["period"] == 16 and c["dither"]["slope_q16"][0] == 32768
assert d is None'
check "the report tells where pixels end" "$PYTHON" -c '
import json
assert [json.load(open(name + ".json"))["sampling"]["termination"] for name in "adef"] == [0, 64, 64, 32768]'
check "front to back nothing is recommended" "$PYTHON" -c '
import json
assert json.load(open("a.json"))["slices"]["recommended"]
assert json.load(open("e.json"))["slices"]["recommended"] is None'

# Tables of dithered opacities for flash.
cat >table.c <<'END'
#include "qvol.h"
#include <string.h>
#ifdef TABLE_HEADER
#include TABLE_HEADER
#else
extern const qv_volume a_volume;
extern const qv_dither_table a_dither_table;
#endif
int main(void)
{
    static uint8_t entries[1024 * 64];
    const qv_dither dither = {.period = PERIOD, .cutoff = CUTOFF, .slope = {SLOPE, 0}};
    qv_transfer transfer;
    memcpy(&transfer, a_volume.palette, sizeof transfer); /* of 16 bits */
    return a_volume.palette_bytes != sizeof transfer || a_dither_table.period != PERIOD ||
           a_dither_table.entry_bytes != ENTRY ||
           a_dither_table.bytes != qv_dither_table_bytes(PERIOD, ENTRY) ||
           qv_dither_table_build(entries, sizeof entries, ENTRY, &dither, &transfer, 0, 256) != QV_OK ||
           memcmp(entries, a_dither_table.entries, (size_t)a_dither_table.bytes) != 0;
}
END
core=$TESTS/../../core fixedpoint=$TESTS/../../fixedpoint
table() { # table NAME FILE OPTIONS MACRO...
    test_name=$1 file=$2 options=$3
    shift 3
    rm -f a.c a.h table
    # shellcheck disable=SC2086
    "$QVOL" classify $IN -o "$file" --tf fog --palette-bits 16 $options
    source=a.c
    [ "$file" = a.c ] || source=-DTABLE_HEADER=\"a.h\"
    check "$test_name compiles" "$CC" -std=c99 -pedantic -Wall -Wextra -Werror -I. -I"$core" -I"$fixedpoint" "$@" \
        table.c "$source" "$core"/*.c "$fixedpoint"/*.c -o table
    check "$test_name holds what the library builds" ./table
}
table "a table of opacities" a.c "--dither-table opacity" -DPERIOD=32 -DCUTOFF=0 -DSLOPE=0 -DENTRY=1
table "a table of colours" a.h "--dither-table colour --period 8 --slope .5 --cutoff 3" \
    -DPERIOD=8 -DCUTOFF=3 -DSLOPE=32768 -DENTRY=4
export_refused() { # export_refused PATTERN OPTION...
    pattern=$1
    shift
    refuses "refused: classify $*" 2 "$pattern" "$QVOL" classify $IN "$@"
}
"$QVOL" classify $IN -o a.c --dither-table colour --json=a.json
"$QVOL" classify $IN -o b.c --json=b.json
check "the report tells the bytes of the table" "$PYTHON" -c '
import json
a, b = (json.load(open(name + ".json"))["output"]["dither_table_bytes"] for name in "ab")
assert a == 32768 and b == 0'
export_refused "unknown 'both', use one of opacity, colour" -o a.c --dither-table both
export_refused ": --dither-table: needs an output that ends in .c or .h" -o a.raw --dither-table colour
export_refused ": --dither-table: needs opacity" -o a.c --dither-table colour --extinction auto
export_refused ": --dither-table: needs --storage indexed8" -o a.c --dither-table colour --storage rgba8
for option in --period --slope --cutoff; do
    export_refused ": $option: needs --dither-table" -o a.c $option 2
done
export_refused ": --slope: needs a single slope" -o a.c --dither-table colour --slope 1,2
export_refused ": --frame: unknown" -o a.c --frame 2

# What is refused.
refused() { # refused PATTERN OPTION...
    pattern=$1
    shift
    # shellcheck disable=SC2086
    refuses "refused: $*" 2 "$pattern" "$QVOL" render $IN -o a.pam --compositing slices "$@"
}
for options in "--framebuffer 8" "--dither none" "--residual 4" "--sequence hash" "--period 8" "--slope 1" \
    "--cutoff 9" "--frame 0" "--still" "--chunk 4" "--slices 9" "--bricks 1x1x1"; do
    # shellcheck disable=SC2086
    refuses "$options without slices" 2 ": ${options%% *}: needs --compositing slices" "$QVOL" render $IN -o a.pam $options
done
refuses "--compositing planes" 2 "rays, slices" "$QVOL" render $IN -o a.pam --compositing planes
refused "8, 12, 16, 24, 565" --framebuffer 10
refused "none, random, ordered, bump, rounding, feedback, auto" --dither noise
refused "4, 8" --dither feedback --residual 6
refused "golden, hash, blocks" --sequence silver
for period in 1 65 -3 many; do
    refused "not a whole number from 2 to 64" --dither ordered --period $period
done
for slope in 0 17 -1 1,0 1,2,3 steep ""; do
    refused "neither A nor A,B" --dither bump --slope "$slope"
done
for cutoff in 0 256 1.5; do
    refused "not a whole number from 1 to 255" --dither ordered --cutoff $cutoff
done
refused "not a whole number from 0 to 4294967295" --frame -1
refused "not a whole number from 1 to 65535" --chunk 0
refused "not a whole number from 1 to 65535" --slices 0
refused "not a whole number from 1 to 65535" --slices 65536
refused "XxYxZ, each 1 to 64" --bricks 2x2
refused "XxYxZ, each 1 to 64" --bricks 0x2x2
refused "XxYxZ, each 1 to 64" --bricks 65x2x2
refused ": --bricks: 21 on an axis of 20 voxels" --bricks 1x21x1
refused ": --slices: .* apart, which is not 0.0625 to 16" --slices 1
refused ": --slices: .* apart, which is not 0.0625 to 16" --slices 5000
for bits in 12 16 24; do
    for kind in random ordered bump; do
        refused ": --dither: needs --framebuffer 8 or 565" --framebuffer $bits --dither $kind
    done
    refused ": --dither: needs --framebuffer 8 " --framebuffer $bits --dither feedback
done
refused ": --dither: needs --framebuffer 8 " --framebuffer 565 --dither feedback
for options in "--chunk 4" "--bricks 2x1x1" "--background transparent"; do
    # shellcheck disable=SC2086
    refused "needs another --framebuffer: 565 keeps no opacity" --framebuffer 565 $options
done
for bits in 12 565; do
    refused ": --order: needs back-to-front, or --framebuffer" --framebuffer $bits --order front-to-back
done
for kind in random feedback auto; do
    refused ": --order: needs back-to-front, or --dither" --dither $kind --order front-to-back
done
refused ": --chunk: needs --order back-to-front" --chunk 4 --order front-to-back
refused ": --bricks: needs --order back-to-front" --bricks 2x1x1 --order front-to-back
refused ": --residual: needs --dither feedback or auto" --residual 4
refused ": --residual: needs --framebuffer 8" --residual 4 --dither auto --framebuffer 16
for options in "--dither none" "--dither ordered" "--dither bump --slope 1"; do
    # shellcheck disable=SC2086
    refused ": --sequence: needs --dither" $options --sequence hash
done
refused ": --period: needs --dither" --period 8
refused ": --period: needs --dither" --period 8 --dither bump
refused ": --slope: needs --dither random, ordered or bump" --slope 1
refused ": --slope: needs --dither bump" --slope 1,2 --dither ordered
refused ": --cutoff: needs --dither" --cutoff 8
refused ": --frame: needs a --dither" --frame 1 --dither none
refused ": --still: needs a --dither" --still --framebuffer 24
refused ": --termination: needs --order front-to-back" --termination 0
refused ": --level: needs a volume without --bricks" --level 1 --bricks 1x1x1
refused ": --step: needs no --slices" --step 1 --slices 30
refused ": --phase: needs no --slices" --phase 0 --slices 30
refused ": --slices: needs a view without --perspective" --slices 30 --perspective 30
refuses "--slices of voxels whose opacities stay" 2 ": --slices: the opacities of" "$QVOL" render rgba_24x20x16.raw \
    --type rgba8 --dims 24x20x16 -o a.pam --compositing slices --sampling nearest --slices 30
check "no file is left" sh -c '! ls | grep -e "\.tmp$"'
finish
