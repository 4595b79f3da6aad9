#!/bin/sh
# Pictures of FreeVoxel files, and light from outside in `qvol splat` and `qvol render`.
. tests/command/common
cd "$work" || exit 1
"$PYTHON" - <<'PY'
from volumes import *
write("in_12x10x8_uint8.raw", packed(blob()))
write("big_40x36x30_uint8.raw", packed(blob((40, 36, 30))))
write("even_16x16x16_uint8.raw", packed([200] * 4096))
write("shell_9x9x9_uint8.raw", packed([255 if max(abs(i % 9 - 4), abs(i // 9 % 9 - 4), abs(i // 81 - 4)) == 4 else 0
                                       for i in range(729)]))
write("thin.tf", b"0 250 120 60 0\n19 250 120 60 0\n20 250 120 60 .02\n255 90 240 60 .05\n")
write("even.tf", b"0 255 255 255 .02\n255 255 255 255 .02\n")
write("dense.tf", b"0 255 255 255 .2\n255 255 255 255 .2\n")
write("solid.tf", b"0 255 255 255 0\n254 255 255 255 0\n255 255 255 255 1\n")
PY
IN=in_12x10x8_uint8.raw
BIG=big_40x36x30_uint8.raw
EVEN=even_16x16x16_uint8.raw
VIEW="--size 60x50 --azimuth 20 --elevation 10"

make_file() { # make_file FILE IN TF OPTION...
    file=$1 in=$2 tf=$3
    shift 3
    "$QVOL" freevoxel "$in" -o "$file" --tf "./$tf.tf" "$@"
}
draw() { # draw OUT FILE OPTION...
    out=$1 in=$2
    shift 2
    rm -f "$out"
    # shellcheck disable=SC2086
    "$QVOL" splat "$in" -o "$out" $VIEW "$@"
}
python() { # python NAME ARGUMENT...: the program on standard input succeeds; it may use `pixels`
    name=$1
    shift
    cat >check.py
    check "$name" "$PYTHON" check.py "$@"
}
cat >pixels.py <<'END'
def pixels(name, size=(60, 50), channels=4):
    """Rows of raw rgba8888, or of as many channels."""
    data = open(name, "rb").read()
    assert len(data) == size[0] * size[1] * channels
    row = size[0] * channels
    return [[tuple(data[y * row + x * channels:y * row + (x + 1) * channels]) for x in range(size[0])] for y in range(size[1])]


def sums(name, channels=3):
    return [sum(pixel[c] for row in pixels(name, channels=channels) for pixel in row) for c in range(channels)]
END
cat >angles.py <<'PY'
from pixels import *
def half(name, chosen):
    return sum(pixel[0] for y, row in enumerate(pixels(name, channels=3)) for x, pixel in enumerate(row) if chosen(x, y))
assert half("up.raw", lambda x, y: y < 25) > 2 * half("up.raw", lambda x, y: y >= 25)
assert half("right.raw", lambda x, y: x >= 30) > 2 * half("right.raw", lambda x, y: x < 30)
assert half("before.raw", lambda x, y: True) > 2 * half("behind.raw", lambda x, y: True)
PY
PYTHONPATH=$PYTHONPATH:$work
make_file a.fv $IN thin
make_file big.fv $BIG thin
make_file big-m.fv $BIG thin --order morton
make_file big-h.fv $BIG thin --order hilbert --levels 3
make_file even.fv $EVEN even --storage rgba16

# ---- One picture ----------------------------------------------------------------

for what in "" "--interpolation nearest" "--kernel linear" "--perspective 40 --zoom 2" "--perspective 100 --zoom 6" "--splatting over" \
    "--level 2" "--levels --detail 2" "--light 70,30,ff8040 --light=-30,-10,4080ff --ambient 202020" \
    "--splatting over --light 70,30,ff8040" "--format rgb565le --background 102030"; do
    # shellcheck disable=SC2086
    draw one.raw big.fv --threads 1 $what
    for file in big.fv big-m.fv big-h.fv; do
        for threads in 2 5; do
            # shellcheck disable=SC2086
            draw other.raw $file --threads $threads $what
            check "the same picture: $file, $threads threads, ${what:-as it is}" cmp one.raw other.raw
        done
    done
done
"$QVOL" splat big.fv -o one.raw --size 9x3 --threads 7 --splatting over
"$QVOL" splat big.fv -o other.raw --size 9x3 --threads 1 --splatting over
check "more threads than rows" cmp one.raw other.raw
draw one.raw a.fv --background transparent --zoom 4 --part 1/1
draw other.raw a.fv --background transparent --zoom 4
check "--part 1/1 is all" cmp one.raw other.raw
for part in 1 2 3; do
    draw part$part.raw a.fv --background transparent --zoom 4 --part $part/3
done
python "three parts add up to the whole, but for what each rounds" <<'PY'
from pixels import *
whole, parts = pixels("other.raw"), [pixels(f"part{k}.raw") for k in (1, 2, 3)]
worst = max(abs(whole[y][x][c] - sum(part[y][x][c] for part in parts)) for y in range(50) for x in range(60) for c in range(4))
assert worst <= 2 and all(any(pixel[3] > 1 for row in part for pixel in row) for part in parts), worst
PY

# ---- What it shows ----------------------------------------------------------------

for what in "" "--azimuth 90" "--elevation 90" "--kernel linear" "--perspective 1"; do
    # shellcheck disable=SC2086
    "$QVOL" splat even.fv -o even.raw --size 60x50 --background transparent $what
    python "a homogeneous medium has its opacity: ${what:-along y}" <<'PY'
from pixels import *
exact = 255 * (1 - .98 ** 16)
middle = [pixels("even.raw")[y][x] for y in range(20, 30) for x in range(25, 35)]
print(exact, min(middle), max(middle))
assert all(abs(level - exact) <= 1 for pixel in middle for level in pixel)
PY
done
draw one.raw even.fv --background transparent
"$QVOL" render $EVEN --tf ./even.tf --unit-distance 1 --sampling extinction --background transparent -o rays.raw \
    --size 60x50 --azimuth 20 --elevation 10
python "between directions it is about that of ray casting" <<'PY'
from pixels import *
splats, rays = pixels("one.raw"), pixels("rays.raw")
assert all(abs(splats[y][x][3] - rays[y][x][3]) <= 3 for y in range(22, 28) for x in range(27, 33))
PY
make_file dense.fv $EVEN dense
draw one.raw dense.fv
draw other.raw dense.fv --splatting over
differs "over leaks" one.raw other.raw
draw one.raw a.fv
draw other.raw a.fv --interpolation nearest
differs "nearest shows between directions" one.raw other.raw
"$QVOL" splat a.fv -o one.raw --size 60x50
"$QVOL" splat a.fv -o other.raw --size 60x50 --interpolation nearest
check "--interpolation nearest is the same along one" cmp one.raw other.raw
draw one.raw a.fv --level 2
draw other.raw a.fv
differs "--level takes another" one.raw other.raw
draw level.raw a.fv --levels --detail 0.00390625
check "voxels that are too wide are drawn of the finest level" cmp level.raw other.raw
draw one.pam a.fv --level 4
draw other.pam a.fv --levels --detail 255
check "narrow enough, there is one voxel left" "$QVOL" compare one.pam other.pam --tolerance 1
make_file other.fv $IN thin --uncorrected
draw one.raw a.fv
draw other.raw other.fv
differs "--uncorrected shows at an angle" one.raw other.raw
make_file y.fv $IN thin --directions -y
check "one direction draws its own view" "$QVOL" splat y.fv -o y.raw --size 60x50
"$QVOL" splat a.fv -o one.raw --size 60x50
check "as all of them do" cmp y.raw one.raw

# ---- Light ----------------------------------------------------------------------

draw other.raw a.fv
for light in "--light 0,0,000000 --ambient ffffff" "--light 120,10,000000 --light 0,90,000000 --ambient ffffff"; do
    # shellcheck disable=SC2086
    draw one.raw a.fv $light
    check "ambient white is no light: $light" cmp one.raw other.raw
done
draw red.raw even.fv --light 90,0,ff0000
draw dark.raw even.fv --light 90,0,000000
python "red light is red, no light black, and what is near the light bright" <<'PY'
from pixels import *
red, green, blue = sums("red.raw")
assert red > 10000 and green == blue == 0 and sums("dark.raw") == [0, 0, 0]
PY
"$QVOL" splat dense.fv -o up.raw --size 60x50 --light 0,90,ffffff
"$QVOL" splat dense.fv -o right.raw --size 60x50 --light 90,0,ffffff
"$QVOL" splat dense.fv -o behind.raw --size 60x50 --light 180,0,ffffff
"$QVOL" splat dense.fv -o before.raw --size 60x50 --light 0,0,ffffff
check "light comes from where the angles say" "$PYTHON" angles.py
draw two.raw even.fv --light 90,0,800000 --light 0,90,000080
python "lights add up" <<'PY'
from pixels import *
red, green, blue = sums("two.raw")
assert red > 5000 and blue > 5000 and green == 0
PY
render() { # render OUT OPTION...
    out=$1
    shift
    # shellcheck disable=SC2086
    "$QVOL" render $EVEN --tf ./dense.tf --size 60x50 -o "$out" "$@"
}
render up.raw --light 0,90,ffffff
render right.raw --light 90,0,ffffff --storage indexed8 --threads 3
render before.raw --light 0,0,ffffff --storage rgbt16 --level 0.5
render behind.raw --light 180,0,ffffff --storage rgba8 --compositing slices
check "rays see light from where the angles say" "$PYTHON" angles.py
render one.raw --light 33,44,ffc080 --light 200,-10,2040ff --ambient 101010 --spacing 1x2x3 --threads 1
render other.raw --light 33,44,ffc080 --light 200,-10,2040ff --ambient 101010 --spacing 1x2x3 --threads 4
check "threads change no byte of lit rays" cmp one.raw other.raw
render other.raw --spacing 1x2x3
render one.raw --light 33,44,000000 --ambient ffffff --spacing 1x2x3
check "rays: ambient white is no light" cmp one.raw other.raw

# ---- Reports -----------------------------------------------------------------------

draw a.png a.fv --json=a.json --light 90,0,ff0000 --kernel linear
draw a.raw a.fv --json=raw.json --light 90,0,ff0000 --kernel linear --threads 3
python "the report tells the scene, and the checksum of the bytes" <<'PY'
import json, zlib
report, raw = json.load(open("a.json")), json.load(open("raw.json"))
assert report["frame"] == raw["frame"] and int(raw["frame"]["crc32"], 16) == zlib.crc32(open("a.raw", "rb").read())
assert report["splatting"]["kernel"] == "linear" and report["lighting"]["lamps"][0]["colour"] == [65535, 0, 0]
assert report["lighting"]["lamps"][0]["direction"] == [32767, 0, 0]
assert report["statistics"]["voxels_with_opacity"] == raw["statistics"]["voxels_with_opacity"] > 100
assert raw["memory"]["sums_bytes"] == 3 * 60 * 50 * 16 and report["freevoxels"]["order"] == "linear"
assert report["view"]["pitch_q16"] > 0
PY
"$QVOL" render $IN -o a.raw --light 90,0,ff0000 --json=r.json
check "render reports its lights, too" grep -q '"direction": \[32767, 0, 0\]' r.json

# ---- What is refused ---------------------------------------------------------------

splat_refuses() { # splat_refuses NAME PATTERN OPTION...
    name=$1 pattern=$2
    shift 2
    refuses "$name" 2 "qvol splat: $pattern" "$QVOL" splat a.fv -o refused.raw "$@"
}
refuses "no output" 2 "--output: is missing" "$QVOL" splat a.fv
refuses "no file" 2 "operands: 0 given" "$QVOL" splat -o a.raw
refuses "an unknown ending" 2 "--output: 'a.jpg'" "$QVOL" splat a.fv -o a.jpg
for light in 1,2 1,2,3 1,2,fffffg 1,2,fffffff ,2,ffffff 1,x,ffffff 1,2,3,ffffff "" 1e9,0,ffffff nan,0,ffffff; do
    splat_refuses "--light '$light'" "--light: '$light' is not AZ,EL,RRGGBB" --light "$light"
done
splat_refuses "five lights" "--light: more than 4" --light 1,1,ffffff --light 1,1,ffffff --light 1,1,ffffff \
    --light 1,1,ffffff --light 1,1,ffffff
splat_refuses "--ambient of two digits" "--ambient: '20' is not RRGGBB" --ambient 20
splat_refuses "--ambient alone" "--ambient: needs --light" --ambient 202020
splat_refuses "--detail alone" "--detail: needs --levels" --detail 2
splat_refuses "--detail 0" "--detail: " --levels --detail 0
splat_refuses "--detail 256" "--detail: " --levels --detail 256
splat_refuses "--levels back to front" "--levels: needs --splatting added" --levels --splatting over
splat_refuses "--part back to front" "--part: needs --splatting added" --part 1/2 --splatting over
for part in 0/2 3/2 1 1/ /2 1/0 -1/2 1/2/3 1x/2 1/4294967296; do
    splat_refuses "--part $part" "--part: '$part' is not K/N" --part $part
done
splat_refuses "an unknown splatting" "--splatting: .*added, over" --splatting under
splat_refuses "an unknown kernel" "--kernel: .*linear, quadratic" --kernel cubic
splat_refuses "a level that is not there" "--level: 5, a.fv has 4" --level 5
splat_refuses "half a level" "--level: " --level 1.5
splat_refuses "levels above the last" "--levels: a.fv has no levels above 4" --levels --level 4
splat_refuses "a view that is too far away" "view: " --zoom 0.001 --size 4x4
splat_refuses "options of rays" "--step: unknown" --step 0.5
refuses "a view between directions that are missing" 1 "y.fv: directions: one that the view or a light needs" \
    "$QVOL" splat y.fv -o refused.raw --azimuth 20
refuses "a light from a direction that is missing" 1 "y.fv: directions: one that" \
    "$QVOL" splat y.fv -o refused.raw --light 90,0,ffffff
make_file shell.fv shell_9x9x9_uint8.raw solid
refuses "an eye where no light gets out" 2 "view: eye in the volume" "$QVOL" splat shell.fv -o refused.raw \
    --perspective 90 --zoom 100
refuses "light from outside without its colour" 2 "--light: needs --shade" "$QVOL" render $IN -o refused.raw --light 1,2
refuses "--ambient of rays alone" 2 "--ambient: needs --light" "$QVOL" render $IN -o refused.raw --ambient 202020
"$QVOL" pyramid $IN -o levels.bin --storage rgba8
refuses "levels that are there and stay unlit" 2 "--light: the input has its levels already" "$QVOL" render levels.bin \
    --dims 12x10x8 --type rgba8 --level 1 -o refused.raw --light 1,2,ffffff
check "no picture is left of what was refused" sh -c '! ls | grep -e "^refused" -e "\.tmp$"'
finish
