#!/bin/sh
# The report is valid JSON, and enough to compute the picture again.
. tests/command/common
cd "$work" || exit 1
cat >make.py <<'END'
from volumes import *
stored, size = turned(blob(), SIZE, (2, 0, 1), (True, False, True))
rows = [[0.0] * 4 for _ in range(3)]
for world, (axis, step) in enumerate(zip((2, 0, 1), (-1.0, 1.5, -1.0))):
    rows[world][axis] = step
write("a.nii", nifti([-v / 3 for v in stored], size, code="f", sform=rows, slope=-2, inter=5))
write("in_12x10x8_uint8.raw", packed(blob()))
END
"$PYTHON" make.py
cat >again.py <<'END'
"""again.py REPORT RAW: the picture from the report and the scan alone, in exact
fractions where the library rounds; every channel within 1."""
import json
import math
import struct
import sys
report = json.load(open(sys.argv[1]))
raw = open(sys.argv[2], "rb").read()
source, scalars, camera = report["input"], report["scalars"], report["camera"]
data = open(source["file"], "rb").read()
form = {"u8": "B", "f32": "f"}[source["type"]]
skip = 352 if source["format"].startswith("NIfTI") else 0
stored = struct.unpack(f"<{source['bytes'] // struct.calcsize(form)}{form}", data[skip:])

def scalar(place):
    index = [0, 0, 0]
    for world in range(3):
        axis = scalars["stored_axis"][world]
        size = scalars["size"][world]
        index[axis] = size - 1 - place[world] if scalars["reversed"][world] else place[world]
    value = stored[index[0] + source["size"][0] * (index[1] + source["size"][1] * index[2])]
    if scalars["conversion"] == "none":
        return value
    low, high = scalars["window"]
    share = (source["slope"] * value + source["offset"] - low) / (high - low)
    return math.floor(65535 * min(1, max(0, share)) + .5)

volume = report["volume"]
step_length = camera["step_q16"] / 65536
mode, by_length = report["sampling"]["mode"], report["sampling"]["by_length"]

def fourth(value):
    """Opacity, or depth per world unit where samples are of extinction."""
    if report["transfer"]["channels"] == "rgbt":
        return value * volume["extinction_q16"] / 65536
    if mode != "extinction":
        return value
    return (-math.log2(1 - value) if value < 1 else 64) / (volume["unit_distance_q16"] / 65536)

def voxel(place):
    place = [min(size - 1, max(0, p)) for p, size in zip(place, scalars["size"])]
    span = scalars["high"] - scalars["low"]
    index = (2 * 255 * (scalar(place) - scalars["low"]) + span) // (2 * span)
    r, g, b, a = (c / 65535 for c in report["transfer"]["table"][min(255, max(0, index))])
    a = fourth(a)
    return (r * a, g * a, b * a, a)

def sample(position):
    if mode == "nearest":
        return voxel([math.floor(p) for p in position])
    base = [math.floor(p - .5) for p in position]
    part = [p - .5 - b for p, b in zip(position, base)]
    total = [0] * 4
    for corner in range(8):
        bits = [corner >> axis & 1 for axis in range(3)]
        weight = math.prod(f if bit else 1 - f for f, bit in zip(part, bits))
        for channel, value in enumerate(voxel([b + bit for b, bit in zip(base, bits)])):
            total[channel] += weight * value
    return total

def over_length(colours, length):
    """Weighted colours and opacity of a piece of so many world units."""
    *weighted, fourth = colours
    if fourth <= 0:
        return [0] * 4
    if mode == "extinction":
        opacity = 1 - 2 ** (-fourth * length)
    else:
        opacity = 1 - (1 - fourth) ** (length / (volume["unit_distance_q16"] / 65536))
    return [c / fourth * opacity for c in weighted] + [opacity]

ONE = 1 << 32
size = report["volume"]["size"]
phase = report["sampling"]["phase_q16"] / 65536

def ray(x, y):
    start = [o + x * a + y * d for o, a, d in zip(camera["origin"], camera["across"], camera["down"])]
    if camera["kind"] == "orthographic":
        return [s / ONE for s in start], [v / ONE for v in camera["along"]], -600
    view = [(l + x * a + y * d) / ONE for l, a, d in zip(camera["along"], camera["across"], camera["down"])]
    length = math.sqrt(sum(v * v for v in view))
    step = [p / ONE * v / length for p, v in zip(camera["pace"], view)]
    return [o / ONE for o in camera["origin"]], step, 0

def inside(position):
    return all(0 <= p < n for p, n in zip(position, size))

def whole_steps(origin, step, first):
    for k in range(first, 600):
        position = [o + (k + phase) * s for o, s in zip(origin, step)]
        if inside(position):
            yield position, 1

def pieces(origin, step, first):
    """Middles and lengths in steps of what the borders make of the way through the box."""
    ends = [sorted((-o / s, (n - o) / s)) if s else (-math.inf, math.inf) if 0 <= o < n else (0, -1)
            for o, s, n in zip(origin, step, size)]
    enter, leave = max(e[0] for e in ends), min(e[1] for e in ends)
    enter = max(enter, 0) if first == 0 else enter
    if enter < leave:
        borders = range(math.floor(enter) - 1, math.ceil(leave) + 2)
        cuts = [enter] + [k + phase - .5 for k in borders if enter < k + phase - .5 < leave] + [leave]
        for start, end in zip(cuts, cuts[1:]):
            yield [o + (start + end) / 2 * s for o, s in zip(origin, step)], end - start

def pixel(x, y):
    light, through = [0, 0, 0], 1
    for position, length in (pieces if by_length else whole_steps)(*ray(x, y)):
        colours = sample([math.floor(p * 256 + .5) / 256 for p in position])
        if by_length:
            colours = over_length(colours, length * step_length)
        light = [l + through * c for l, c in zip(light, colours)]
        through *= 1 - colours[3]
    back = report["frame"]["background"]
    return [255 * (l + through * c / 255 * back[3] / 255) for l, c in zip(light, back)]

frame = report["frame"]
worst = covered = 0
for y in range(frame["height"]):
    for x in range(frame["width"]):
        shown = raw[frame["row_bytes"] * y + 3 * x:][:3]
        worst = max([worst] + [abs(a - b) for a, b in zip(pixel(x, y), shown)])
        covered += any(s != b for s, b in zip(shown, frame["background"]))
print("# worst", worst, "covered", covered)
assert worst <= 1 and covered > 80
END
again() { # again NAME INPUT OPTION...
    name=$1
    shift
    "$QVOL" render "$@" -o a.raw --size 32x28 --termination 0 --json=a.json
    check "valid: $name" "$PYTHON" -m json.tool a.json
    check "computed again: $name" "$PYTHON" again.py a.json a.raw
}
again "nearest" in_12x10x8_uint8.raw --tf surface --sampling nearest --azimuth 25 --elevation 15 --window 10:200
again "weighted, phase, step" in_12x10x8_uint8.raw --tf surface --azimuth 25 --step 0.7 --phase 0.3
again "perspective, background" in_12x10x8_uint8.raw --tf rainbow --perspective 40 --roll 20 --background 204060
again "weighted by length" in_12x10x8_uint8.raw --tf surface --azimuth 25 --step 0.7 --phase 0.3 --unit-distance 1.5
again "extinction, large steps" in_12x10x8_uint8.raw --tf surface --azimuth 25 --elevation 8 --step 1.7 --sampling extinction
again "extinction in storage, perspective" in_12x10x8_uint8.raw --tf surface --perspective 40 --step 0.6 \
    --unit-distance 2 --storage rgbt16 --spacing 1x1x1.5
again "a palette of extinction" in_12x10x8_uint8.raw --tf rainbow --roll 20 --storage indexed8 --palette-bits 16 \
    --extinction 3 --phase 0.9
again "reoriented floats, scaled" a.nii --tf surface --elevation 30 --spacing 1x1.5x1
check "checksum of the device's bytes" "$PYTHON" -c '
import json, zlib
assert int(json.load(open("a.json"))["frame"]["crc32"], 16) == zlib.crc32(open("a.raw", "rb").read())'
"$QVOL" render in_12x10x8_uint8.raw -o a.raw --size 24x20 --json >stdout.json
"$QVOL" render in_12x10x8_uint8.raw -o b.raw --size 24x20 --json=- --threads 2 >dash.json
check "--json and --json=- are the same report" "$PYTHON" -c '
import json
a, b = json.load(open("stdout.json")), json.load(open("dash.json"))
a["statistics"].pop("seconds"), b["statistics"].pop("seconds")
assert a == b'
"$QVOL" render in_12x10x8_uint8.raw -o a.raw --size 24x20 --shade --light 10,20 --perspective 30 --order \
    back-to-front --storage rgba8 --format rgb565be --json >full.json
check "every number is there" "$PYTHON" -c '
import json
r = json.load(open("full.json"))
def whole(*values):
    return all(isinstance(v, int) for v in values)
assert r["volume"]["storage"] == "rgba8" and r["frame"]["format"] == "rgb565be"
assert r["sampling"]["order"] == "back-to-front" and r["camera"]["kind"] == "perspective"
assert whole(*(v for k in ("origin", "across", "down", "along", "pace") for v in r["camera"][k]))
assert whole(r["camera"]["step_q16"], r["volume"]["unit_distance_q16"], r["sampling"]["phase_q16"])
assert len(r["transfer"]["table"]) == 256 and whole(*(v for row in r["transfer"]["table"] for v in row))
assert whole(*r["shading"]["light"], *r["shading"]["viewer"], r["shading"]["gloss"])
assert r["frame"]["bytes"] == 24 * 20 * 2 and len(r["frame"]["crc32"]) == 8
s = r["statistics"]
assert s["samples"] > s["skipped"] >= 0 and s["rays"] == 480 and s["seconds"] >= 0'
"$QVOL" render in_12x10x8_uint8.raw -o a.raw --size 24x20 --tf surface --sampling bspline-extinction --level 1.5 \
    --storage rgbt8 --unit-distance 2 --json >levels.json
check "sampling, unit distance, extinction and level are named" "$PYTHON" -c '
import json
r = json.load(open("levels.json"))
s, v = r["sampling"], r["volume"]
assert (s["mode"], s["by_length"], s["level_q8"], s["level_distance"]) == ("bspline-extinction", True, 384, 0)
assert v["storage"] == "rgbt8" and v["unit_distance_q16"] == 131072 and v["extinction_q16"] > 65536
assert r["transfer"]["channels"] == "rgbt" and r["pyramid"]["filter"] == "quad4"
assert r["pyramid"]["domain"] == "extinction" and [l["size"] for l in r["pyramid"]["levels"]] == [
    [6, 5, 4], [3, 3, 2], [2, 2, 1], [1, 1, 1]]'
"$QVOL" render in_12x10x8_uint8.raw -o a.raw --size 24x20 --mask in_12x10x8_uint8.raw --mask-tf surface \
    --json >mask.json
check "the mask is reported as the input is" "$PYTHON" -c '
import json
r = json.load(open("mask.json"))
assert r["mask"]["transfer"]["name"] == "surface" and r["transfer"]["name"] == "grey"
assert r["mask"]["scalars"] == r["scalars"] and len(r["mask"]["transfer"]["table"]) == 256'
"$QVOL" render in_12x10x8_uint8.raw -o - --size 24x20 --json=report.json >picture.pam
check "picture on standard output, report in a file" sh -c \
    'head -c 2 picture.pam | grep -q P7 && "$1" -m json.tool report.json' - "$PYTHON"
printf 'no UTF-8: \377 "quoted" \\' >name
cp in_12x10x8_uint8.raw "$(cat name)_12x10x8_uint8.raw"
"$QVOL" render "$(cat name)_12x10x8_uint8.raw" -o a.raw --size 8x8 --json >odd.json
check "odd file names" "$PYTHON" -m json.tool odd.json
finish
