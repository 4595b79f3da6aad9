#!/bin/sh
# Sampling of associated colours, and the storage that holds them.
. tests/command/common
cd "$work" || exit 1
"$PYTHON" - <<'PY'
from volumes import *
write("in_12x10x8_uint8.raw", packed(blob()))
PY
IN=in_12x10x8_uint8.raw
VIEW="--size 40x30 --azimuth 20 --elevation 10 --tf surface"

draw() { # draw OUT OPTION...
    out=$1
    shift
    rm -f "$out"
    # shellcheck disable=SC2086
    "$QVOL" render $IN -o "$out" $VIEW "$@"
}
alike() { # alike NAME A B LEVELS: the pictures differ by at most so much
    check "$1" "$QVOL" compare -q "$2" "$3" --tolerance "$4"
}

draw weighted.pam --storage rgba8
draw preweighted.pam --sampling preweighted --json=report.json
alike "--sampling preweighted draws what weighted draws" weighted.pam preweighted.pam 3
differs "but not to the bit" weighted.pam preweighted.pam
check "its storage is associated8" grep -q '"storage": "associated8"' report.json
check "the report names the mode" grep -q '"mode": "preweighted"' report.json
draw by_storage.pam --storage associated8
check "--storage associated8 is sampled so" cmp preweighted.pam by_storage.pam
draw back.pam --sampling preweighted --order back-to-front
alike "back to front is front to back" preweighted.pam back.pam 1
draw slices.pam --sampling preweighted --compositing slices --framebuffer 24
alike "so are slices" preweighted.pam slices.pam 2

# Colours of the mask are weighted once.
draw masked.pam --sampling preweighted --mask $IN --mask-tf surface
check "a mask of the same scan changes nothing" cmp preweighted.pam masked.pam

# Voxels that were associated before.
"$QVOL" classify $IN -o voxels.raw --storage associated8 --tf surface
rm -f before.pam
"$QVOL" render voxels.raw -o before.pam --type associated8 --dims 12x10x8 --size 40x30 --azimuth 20 --elevation 10
check "--type associated8 reads what classify writes" cmp preweighted.pam before.pam
"$QVOL" classify $IN -o straight.raw --storage rgba8 --tf surface
check "colours are weighted to nearest" "$PYTHON" -c '
straight, weighted = open("straight.raw", "rb").read(), open("voxels.raw", "rb").read()
assert len(straight) == len(weighted) == 4 * 12 * 10 * 8
for i in range(0, len(straight), 4):
    a = straight[i + 3]
    assert weighted[i + 3] == a and max(weighted[i:i + 3]) <= a
    for c in range(i, i + 3):
        assert abs(255 * weighted[c] - straight[c] * a) <= 127
'

refused() { # refused NAME OPTION PATTERN ARGUMENT...
    name=$1 pattern="$2.*$3"
    shift 3
    refuses "$name" 2 "$pattern" "$QVOL" "$@"
}
refused "other storage is refused" --sampling "need each other" \
    render $IN -o x.pam --sampling preweighted --storage rgba8
refused "other sampling is refused" --sampling "need each other" \
    render $IN -o x.pam --sampling weighted --storage associated8
refused "a unit distance is refused" --unit-distance "take opacities as they are" \
    render $IN -o x.pam --sampling preweighted --unit-distance 2
refused "levels are refused" --level "have no levels" \
    render $IN -o x.pam --sampling preweighted --level 1
refused "pyramids are refused" --storage "no levels" pyramid $IN -o x.bin --storage associated8
refused "FreeVoxels are refused" --storage "not weighted" \
    freevoxel $IN -o x.fvx --storage associated8
finish
