#!/bin/sh
# `compare` and `info`: figures that are known.
. tests/command/common
cd "$work" || exit 1
cat >make.py <<'END'
from volumes import *
def pam(width, height, depth, data, maximum=255, extra=""):
    return (f"P7\n{extra}WIDTH {width}\nHEIGHT {height}\nDEPTH {depth}\nMAXVAL {maximum}\nENDHDR\n").encode() + bytes(data)
a = [10, 20, 30] * 8
b = list(a)
b[0], b[4], b[23] = 13, 16, 130
write("a.pam", pam(4, 2, 3, a, extra="# a comment\n"))
write("b.pam", pam(4, 2, 3, b))
write("grey.pam", pam(4, 2, 1, range(8)))
write("alpha.pam", pam(4, 2, 2, range(16)))
write("tall.pam", pam(2, 4, 3, a))
write("short.pam", pam(4, 2, 3, a[:-1]))
write("long.pam", pam(4, 2, 3, a + [1]))
write("deep.pam", pam(4, 2, 3, a, maximum=65535))
write("zero.pam", pam(0, 2, 3, a))
write("huge.pam", pam(32767, 32767, 4, a))
write("overflow.pam", pam(99999999999, 99999999999, 4, a))
write("five.pam", pam(4, 2, 5, a + a[:16]))
write("endless.pam", b"P7\nWIDTH 4\n")
write("noise.png", b"\x89PNG\r\n\x1a\n" + bytes(100))
write("empty.png")
END
check "pictures are made" "$PYTHON" make.py
check "equal pictures: status 0" "$QVOL" compare a.pam a.pam
"$QVOL" compare a.pam b.pam >out.txt
status=$?
check "different pictures: status 1" test $status -eq 1
check "largest differences" sh -c 'grep -q "red *max *3 " out.txt && grep -q "green *max *4 " out.txt && grep -q "blue *max 100 " out.txt'
check "root mean square" sh -c 'grep -q "red .*rms 1.0607" out.txt && grep -q "blue .*rms 35.3553" out.txt'
check "share of equal pixels" grep -q "equal *62.5000 % of 8" out.txt
"$QVOL" compare a.pam b.pam --tolerance 3 >out.txt
check "--tolerance 3" grep -q "equal *75.0000 %" out.txt
check "--tolerance 100: status 0" "$QVOL" compare a.pam b.pam --tolerance 100
"$QVOL" compare a.pam b.pam -q >out.txt
check "-q prints nothing" test ! -s out.txt
"$QVOL" compare a.pam b.pam --gain 2 -o d.pam >/dev/null
check "the difference picture" "$PYTHON" -c '
d = open("d.pam", "rb").read()[-24:]
assert list(d) == [6] + [0] * 3 + [8] + [0] * 18 + [200], list(d)'
"$QVOL" compare a.pam b.pam -o - --gain 2 >d2.pam
check "on standard output" cmp d.pam d2.pam
"$QVOL" compare a.pam b.pam --json >report.json
check "--json" "$PYTHON" -c '
import json
r = json.load(open("report.json"))
assert [c["max"] for c in r["channels"]] == [3, 4, 100] and r["equal"] == 5 and r["pixels"] == 8'
"$PYTHON" -c '
from PIL import Image
Image.frombytes("RGB", (4, 2), open("a.pam", "rb").read()[-24:]).save("a.png")
Image.frombytes("L", (4, 2), bytes(range(8))).save("grey.png")
Image.frombytes("I;16", (4, 2), bytes(16)).save("deep.png")'
check "PNG against PAM" "$QVOL" compare a.png a.pam
check "grey PNG against PAM" "$QVOL" compare grey.png grey.pam
check "grey and alpha" "$QVOL" compare alpha.pam alpha.pam
check "standard input" sh -c '"$1" compare - a.pam <a.pam' - "$QVOL"
head -c 60 a.png >cut.png
refuses "other channels" 1 "size: 4 x 2 x 1 channels, not" "$QVOL" compare a.pam grey.pam
refuses "another size" 1 "size: 2 x 4" "$QVOL" compare a.pam tall.pam
refuses "PAM, a byte short" 1 "data: 23 bytes" "$QVOL" compare short.pam a.pam
refuses "PAM, a byte long" 1 "data: 25 bytes" "$QVOL" compare long.pam a.pam
refuses "PAM, 16 bits" 1 "MAXVAL" "$QVOL" compare deep.pam a.pam
refuses "PAM, no width" 1 "WIDTH" "$QVOL" compare zero.pam a.pam
refuses "PAM, lying width" 1 "implies 4294705156" "$QVOL" compare huge.pam a.pam
refuses "PAM, overflowing width" 1 "WIDTH" "$QVOL" compare overflow.pam a.pam
refuses "PAM, five channels" 1 "DEPTH" "$QVOL" compare five.pam a.pam
refuses "PAM, no end of header" 1 "no ENDHDR" "$QVOL" compare endless.pam a.pam
refuses "PNG, noise" 1 "noise.png: PNG" "$QVOL" compare noise.png a.pam
refuses "PNG, cut short" 1 "cut.png: PNG" "$QVOL" compare cut.png a.pam
refuses "PNG, empty" 1 "neither PNG nor PAM" "$QVOL" compare empty.png a.pam
refuses "PNG, 16 bits" 1 "bit depth" "$QVOL" compare deep.png a.pam
refuses "no picture" 1 "neither PNG nor PAM" "$QVOL" compare make.py a.pam
refuses "no file" 1 "No such file" "$QVOL" compare nowhere.png a.pam

# info
"$PYTHON" -c '
from volumes import *
write("ramp.nii", nifti(list(range(-480, 480)), code="h", spacing=(1, 2, 3)))'
"$QVOL" info ramp.nii >info.txt
check "info: size, type, spacing, range" sh -c 'grep -q "size *12 x 10 x 8" info.txt &&
    grep -q "type *s16" info.txt && grep -q "spacing *1 x 2 x 3" info.txt && grep -q "range *-480 .. 479" info.txt'
"$QVOL" info ramp.nii --json >info.json
check "info --json" "$PYTHON" -c '
import json
r = json.load(open("info.json"))
assert r["input"]["size"] == [12, 10, 8] and r["input"]["type"] == "s16"
assert (r["low"], r["high"]) == (-480, 479) and sum(r["histogram"]) == 960
assert abs(r["percentiles"]["50"]) < 5 and abs(r["percentiles"]["25"] + 240) < 5'
finish
