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
    "classify $IN -o a.bin --reduce 2x1x3"; do
    # shellcheck disable=SC2086
    check "no leak: $command" "$program" $command
done
cat >fuzz.py <<'END'
"""fuzz.py PROGRAM COUNT: runs seeded mutations, prints what went wrong."""
import os
import random
import subprocess
import sys
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
if png:
    seeds.append(("j.png", png, len(png), ["compare", "j.png", "j.png"]))
write("plain_12x10x8_uint8.raw", packed(values))
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

wrong = accepted = 0
for number in range(count):
    chance = random.Random(number)
    name, good, head, command = seeds[number % len(seeds)]
    bad = mutate(good, head, chance) if number >= len(seeds) else good
    if name.endswith(".gz"):
        bad = gzip.compress(bad)
        if number % 3 == 0 and number >= len(seeds):
            bad = mutate(bad, len(bad), chance)
    write(name, bad)
    try:
        run = subprocess.run([program] + command, capture_output=True, timeout=30, stdin=subprocess.DEVNULL)
        status, said = run.returncode, run.stderr
    except subprocess.TimeoutExpired:
        status, said = "hangs", b""
    accepted += status == 0
    lines = said.count(b"\n")
    if not (status == 0 and lines == 0 or status in (1, 2) and lines == 1 and said.endswith(b"\n")):
        wrong += 1
        print(f"# mutation {number} of {name}: status {status}, {said[-600:]!r}")
        write(f"wrong-{number}-{name}", bad)
print(f"# {count} mutations, {accepted} accepted, {wrong} wrong")
sys.exit(wrong > 0 or accepted < len(seeds) or accepted > count // 2)
END
"$PYTHON" fuzz.py "$program" "$MUTATIONS" >report
status=$?
grep '^# [0-9]' report
grep '^# mutation' report >&2
[ -z "${KEEP_WRONG:-}" ] || cp wrong-* "$KEEP_WRONG" 2>/dev/null
outcome $status "$MUTATIONS mutated files: no crash, no hang, one line"
finish
