#!/bin/sh
# Sampling that weighs by length, the unit distance, and storage that holds extinction.
. tests/command/common
cd "$work" || exit 1
"$PYTHON" - <<'PY'
from volumes import *
write("in_12x10x8_uint8.raw", packed(blob()))
write("slab_16x16x16_uint8.raw", packed([200] * 4096))
write("half_16x8x16_uint8.raw", packed([200] * 2048))
write("even.tf", b"0 250 120 60 0\n199 250 120 60 0\n200 250 120 60 0.06\n255 250 120 60 0.06\n")
PY
IN=in_12x10x8_uint8.raw
VIEW="--size 40x30 --azimuth 20 --elevation 10"
LENGTHS="weighted extinction bspline-weighted bspline-extinction"

draw() { # draw OUT IN OPTION...
    out=$1 in=$2
    shift 2
    rm -f "$out"
    # shellcheck disable=SC2086
    "$QVOL" render "$in" -o "$out" $VIEW "$@"
}
alike() { # alike NAME A B [LEVELS]: the pictures differ by at most so much
    check "$1" "$QVOL" compare -q "$2" "$3" --tolerance "${4:-1}"
}

# Modes: five pictures of one volume, both orders the same.
draw weighted.pam $IN --tf surface --termination 0
check "weighted without --unit-distance has the bytes that it had" sh -c \
    '"$1" render "$2" -o - --tf surface --size 40x30 --as raw | cksum | grep -q "^3386379873 3600$"' - "$QVOL" $IN
for mode in extinction bspline-weighted bspline-extinction; do
    draw $mode.pam $IN --tf surface --sampling $mode --termination 0
    draw back.pam $IN --tf surface --sampling $mode --order back-to-front
    differs "--sampling $mode is another picture" $mode.pam weighted.pam
    alike "$mode: back to front is front to back" $mode.pam back.pam
done
differs "B-splines know opacity and extinction" bspline-weighted.pam bspline-extinction.pam
draw unit.pam $IN --tf surface --unit-distance 0.5
draw back.pam $IN --tf surface --unit-distance 0.5 --order back-to-front
differs "--unit-distance changes opacities" unit.pam weighted.pam
alike "corrected: back to front is front to back" unit.pam back.pam

# A homogeneous slab is the same at every step, whatever the shape of its voxels.
for mode in $LENGTHS; do
    for storage in rgba8 rgba16 "indexed8 --palette-bits 16"; do
        # shellcheck disable=SC2086
        draw base.pam slab_16x16x16_uint8.raw --tf ./even.tf --sampling $mode --storage $storage --unit-distance 1
        for step in 0.125 0.5 2 4; do
            # shellcheck disable=SC2086
            draw a.pam slab_16x16x16_uint8.raw --tf ./even.tf --sampling $mode --storage $storage \
                --unit-distance 1 --step $step
            alike "slab, $mode, $storage, step $step" base.pam a.pam
        done
    done
    draw a.pam half_16x8x16_uint8.raw --tf ./even.tf --sampling $mode --unit-distance 1 --spacing 1x2x1
    alike "slab, $mode, half as many voxels on y" base.pam a.pam
    draw a.pam slab_16x16x16_uint8.raw --tf ./even.tf --sampling $mode --unit-distance 1 --spacing .5x.5x.5
    alike "slab, $mode: lengths are in units of the smallest spacing" base.pam a.pam 0
    draw a.pam slab_16x16x16_uint8.raw --tf ./even.tf --sampling $mode --unit-distance 2
    "$QVOL" compare -q base.pam a.pam --tolerance 8
    check "slab, $mode: another unit distance is another slab" test $? -eq 1
done
draw base.pam slab_16x16x16_uint8.raw --tf ./even.tf
draw a.pam slab_16x16x16_uint8.raw --tf ./even.tf --step 0.5
"$QVOL" compare -q base.pam a.pam --tolerance 8
check "without --unit-distance opacities hold for the step" test $? -eq 1

# Storage of extinction: the same volume.
for mode in extinction bspline-extinction; do
    draw base.pam $IN --tf bone --sampling $mode
    draw a.pam $IN --tf bone --storage rgbt16 --sampling $mode
    alike "$mode: rgbt16 draws what rgba16 draws" base.pam a.pam
    draw a.pam $IN --tf bone --storage indexed8 --palette-bits 16 --extinction auto --sampling $mode
    alike "$mode: so does a 16-bit palette of extinction" base.pam a.pam
    draw a.pam $IN --tf bone --storage rgbt8 --sampling $mode
    alike "$mode: rgbt8, nearly" base.pam a.pam 3
done
draw a.pam $IN --tf bone --storage rgbt16
draw b.pam $IN --tf bone --storage rgbt16 --sampling extinction
check "extinction is the default where voxels hold it" cmp a.pam b.pam
draw a.pam $IN --tf surface --storage rgbt16 --step 0.5 --unit-distance 2 --json=a.json
draw b.pam $IN --tf surface --sampling extinction --step 0.5 --unit-distance 2
alike "the unit distance of opacities that become extinction" a.pam b.pam
draw b.pam $IN --tf surface --storage rgbt16 --step 0.5 --unit-distance 2 --extinction "$("$PYTHON" -c '
import json
print(json.load(open("a.json"))["volume"]["extinction_q16"] / 65536)')"
check "auto is the number in the report" cmp a.pam b.pam
draw b.pam $IN --tf surface --storage rgbt16 --step 0.5 --unit-distance 2 --extinction 100
alike "a larger full value holds the same" a.pam b.pam
draw b.pam $IN --tf surface --storage rgbt16 --step 0.5 --unit-distance 2 --extinction 0.1
differs "a smaller one is the most there is" a.pam b.pam
"$PYTHON" -c '
from volumes import *
write("mask_12x10x8_uint8.raw", packed([v if x < 6 else 0 for v, x in zip(blob(), list(range(12)) * 80)]))'
draw a.pam $IN --tf fog --mask mask_12x10x8_uint8.raw --mask-tf surface --storage rgbt16 --shade
draw b.pam $IN --tf fog --mask mask_12x10x8_uint8.raw --mask-tf surface --sampling extinction --shade
alike "input and mask share the full value" a.pam b.pam

# Written, read and drawn again, with the options that the report gives.
read_again() { # read_again REPORT: the options for the shell
    "$PYTHON" -c 'import json, shlex, sys; print(shlex.join(json.load(open(sys.argv[1]))["read"]))' "$1"
}
round_trip() { # round_trip OPTION...
    rm -f voxels.bin* a.pam b.pam
    "$QVOL" classify $IN -o voxels.bin --tf surface --spacing 1x1x2 --json=r.json "$@"
    eval "draw a.pam voxels.bin $(read_again r.json)"
    # shellcheck disable=SC2046
    draw b.pam $IN --tf surface --spacing 1x1x2 $(echo "$*" | sed 's/--endian [a-z]*//')
    check "round trip: $*" cmp a.pam b.pam
}
round_trip --storage rgbt8
round_trip --storage rgbt8 --extinction 3.25
round_trip --storage rgbt16 --unit-distance 0.7
round_trip --storage rgbt16 --endian big --extinction 20
round_trip --storage rgbt16 --shade --azimuth 20 --elevation 10
round_trip --storage indexed8 --extinction auto
round_trip --storage indexed8 --palette-bits 16 --extinction 12
round_trip --storage indexed8 --palette-bits 16 --extinction auto --endian big
round_trip --storage rgba16 --endian big
round_trip --storage rgba8 --unit-distance 2
round_trip --storage indexed8

"$QVOL" classify $IN -o t.bin --tf surface --storage rgbt16 --unit-distance 2 --json=t.json
"$QVOL" classify $IN -o a.bin --tf surface --storage rgba16
check "rgbt16 holds the depth of rgba16 for a unit of length" "$PYTHON" - <<'PY'
import json, math, struct
report = json.load(open("t.json"))
full = report["volume"]["extinction_q16"] / 65536
assert report["volume"]["unit_distance_q16"] == 131072 and report["transfer"]["channels"] == "rgbt"
t, a = (struct.unpack("<3840H", open(n, "rb").read()) for n in ("t.bin", "a.bin"))
for i in range(0, 3840, 4):
    assert t[i:i + 3] == a[i:i + 3]
    depth = -math.log2(1 - a[i + 3] / 65535) / 2
    assert abs(t[i + 3] - depth / full * 65535) <= .52, (t[i + 3], depth)
assert max(t[3::4]) == 65535
PY

# Reduced: what the unit distance was given for is a length of the input.
for reduce in 1 2 4; do
    "$QVOL" classify slab_16x16x16_uint8.raw -o slab$reduce.bin --tf ./even.tf --storage rgbt16 --unit-distance 1 \
        --reduce $reduce --json=slab.json
    eval "draw slab$reduce.pam slab$reduce.bin $(read_again slab.json)"
    alike "reduced by $reduce: the same slab" slab1.pam slab$reduce.pam
done
"$QVOL" classify slab_16x16x16_uint8.raw -o slab.c --tf ./even.tf --storage rgba8 --unit-distance 1 --reduce 2
check "reduced: the unit distance in the C array" grep -q "^ *32768u, /\* unit distance" slab.c
"$QVOL" classify slab_16x16x16_uint8.raw -o slab.c --tf ./even.tf --storage rgba8
check "none in the C array: the step" grep -q "^ *0u, /\* unit distance" slab.c
finish
