#!/bin/sh
# Mutated headers and files against a build with sanitizers: none may crash, hang,
# or print anything but one line.
. tests/command/common
: "${MUTATIONS:=360}"
if ! flags=$(make -s host-flags) || [ -z "$flags" ]; then
    outcome 1 "flags of the command"
    finish
fi
program=$work/qvol
# shellcheck disable=SC2086
check "builds with sanitizers" "$CC" -std=c99 -O1 -g -fsanitize=address,undefined \
    -fno-sanitize-recover=all -Ifixedpoint core/*.c fixedpoint/*.c $flags -o "$program"
cd "$work" || exit 1
"$PYTHON" "$TESTS/volumes.py" in_12x10x8_uint8.raw
IN=in_12x10x8_uint8.raw
for command in "info $IN" "render $IN -o a.pam --shade --mask $IN --mask-tf fog --json=a.json" \
    "render $IN -o a.raw --storage indexed8" "compare a.pam a.pam -o d.pam" "classify $IN -o a.h --fit 1500" \
    "classify $IN -o a.bin --reduce 2x1x3" "classify $IN -o a.bin --storage rgbt8 --mask $IN --mask-tf fog --json" \
    "render $IN -o a.raw --level auto --json=a.json" "pyramid $IN -o a.h --storage indexed8 --extinction 9" \
    "pyramid $IN -o a.bin --storage rgba8 --json" "classify $IN -o a.h --dither-table colour --json=a.json" \
    "render $IN -o a.raw --compositing slices --slices 30 --bricks 2x3x1 --chunk 3 --dither feedback --json=a.json" \
    "render $IN -o a.raw --compositing slices --perspective 90 --framebuffer 16 --order front-to-back" \
    "render a.bin --dims 12x10x8 --type rgba8 --level 1.5 --sampling bspline-extinction -o a.raw" \
    "render $IN -o a.raw --light 10,20,ff8000 --light 0,90,ffffff --storage indexed8 --json=a.json" \
    "freevoxel $IN -o a.fv --tf surface --order hilbert --json=a.json" "info a.fv" "info a.fv --json=a.json" \
    "splat a.fv -o a.raw --levels --perspective 60 --zoom 3 --light 10,20,ff8000 --threads 3 --json=a.json" \
    "splat a.fv -o a.pam --kernel linear --part 2/3 --interpolation nearest" "splat a.fv -o a.pam --splatting over --level 1"; do
    # shellcheck disable=SC2086
    check "no leak: $command" "$program" $command
done
cat >fuzz.py <<'END'
"""fuzz.py PROGRAM COUNT: runs seeded mutations, prints what went wrong."""
import os
import random
import subprocess
import sys
from freevoxel_file import with_checksum
from volumes import *

program, count = sys.argv[1], int(sys.argv[2])
os.environ["ASAN_OPTIONS"] = "detect_leaks=0:allocator_may_return_null=1:max_allocation_size_mb=600"
values = blob()
header, data = nrrd(values, code="h")
zipped_header, zipped = nrrd(values, encoding="gzip", extra=[
    "space: left-posterior-superior", "space directions: (1,0,0) (0,1,0) (0,0,2)"])
detached = nrrd(values, data_file="good.data", extra=["byte skip: 0", "spacings: 1 1 2"])[0]
write("good.data", packed(values))
pam = b"P7\nWIDTH 12\nHEIGHT 10\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n" + bytes(480)
transfer = b"# points\n0 1 2 3 0\n100 20 30 255 0.5\n255 9 9 9 1\nshading .1 .2 .3 8 0.1\n"
png = None
try:
    from PIL import Image
    Image.frombytes("RGBA", (12, 10), bytes(range(240)) * 2).save("good.png")
    png = open("good.png", "rb").read()
except ImportError:
    pass
sform = [[0, -1, 0, 5], [1, .1, 0, 0], [0, 0, 2, 1]]
# Name, good bytes, how many of the first bytes are a header, command.
seeds = [
    ("a.nii", nifti(values, code="h", sform=sform, slope=2, inter=1), 352, ["info", "a.nii"]),
    ("b.nii", nifti(values, version=2, qform=(.1, .2, .3, 0, 0, 0)), 544, ["info", "b.nii"]),
    ("c.nii", nifti(values, code="f", order=">"), 352, ["render", "c.nii", "-o", "o.raw", "--size", "8x8"]),
    ("d.nii.gz", nifti(values), 352, ["info", "d.nii.gz"]),
    ("e.nrrd", header + data, len(header), ["info", "e.nrrd"]),
    ("f.nrrd", zipped_header + zipped, len(zipped_header) + 30, ["render", "f.nrrd", "-o", "o.raw", "--size", "8x8"]),
    ("g.nhdr", detached, len(detached), ["info", "g.nhdr"]),
    ("h.pam", pam, len(pam) - 480, ["compare", "h.pam", "h.pam"]),
    ("i.tf", transfer, len(transfer), ["render", "plain_12x10x8_uint8.raw", "--tf", "./i.tf", "-o", "o.raw", "--size", "8x8"]),
]
levelled = bytes(v // 3 for v in values for _ in range(4)) + bytes(range(143)) * 4
wide = bytes(v // 3 for v in values for _ in range(8)) + bytes(range(143)) * 8
SIZE_AND_OUTPUT = ["--dims", "12x10x8", "-o", "o.raw", "--size", "8x8"]
seeds += [
    ("k.bin", levelled, len(levelled), ["render", "k.bin", "--type", "rgba8", "--level", "1.5"] + SIZE_AND_OUTPUT),
    ("l.bin", wide, len(wide), ["render", "l.bin", "--type", "rgbt16be", "--extinction", "9", "--level", "auto"]
     + SIZE_AND_OUTPUT),
    ("m.palette", bytes(range(256)) * 4, 1024, ["render", "plain_12x10x8_uint8.raw", "--type", "indexed8",
     "--palette", "m.palette", "--extinction", "9", "--sampling", "bspline-extinction"] + SIZE_AND_OUTPUT),
]
if png:
    seeds.append(("j.png", png, len(png), ["compare", "j.png", "j.png"]))
write("plain_12x10x8_uint8.raw", packed(values))

def freevoxels(*options):
    """A FreeVoxel file of the plain volume."""
    subprocess.run([program, "freevoxel", "plain_12x10x8_uint8.raw", "-o", "good.fv", "--tf", "surface", *options], check=True)
    return open("good.fv", "rb").read()

SPLAT = ["-o", "o.raw", "--size", "8x8"]
narrow, broad = freevoxels(), freevoxels("--storage", "rgbt16", "--order", "hilbert", "--directions", "faces")
seeds += [
    ("n.fv", narrow, 280, ["splat", "n.fv", "--levels", "--azimuth", "30", "--light", "70,30,ff8040"] + SPLAT),
    ("o.fv", broad, 280, ["splat", "o.fv", "--perspective", "60", "--zoom", "4", "--interpolation", "nearest"] + SPLAT),
    ("p.fv", broad, len(broad), ["splat", "p.fv", "--splatting", "over", "--light", "0,90,ffffff"] + SPLAT),
    ("q.fv", narrow, 280, ["info", "q.fv"]),
]
NUMBERS = [b"0", b"-1", b"1e999", b"nan", b"4294967296", b"99999999999999999999", b"%n%s", b"", b"\0"]

def mutate(data, head, chance):
    data = bytearray(data)
    for _ in range(chance.choice((1, 1, 2, 4, 16))):
        place = chance.randrange(head)
        kind = chance.randrange(6)
        if kind == 0:
            data[place] = chance.choice((0, 1, 0x7f, 0x80, 0xff))
        elif kind == 1:
            data[place] ^= 1 << chance.randrange(8)
        elif kind == 2:
            word = chance.choice((b"\0\0\0\0", b"\xff\xff\xff\xff", b"\0\0\xc0\x7f", b"\0\0\x80\x7f",
                                  b"\xff\xff\xff\x7f", b"\0\0\0\x80", chance.randbytes(4)))
            data[place:place + 4] = word
        elif kind == 3:
            del data[place:place + chance.randrange(1, 9)]
        elif kind == 4:
            data[place:place] = chance.choice(NUMBERS)
        else:
            del data[chance.randrange(len(data)):]
        if not data:
            data = bytearray(b"\0")
        head = min(head, len(data))
    return bytes(data)

OPTIONS = {
    "--sampling": ("weighted", "extinction", "bspline-weighted", "bspline-extinction", "nearest", "preweighted"),
    "--storage": ("rgba8", "rgba16", "indexed8", "rgbt8", "rgbt16", "associated8"),
    "--unit-distance": ("0.00390625", "0.3", "1", "7.5", "4096", "nan"),
    "--extinction": ("auto", "0.0000152587890625", "0.2", "64", "65535", "65536"),
    "--level": ("auto", "0", "0.004", "1.5", "4", "5", "12", "-0", "1e9"),
    "--step": ("0.0625", "0.3", "1", "16"),
    "--filter": ("box2", "box4", "quad4"),
    "--domain": ("extinction", "opacity"),
    "--spacing": ("1x1x16", "1e-9x1e-9x1e-8", "0.3x0.3x1"),
    "--perspective": ("1", "40", "150"),
    "--zoom": ("0.001", "0.1", "900"),
    "--order": ("back-to-front",),
}

SLICES = {
    "--framebuffer": ("8", "12", "16", "24", "565"),
    "--dither": ("none", "random", "ordered", "bump", "rounding", "feedback"),
    "--period": ("2", "64"),
    "--slope": ("0.0000152587890625", "16,16", "0.85,0.9"),
    "--cutoff": ("1", "255"),
    "--frame": ("0", "4294967295"),
    "--chunk": ("1", "7", "65535"),
    "--slices": ("1", "2", "11", "200", "65535"),
    "--bricks": ("1x1x1", "12x10x8", "2x3x4", "13x1x1"),
    "--order": ("front-to-back", "back-to-front"),
}

FREEVOXELS = {
    "--directions": ("all", "faces", "+x", "-x-y,+z,+x+y+z"),
    "--order": ("linear", "morton", "hilbert"),
    "--levels": ("0", "1", "4", "5"),
    "--hierarchy": ("geometric", "rebuilt"),
    "--storage": OPTIONS["--storage"],
    "--extinction": OPTIONS["--extinction"],
    "--unit-distance": OPTIONS["--unit-distance"],
    "--spacing": OPTIONS["--spacing"],
    "--filter": OPTIONS["--filter"],
}

SPLATS = {
    "--splatting": ("added", "over"),
    "--kernel": ("linear", "quadratic"),
    "--level": ("0", "1", "4", "12"),
    "--detail": ("0.00390625", "3", "255.99"),
    "--part": ("1/1", "2/3", "4294967295/4294967295"),
    "--light": ("0,0,ffffff", "37,-80,0080ff"),
    "--ambient": ("000000", "ffffff"),
    "--azimuth": ("0", "45", "77"),
    "--elevation": ("0", "90", "35.26439"),
    "--perspective": OPTIONS["--perspective"],
    "--zoom": OPTIONS["--zoom"],
}

def drawn_from(chance, values):
    """A few options that are fine one by one."""
    names = chance.sample(sorted(values), chance.randrange(1, 5))
    return [word for name in names for word in (name, chance.choice(values[name]))]

def options(chance):
    """Every other time slices."""
    if chance.random() < .5:
        return drawn_from(chance, OPTIONS)
    return ["--compositing", "slices"] + drawn_from(chance, SLICES) + drawn_from(chance, OPTIONS)

def is_wrong(what, command):
    """Whether it ends otherwise than it may; and whether it was accepted."""
    try:
        run = subprocess.run([program] + command, capture_output=True, timeout=30, stdin=subprocess.DEVNULL)
        status, said = run.returncode, run.stderr
    except subprocess.TimeoutExpired:
        status, said = "hangs", b""
    lines = said.count(b"\n")
    good = status == 0 and lines == 0 or status in (1, 2) and lines == 1 and said.endswith(b"\n")
    if not good:
        print(f"# mutation {what}: status {status}, {said[-600:]!r}")
    return not good, status == 0

wrong = accepted = 0
for number in range(count):
    chance = random.Random(number)
    name, good, head, command = seeds[number % len(seeds)]
    bad = mutate(good, head, chance) if number >= len(seeds) else good
    if name.endswith(".gz"):
        bad = gzip.compress(bad)
        if number % 3 == 0 and number >= len(seeds):
            bad = mutate(bad, len(bad), chance)
    if name.endswith(".fv") and number % 4:
        bad = with_checksum(bad)
    write(name, bad)
    is_bad, is_accepted = is_wrong(f"{number} of {name}", command)
    wrong += is_bad
    accepted += is_accepted
    if is_bad:
        write(f"wrong-{number}-{name}", bad)
drawn = 0
for number in range(count // 4):
    command = ["render", "plain_12x10x8_uint8.raw", "-o", "o.raw", "--size", "8x8", "--tf", "surface"]
    command += options(random.Random(f"options {number}"))
    is_bad, is_drawn = is_wrong(" ".join(command), command)
    wrong += is_bad
    drawn += is_drawn
for number in range(count // 4):
    chance = random.Random(f"freevoxels {number}")
    make = ["freevoxel", "plain_12x10x8_uint8.raw", "-o", "drawn.fv", "--tf", "surface"] + drawn_from(chance, FREEVOXELS)
    show = ["splat", "drawn.fv", "-o", "o.raw", "--size", "9x8"] + drawn_from(chance, SPLATS) + chance.choice(([], ["--interpolation", "nearest"], ["--interpolation", "depths"], ["--levels"]))
    for command in (make, show):
        is_bad, is_drawn = is_wrong(" ".join(command), command)
        wrong += is_bad
        drawn += is_drawn
print(f"# {3 * (count // 4)} sets of options, {drawn} drawn")
wrong += drawn < count // 8
print(f"# {count} mutations, {accepted} accepted, {wrong} wrong")
sys.exit(wrong > 0 or accepted < len(seeds) or accepted > count // 2)
END
"$PYTHON" fuzz.py "$program" "$MUTATIONS" >report
status=$?
grep '^# [0-9]' report
grep '^# mutation' report >&2
[ -z "${KEEP_WRONG:-}" ] || cp wrong-* "$KEEP_WRONG" 2>/dev/null
outcome $status "$MUTATIONS mutated files, three quarters as many sets of options: no crash, no hang, one line"
finish
