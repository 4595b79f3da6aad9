#!/bin/sh
# Display formats: the device's bytes, and the picture that a panel shows of them.
. tests/command/common
cd "$work" || exit 1
"$PYTHON" "$TESTS/volumes.py" in_12x10x8_uint8.raw
IN=in_12x10x8_uint8.raw
FORMATS="rgba8888 bgra8888 rgb888 rgb565le rgb565be l8 grey4 mono-horizontal mono-vertical"

cat >show.py <<'END'
"""show.py FORMAT WIDTH HEIGHT RAW PAM: decodes RAW here and compares with PAM."""
import sys
form, width, height, raw, pam = sys.argv[1:]
width, height = int(width), int(height)
raw, pam = open(raw, "rb").read(), open(pam, "rb").read()
bits = {"rgba8888": 32, "bgra8888": 32, "rgb888": 24, "rgb565le": 16, "rgb565be": 16, "l8": 8,
        "grey4": 4, "mono-horizontal": 1, "mono-vertical": 8}[form]
row = (width * bits + 7) // 8
assert len(raw) == row * ((height + 7) // 8 if form == "mono-vertical" else height), len(raw)
def spread(v, n):
    return (v * 255 + (2 ** n - 1) // 2) // (2 ** n - 1)
def straight(c, a):
    return 0 if a == 0 else min(255, (2 * 255 * c + a) // (2 * a))
def pixel(x, y):
    line = raw[row * y:row * (y + 1)]
    if form in ("rgba8888", "bgra8888"):
        c = line[4 * x:4 * x + 4]
        c = c if form[0] == "r" else bytes((c[2], c[1], c[0], c[3]))
        return [straight(v, c[3]) for v in c[:3]] + [c[3]]
    if form == "rgb888":
        return list(line[3 * x:3 * x + 3])
    if form[:6] == "rgb565":
        word = int.from_bytes(line[2 * x:2 * x + 2], "little" if form[-2:] == "le" else "big")
        return [spread(word >> 11, 5), spread(word >> 5 & 63, 6), spread(word & 31, 5)]
    if form == "l8":
        return [line[x]]
    if form == "grey4":
        return [17 * (line[x // 2] >> (0 if x % 2 else 4) & 15)]
    if form == "mono-horizontal":
        return [255 * (line[x // 8] >> (7 - x % 8) & 1)]
    return [255 * (raw[row * (y // 8) + x] >> (y % 8) & 1)]
expected = bytes(v for y in range(height) for x in range(width) for v in pixel(x, y))
depth = len(expected) // (width * height)
kind = {1: "GRAYSCALE", 3: "RGB", 4: "RGB_ALPHA"}[depth]
header = (f"P7\nWIDTH {width}\nHEIGHT {height}\nDEPTH {depth}\nMAXVAL 255\nTUPLTYPE {kind}\n"
          "ENDHDR\n").encode()
assert pam[:len(header)] == header, pam[:80]
shown = pam[len(header):]
assert len(shown) == len(expected)
worst = max(abs(a - b) for a, b in zip(shown, expected))
assert worst <= (1 if form[:6] == "rgb565" else 0), worst  # bit replication is within 1
assert len(set(shown)) > 1
END

for format in $FORMATS; do
    for size in 40x30 33x21; do
        w=${size%x*} h=${size#*x}
        args="--tf surface --format $format --size $size"
        case $format in
        *a8888) args="$args --background transparent" ;;
        esac
        # shellcheck disable=SC2086
        "$QVOL" render $IN -o a.raw $args
        # shellcheck disable=SC2086
        "$QVOL" render $IN -o a.pam $args
        check "$format $size: the panel shows the device's bytes" \
            "$PYTHON" show.py "$format" "$w" "$h" a.raw a.pam
    done
    # shellcheck disable=SC2086
    "$QVOL" render $IN -o b.bin $args --strip 8 --threads 2
    check "$format: strips and threads change no byte" cmp a.raw b.bin
    # shellcheck disable=SC2086
    "$QVOL" render $IN -o - --as raw $args >c.raw
    check "$format: the same bytes on standard output" cmp a.raw c.raw
done

# PNG holds what PAM holds.
for args in "--format rgb888" "--background transparent" "--format l8"; do
    # shellcheck disable=SC2086
    "$QVOL" render $IN -o a.pam --size 40x30 --tf surface $args
    # shellcheck disable=SC2086
    "$QVOL" render $IN -o a.png --size 40x30 --tf surface $args
    check "PNG equals PAM: $args" "$QVOL" compare a.pam a.png
    # shellcheck disable=SC2086
    "$QVOL" render $IN -o b.png --size 40x30 --tf surface $args
    check "PNG is the same each time: $args" cmp a.png b.png
done
check "PNG is read by another program" "$PYTHON" -c '
from PIL import Image
a = Image.open("a.png")
assert a.size == (40, 30) and a.mode == "L" and not a.info'
# shellcheck disable=SC2086
"$QVOL" render $IN -o - --size 40x30 --tf surface --as png --format l8 >c.png
check "PNG on standard output" cmp b.png c.png
"$QVOL" render $IN -o - --size 40x30 --tf surface --format l8 >c.pam
check "standard output takes PAM by default" cmp a.pam c.pam
"$QVOL" render $IN -o two --as pam --size 40x30 --tf surface --format l8
check "--as decides where the ending does not" cmp a.pam two

# An overlay over black is the picture over black, within rounding.
"$QVOL" render $IN -o over.raw --size 40x30 --tf fog --background transparent
"$QVOL" render $IN -o black.raw --size 40x30 --tf fog
check "associated colour over black" "$PYTHON" -c '
a, b = open("over.raw", "rb").read(), open("black.raw", "rb").read()
assert all(abs(a[4 * i + c] - b[3 * i + c]) <= 1 for i in range(1200) for c in range(3))'
finish
