#!/bin/sh
# FreeVoxel files: what `qvol freevoxel` writes, and what is refused as one.
. tests/command/common
cd "$work" || exit 1
export QVOL
"$PYTHON" - <<'PY'
from volumes import *
write("in_12x10x8_uint8.raw", packed(blob()))
write("slab_16x16x16_uint8.raw", packed([200 if i // 256 == 15 else 100 for i in range(4096)]))
write("one_1x1x1_uint8.raw", b"\xc8")
write("long_600x2x3_uint8.raw", bytes(i * 7 % 256 for i in range(3600)))
write("thin.tf", b"0 250 120 60 0\n19 250 120 60 0\n20 250 120 60 .02\n255 90 240 60 .05\n")
write("solid.tf", b"0 255 255 255 0\n120 255 255 255 0\n121 255 255 255 1\n255 255 255 255 1\n")
PY
IN=in_12x10x8_uint8.raw

make_file() { # make_file FILE IN OPTION...
    file=$1 in=$2
    shift 2
    rm -f "$file"
    "$QVOL" freevoxel "$in" -o "$file" --tf ./thin.tf "$@"
}
python() { # python NAME: the program on standard input succeeds
    cat >check.py
    check "$1" "$PYTHON" check.py
}

# ---- What is written ----------------------------------------------------------

make_file a.fv $IN --json=a.json
cat >attenuation.py <<'END'
"""attenuation.py FILE: its bytes, of coarser levels too, against real arithmetic."""
import sys
from freevoxel_file import *
file, worst, coarser = File(sys.argv[1]), 0, 0
assert file.order == "linear"
records = [file.records(level) for level in range(file.coarser + 1)]
for slot, d in enumerate(file.directions):
    depths = file.depths(d)
    for place, depth in depths.items():
        byte = records[0][linear(place, file.size)][1][slot]
        worst = max(worst, abs(byte - 255 * 2 ** -depth))
    for level in range(1, file.coarser + 1) if file.hierarchy == 1 else ():
        nx, ny, nz = size = file.levels[level][2]
        for place in ((x, y, z) for z in range(nz) for y in range(ny) for x in range(nx)):
            byte = records[level][linear(place, size)][1][slot]
            coarser = max(coarser, abs(byte - 255 * 2 ** -mean_depth(depths, file.size, level, place)))
print("worst", worst, coarser)
assert worst <= .51 and coarser <= .51
assert file.size == (1, 1, 1) or any(byte != 255 for _, row in records[0] for byte in row)
END
for what in "" "--uncorrected" "--unit-distance 2.5" "--spacing 1x2x3" "--storage rgba8 --directions +x,-y,+x-z" \
    "--storage rgba16" "--palette-bits 16" "--storage rgbt8 --extinction 0.3" "--storage rgbt16 --extinction 2" \
    "--extinction auto" "--hierarchy geometric" "--hierarchy geometric --unit-distance 2.5" "--tf ./solid.tf" "--levels 0" "--levels 2 --filter quad4 --domain opacity"; do
    # shellcheck disable=SC2086
    make_file b.fv $IN $what
    check "attenuation in real arithmetic: ${what:-as it is}" "$PYTHON" attenuation.py b.fv
done
make_file b.fv one_1x1x1_uint8.raw
check "a single voxel" "$PYTHON" attenuation.py b.fv
make_file b.fv long_600x2x3_uint8.raw
check "levels with voxels wider than the library's spacings" "$QVOL" splat b.fv --level 10 --zoom 4 -o b.pam

python "the report and info tell what the file holds" <<'PY'
import json, os, subprocess
from freevoxel_file import *
file, report = File("a.fv"), json.load(open("a.json"))
own = report["freevoxels"]
assert own["bytes"] == os.path.getsize("a.fv") and own["order"] == "linear" and own["hierarchy"] == "rebuilt"
assert [(l["offset"], l["record_bytes"], tuple(l["size"])) for l in own["levels"]] == [l[:3] for l in file.levels]
assert len(own["directions"]) == 26 and own["levels"][0]["record_bytes"] == 27

def step(name):
    told = dict(zip(name[1::2], name[::2]))
    return tuple({"+": 1, "-": -1}.get(told.get(axis), 0) for axis in "xyz")

assert [step(name) for name in own["directions"]] == STEPS
qvol = os.environ["QVOL"]
info = json.loads(subprocess.run([qvol, "info", "a.fv", "--json"], capture_output=True, check=True).stdout)
assert info["freevoxels"] == own and info["input"]["size"] == [12, 10, 8]
text = subprocess.run([qvol, "info", "a.fv"], capture_output=True, check=True, text=True).stdout
assert "12 x 10 x 8, 960 voxels of 27 bytes at 1344" in text and "order        linear" in text, text
PY

make_file m.fv $IN --order morton
make_file h.fv $IN --order hilbert
python "Morton order has the records of linear order, sorted by interleaved bits" <<'PY'
from freevoxel_file import *
a, m = File("a.fv"), File("m.fv")
assert m.order == "morton" and len(a.levels) == len(m.levels) == 5
for level in range(5):
    size, records = a.levels[level][2], a.records(level)
    assert m.records(level) == [records[linear(p, size)] for p in morton_sorted(size)]
PY
python "Hilbert order has the records of linear order, each once" <<'PY'
from freevoxel_file import *
a, h = File("a.fv"), File("h.fv")
assert h.order == "hilbert" and a.records() != h.records()
assert all(sorted(h.records(level)) == sorted(a.records(level)) for level in range(5))
PY
make_file s.fv $IN --directions +x,-x-y+z,-y
python "a set of directions has the bytes of these alone, lowest number first" <<'PY'
from freevoxel_file import *
a, s = File("a.fv"), File("s.fv")
assert [STEPS[d] for d in s.directions] == [(0, -1, 0), (1, 0, 0), (-1, -1, 1)]
for level in range(5):
    assert s.records(level) == [(v, bytes(row[d] for d in s.directions)) for v, row in a.records(level)]
PY
make_file b.fv $IN --directions faces
check "the faces are six" sh -c '"$1" info b.fv | grep -q "^directions   6: -z -y -x +x +y +z$"' - "$QVOL"
for threads in 1 2 7; do
    make_file b.fv $IN --threads $threads
    check "--threads $threads changes no byte" cmp a.fv b.fv
done
make_file g.fv $IN --hierarchy rebuilt --order linear --directions all --levels 4
check "what is left out is as it would be by default" cmp a.fv g.fv
make_file r.fv $IN --hierarchy geometric
python "levels of means have the same voxels and other light" <<'PY'
from freevoxel_file import *
a, r = File("a.fv"), File("r.fv")
assert r.hierarchy == 1 and a.records(0) == r.records(0)
for level in range(1, 5):
    assert [voxel for voxel, _ in a.records(level)] == [voxel for voxel, _ in r.records(level)]
differences = [abs(p - q) for (_, row), (_, other) in zip(a.records(1), r.records(1)) for p, q in zip(row, other)]
assert 1 <= max(differences) and sum(differences) / len(differences) < 16, differences
PY
make_file z.fv slab_16x16x16_uint8.raw --tf ./solid.tf
python "behind an opaque slab nothing passes; before it all does" <<'PY'
from freevoxel_file import *
z = File("z.fv")
up, down = z.directions.index(21), z.directions.index(4)
for i, (voxel, row) in enumerate(z.records()):
    assert row[down] == 255 and row[up] == (255 if i // 256 == 15 else 0)
PY
make_file b.fv $IN --levels 0
check "without levels the file says so" sh -c '"$1" info b.fv | grep -q "^hierarchy    none$"' - "$QVOL"
make_file b.fv $IN --storage rgba16 --filter quad4
"$QVOL" pyramid $IN -o levels.bin --tf ./thin.tf --storage rgba16 --filter quad4 --endian big
"$QVOL" freevoxel levels.bin --dims 12x10x8 --type rgba16be -o c.fv
check "levels that the input has are taken" cmp b.fv c.fv
: >linked.fv
ln -s linked.fv link.fv
"$QVOL" freevoxel $IN --tf ./thin.tf -o link.fv
check "a link stays, and what it leads to is replaced" sh -c 'test -L link.fv && cmp linked.fv a.fv'

# ---- What is refused ----------------------------------------------------------

make_refuses() { # make_refuses NAME PATTERN OPTION...
    name=$1 pattern=$2
    shift 2
    refuses "$name" 2 "qvol freevoxel: $pattern" "$QVOL" freevoxel $IN -o refused.fv "$@"
}
refuses "no output" 2 "--output: is missing" "$QVOL" freevoxel $IN
refuses "standard output" 2 "--output: a file that is mapped" "$QVOL" freevoxel $IN -o -
refuses "a device as output" 1 "/dev/null: no regular file" "$QVOL" freevoxel $IN -o /dev/null
refuses "report and file of one name" 2 "--json" "$QVOL" freevoxel $IN -o refused.fv --json=refused.fv
refuses "a folder that is not there" 1 "none/b.fv: No such" "$QVOL" freevoxel $IN -o none/b.fv
for list in "" x +x+x "+x," ,+x +w + all,+x "+x +y" +x+y+z+x; do
    make_refuses "--directions '$list'" "--directions: '$list' is not all" --directions "$list"
done
make_refuses "an unknown order" "--order: .*linear, morton, hilbert" --order peano
make_refuses "an unknown hierarchy" "--hierarchy: .*geometric, rebuilt" --hierarchy mean
make_refuses "too many levels" "--levels: 5, the volume has 4" --levels 5
make_refuses "more levels than any volume" "--levels: " --levels 13
refuses "--filter of levels that are there" 2 "--filter: the input has its levels" "$QVOL" freevoxel levels.bin \
    --dims 12x10x8 --type rgba16be -o refused.fv --filter box2
make_refuses "--hierarchy without levels" "--hierarchy: needs --levels" --levels 0 --hierarchy geometric
make_refuses "--filter without levels" "--filter: needs" --levels 0 --filter box4
make_refuses "rebuilt without lengths" "--hierarchy: needs lengths" --hierarchy rebuilt --uncorrected
make_refuses "--uncorrected with a length" "--uncorrected: needs" --uncorrected --unit-distance 2
make_refuses "--uncorrected of extinction" "--uncorrected: extinction" --uncorrected --storage rgbt8
make_refuses "a unit distance of too many steps" "--unit-distance: " --unit-distance 0.00390625 --spacing 1x1x16
make_refuses "light from outside" "--light: needs qvol render or qvol splat" --light 1,2,ffffff
(
    ulimit -f 8
    "$QVOL" freevoxel $IN -o full.fv >said 2>&1
)
check "a disk that is full is found out" test $? -eq 1 -a "$(wc -l <said)" -eq 1 -a ! -e full.fv
check "nothing is left of what was refused" sh -c '! ls | grep -e "\.tmp$" -e "^refused"'

cat >mutate.py <<'END'
"""Makes bad files bad-NAME.fv of a.fv, and prints what is to be said about each: NAME PATTERN."""
import struct
from freevoxel_file import *
good = open("a.fv", "rb").read()

def bad(name, data, pattern):
    open(f"bad-{name}.fv", "wb").write(data)
    print(name, pattern)

def field(name, place, form, value, pattern):
    data = bytearray(good)
    struct.pack_into("<" + form, data, place, value)
    bad(name, with_checksum(data), pattern)

def changed(name, place, pattern):
    bad(name, good[:place] + bytes([good[place] ^ 1]) + good[place + 1:], pattern)

bad("empty", b"", "length: 0 bytes")
bad("foreign", open("in_12x10x8_uint8.raw", "rb").read(), "format: no FreeVoxel file")
bad("text", good.replace(b"\r\n", b"\n", 1), "format: no FreeVoxel file")
bad("short", good[:5], "format: no FreeVoxel file")
bad("start", good[:8], "header: 8 of 280 bytes")
bad("fixed", good[:279], "header: 279 of 280 bytes")
bad("palette-cut", good[:1000], "header bytes: 1304, the file has 1000")
bad("records-cut", good[:-1], f"total bytes: {len(good)}, the file has {len(good) - 1}")
bad("header-only", good[:1344], f"total bytes: {len(good)}, the file has 1344")
bad("longer", good + b"\0", f"total bytes: {len(good)}, the file has {len(good) + 1}")
changed("size", 24, "checksum: is not the header")
changed("palette", 500, "checksum: is not the header")
changed("checksum", 276, "checksum: is not the header")
field("version", 8, "I", 2, "version: 2, only 1 is known")
field("header-small", 12, "I", 279, "header bytes: 279")
field("header-large", 12, "I", 1 << 31, "header bytes: 2147483648")
field("header-other", 12, "I", 280, "palette bytes: 1024, the storage takes 1024")
field("total", 16, "Q", 1 << 63, "total bytes: 9223372036854775808")
field("size-0", 24, "H", 0, "size: 0 voxels on axis 0")
field("size-most", 28, "H", 4097, "size: 4097 voxels on axis 2")
field("size-other", 24, "H", 13, "total bytes: is not what")
field("storage-0", 30, "B", 0, "storage: 0 is unknown")
field("storage-9", 30, "B", 9, "storage: 9 is unknown")
field("storage-other", 30, "B", 4, "palette bytes: 1024, the storage takes 2048")
field("storage-t", 30, "B", 7, "extinction: is 0")
field("order", 31, "B", 3, "order: 3 is unknown")
field("spacing", 36, "I", 4095, "spacing: .* on axis 1")
field("extinction", 48, "I", 1, "extinction: of opacities")
field("directions-0", 52, "I", 0, "directions: the set 00000000")
field("directions-26", 52, "I", 1 << 26, "directions: the set 04000000")
field("directions-fewer", 52, "I", 0x1FFFFFF, "total bytes: is not what")
field("levels", 56, "B", 5, "levels: 5, the size has 4")
field("levels-fewer", 56, "B", 3, "total bytes: is not what")
field("levels-none", 56, "B", 0, "hierarchy: 2 with 0 levels")
field("hierarchy", 57, "B", 3, "hierarchy: 3 with 4 levels")
field("palette-none", 58, "H", 0, "palette bytes: 0, the storage takes 1024")
field("zero", 60, "I", 1, "layout: is not what")
field("offset", 80, "Q", 0, "layout: is not what")
field("record", 72, "H", 26, "layout: is not what")
field("level-9", 208, "Q", 64, "layout: is not what")
END
"$PYTHON" mutate.py >mutations
check "bad files were made" test "$(wc -l <mutations)" -ge 40
while read -r name pattern; do
    refuses "a file with a bad $name" 1 "qvol splat: bad-$name.fv: $pattern" "$QVOL" splat "bad-$name.fv" -o a.raw
done <mutations
refuses "a folder" 1 "\.: no regular file" "$QVOL" splat . -o a.raw
refuses "standard input" 1 "-: No such file" "$QVOL" splat - -o a.raw
refuses "no file" 1 "none.fv: No such file" "$QVOL" splat none.fv -o a.raw
refuses "a damaged file, asked about" 1 "qvol info: bad-size.fv: checksum" "$QVOL" info bad-size.fv
refuses "a FreeVoxel file as a volume" 1 "format: neither NIfTI nor NRRD" "$QVOL" render a.fv -o a.raw
check "no picture is left" test ! -e a.raw
finish
