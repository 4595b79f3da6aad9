#!/bin/sh
# What each option of `render` does to the picture.
. tests/command/common
cd "$work" || exit 1
"$PYTHON" "$TESTS/volumes.py" in_12x10x8_uint8.raw
IN=in_12x10x8_uint8.raw
DEFAULT="--size 40x30 --tf surface"

render() { # render OUT OPTION...
    out=$1
    shift
    # shellcheck disable=SC2086
    "$QVOL" render $IN -o "$out" $DEFAULT "$@"
}

render base.pam
changes() { # changes OPTION...: another picture than without
    render new.pam "$@" || echo "# failed: $*" >&2
    differs "changes the picture: $*" base.pam new.pam
}
same() { # same OPTION...
    rm -f new.pam
    render new.pam "$@"
    cmp -s base.pam new.pam
    outcome $? "changes no byte: $*"
}

check "the picture is not empty" "$PYTHON" -c \
    'import sys; d = open("base.pam", "rb").read()[-3600:]; sys.exit(sum(b > 50 for b in d) < 250)'
changes --sampling nearest
changes --sampling separate
same --sampling weighted
changes --storage rgba8
same --storage rgba16
changes --storage indexed8
changes --tf fog
changes --window 20:200
same --window 0:255
changes --shade
changes --size 41x30
changes --azimuth 20
changes --elevation 20
changes --roll 20
same --azimuth 360 --elevation=-720 --roll 0
changes --zoom 1.1
changes --perspective 30
changes --step 0.5
changes --phase 0.5
changes --background 102030
changes --background transparent
changes --termination 0.9
changes --format l8
changes --spacing 1x1x2
same --spacing 3x3x3
for threads in 1 2 3 16; do
    same --threads $threads
done
for rows in 1 2 7 16 30 100; do
    same --strip $rows --threads 2
done
same --quiet
same --as pam
"$QVOL" render $IN -o shade1.pam --shade
"$QVOL" render $IN -o shade2.pam --shade --light 60,10
differs "--light moves the light" shade1.pam shade2.pam
"$QVOL" render $IN -o bits8.pam --storage indexed8 --tf fog --palette-bits 8
"$QVOL" render $IN -o bits16.pam --storage indexed8 --tf fog --palette-bits 16
differs "--palette-bits 16 keeps thin fog" bits8.pam bits16.pam
"$QVOL" render $IN -o fog16.pam --storage rgba16 --tf fog
check "a 16-bit palette draws what 16-bit voxels draw" cmp bits16.pam fog16.pam

"$PYTHON" -c 'import sys; sys.stdout.buffer.write(bytes((136, 19)) * 27)' >even.raw
check "equal values of 16 bits need no --window" "$QVOL" render even.raw --dims 3x3x3 --type u16le \
    -o even.pam --size 8x8

# Orders agree but for rounding and early termination.
render front.pam --termination 0
render back.pam --order back-to-front
check "back to front is front to back within 1" "$QVOL" compare front.pam back.pam --tolerance 1

# A whole turn of 90 degrees on a cube is exact: sides of a square swap.
check "roll by 90 degrees turns the picture" sh -c '
    "$1" render "$2" -o r0.pam --size 32x32 --tf surface &&
    "$1" render "$2" -o r90.pam --size 32x32 --tf surface --roll 90 &&
    "$3" - <<END
def pixels(name):
    data = open(name, "rb").read()[-32 * 32 * 3:]
    return [[data[3 * (32 * y + x):3 * (32 * y + x) + 3] for x in range(32)] for y in range(32)]
a, b = pixels("r0.pam"), pixels("r90.pam")
counter_clockwise = [[a[x][31 - y] for x in range(32)] for y in range(32)]
assert b == counter_clockwise
END' - "$QVOL" $IN "$PYTHON"

# Azimuth 90 looks along -x, from +x: what was deep becomes the right side.
check "azimuth moves the viewer towards +x" sh -c '
    "$3" - <<END
from volumes import *
values = [255 if x > 8 and z > 5 and y < 3 else 0 for z in range(8) for y in range(10) for x in range(12)]
write("corner_12x10x8_uint8.raw", packed(values))
END
    "$1" render corner_12x10x8_uint8.raw -o c0.pam --size 32x32 --tf surface --as raw &&
    "$1" render corner_12x10x8_uint8.raw -o c90.pam --size 32x32 --tf surface --azimuth 90 --as raw &&
    "$3" - <<END
def centre(name):
    data = open(name, "rb").read()
    lit = [(i % 32, i // 32) for i in range(1024) if data[3 * i] > 100]
    return sum(p[0] for p in lit) / len(lit), sum(p[1] for p in lit) / len(lit)
(x0, y0), (x90, y90) = centre("c0.pam"), centre("c90.pam")
assert x0 > 16 and y0 < 16, (x0, y0)      # right and up
assert x90 < 16 and y90 < 16, (x90, y90)  # y to the left of a viewer at +x would be its low end
END' - "$QVOL" $IN "$PYTHON"

# Termination: a darker but close picture, and fewer samples.
render a.pam --termination 0 --json=a.json
render b.pam --termination 0.5 --json=b.json
check "termination saves samples" "$PYTHON" -c '
import json
a, b = (json.load(open(n))["statistics"] for n in ("a.json", "b.json"))
assert b["samples"] < a["samples"] and b["terminated"] > 0 and a["terminated"] <= b["terminated"]'
render def.pam --json=d.json
check "the default termination costs at most 1" "$QVOL" compare a.pam def.pam --tolerance 1

# A mask: its voxels are classified by its own transfer function.
"$PYTHON" -c '
from volumes import *
values = [v if x < 6 else 0 for v, x in zip(blob(), list(range(12)) * 80)]
write("mask_12x10x8_uint8.raw", packed(values))
write("small_6x10x8_uint8.raw", packed(values[:480]))
write("red.tf", b"0 255 0 0 1\n")'
"$QVOL" render $IN -o masked.pam --tf ./red.tf --mask $IN --mask-tf surface --size 40x30
"$QVOL" render $IN -o half.pam --tf surface --mask mask_12x10x8_uint8.raw --mask-tf ./red.tf --size 40x30
differs "--mask replaces voxels" half.pam base.pam
differs "--mask replaces only voxels of the mask" half.pam masked.pam
refuses "a mask of another size" 1 "size: differs" "$QVOL" render $IN -o x.pam \
    --mask small_6x10x8_uint8.raw --mask-tf grey
"$PYTHON" -c '
from volumes import *
write("plain.nii", nifti(blob()))
write("tall.nii", nifti(blob(), spacing=(1, 1, 3)))'
refuses "a mask of other spacing" 1 "spacing: differs" "$QVOL" render plain.nii -o x.pam \
    --mask tall.nii --mask-tf grey
finish
