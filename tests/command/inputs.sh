#!/bin/sh
# One blob in every format and type gives one picture.
. tests/command/common
cd "$work" || exit 1
cat >make.py <<'END'
from volumes import *
import os
values = blob()
write("in_12x10x8_uint8.raw", packed(values))
for code, name in zip("bBhHiIfd", "s8 u8 s16 u16 s32 u32 f32 f64".split()):
    shown = [v // 2 for v in values] if code == "b" else values
    for order, end in (("<", "le"), (">", "be")):
        write(f"{name}{end}.raw", packed(shown, code, order))
        write(f"{name}{end}.nii", nifti(shown, code=code, order=order))
        write(f"{name}{end}.two.nii", nifti(shown, code=code, order=order, version=2))
        write(f"{name}{end}.nii.gz", gzip.compress(nifti(shown, code=code, order=order)))
        for encoding in ("raw", "gzip"):
            header, data = nrrd(shown, code=code, order=order, encoding=encoding)
            write(f"{name}{end}.{encoding}.nrrd", header, data)
            header, data = nrrd(shown, code=code, order=order, encoding=encoding,
                                data_file=f"{name}{end}.{encoding}.data")
            write(f"{name}{end}.{encoding}.nhdr", header)
            write(f"{name}{end}.{encoding}.data", data)
write("half.raw", packed([v // 2 for v in values]))
write("skipped.raw", b"seventeen bytes..", packed(values))
write("skipped.nhdr", nrrd(values, data_file="skipped.raw", extra=["byte skip: 17"])[0])
write("end.nhdr", nrrd(values, data_file="skipped.raw", extra=["byte skip: -1"])[0])
write("lines.data", b"a line\nanother\n", packed(values))
write("lines.nhdr", nrrd(values, data_file="lines.data", extra=["line skip: 2"])[0])
os.mkdir("folder")
write("folder/beside.nhdr", nrrd(values, data_file="beside.data")[0])
write("folder/beside.data", packed(values))
END
check "volumes are made" "$PYTHON" make.py
VIEW="--size 40x30 --tf surface --window 0:255"
# shellcheck disable=SC2086
"$QVOL" render in_12x10x8_uint8.raw -o base.pam $VIEW
"$QVOL" render half.raw --dims 12x10x8 --type u8 -o half.pam --size 40x30 --tf surface --window 0:127

same() { # same NAME INPUT OPTION...
    name=$1
    shift
    rm -f a.pam
    # shellcheck disable=SC2086
    "$QVOL" render "$@" -o a.pam $VIEW
    cmp -s base.pam a.pam
    outcome $? "$name"
}
same_half() {
    rm -f a.pam
    "$QVOL" render "$@" -o a.pam --size 40x30 --tf surface --window 0:127
    cmp -s half.pam a.pam
    outcome $? "signed bytes: $1"
}

for type in u8 s16le s16be u16le u16be u32le u32be s32le s32be f32le f32be f64le f64be; do
    stem=$type
    [ $type = u8 ] && stem=u8le
    same "raw $type" $stem.raw --dims 12x10x8 --type $type
    for ending in nii two.nii nii.gz raw.nrrd gzip.nrrd raw.nhdr gzip.nhdr; do
        same "$ending of $type" $stem.$ending
    done
done
same_half s8le.raw --dims 12x10x8 --type s8
for ending in nii nii.gz raw.nrrd gzip.nhdr; do
    same_half s8le.$ending
done
same "--skip" skipped.raw --dims 12x10x8 --type u8 --skip 17
same "NRRD, byte skip" skipped.nhdr
same "NRRD, data at the end of their file" end.nhdr
same "NRRD, line skip" lines.nhdr
same "NRRD, data file beside the header" folder/beside.nhdr
mkdir deep_3x3x3_uint8.raw
cp u8le.raw deep_3x3x3_uint8.raw/blob_12x10x8_uint8.raw
same "dimensions from the name, not from its folder" deep_3x3x3_uint8.raw/blob_12x10x8_uint8.raw
cp f32le.raw blob_12x10x8_float32.raw
same "type from the name" blob_12x10x8_float32.raw
cp u8le.raw wrong_8x10x12_float32.raw
same "options before the name" wrong_8x10x12_float32.raw --dims 12x10x8 --type u8

piped() { # piped NAME FILE OPTION...
    name=$1 file=$2
    shift 2
    # shellcheck disable=SC2086,SC2002
    cat "$file" | TMPDIR=$work/spool "$QVOL" render - -o a.pam $VIEW "$@"
    cmp -s base.pam a.pam
    outcome $? "$name"
}
mkdir spool
piped "NIfTI from a pipe" u8le.nii
piped "NIfTI, gzip, from a pipe" s16be.nii.gz
piped "NRRD from a pipe" f32le.gzip.nrrd
piped "raw from a pipe" u16be.raw --dims 12x10x8 --type u16be
mkfifo fifo
cat u8le.nii >fifo &
same "NIfTI from a named pipe" fifo
check "no copy of a pipe is left" sh -c '! ls spool | grep .'

# Scaling: the picture depends on scaled values and their window.
"$PYTHON" -c '
from volumes import *
write("scaled.nii", nifti(blob(), slope=-0.5, inter=10))
write("plain.nii", nifti([10 - v / 2 for v in blob()], code="f"))
write("zero.nii", nifti(blob(), slope=0, inter=7))
write("slope.nii", nifti(blob(), slope=float("nan"), inter=float("nan")))
write("nan.nii", nifti([float("nan") if v < 5 else v for v in blob()], code="f"))'
"$QVOL" render scaled.nii -o a.pam --size 40x30 --tf surface --window=-110:10
"$QVOL" render plain.nii -o b.pam --size 40x30 --tf surface --window=-110:10
check "scl_slope and scl_inter" cmp a.pam b.pam
differs "scaled values are not the stored ones" a.pam base.pam
same "a slope of 0 scales nothing" zero.nii
same "nor does one that is not a number" slope.nii
same "not a number lies below the window" nan.nii
"$QVOL" info scaled.nii >info.txt
check "info tells the scaled range" grep -q 'range  *-67.5 .. 10' info.txt

# Default windows: the data's range beyond 8 bits.
"$QVOL" render s16le.nii -o a.pam --size 40x30 --tf surface
"$QVOL" render s16le.nii -o b.pam --size 40x30 --tf surface --window 0:155
check "16 bits: the default window is the range" cmp a.pam b.pam
"$QVOL" render f32le.nii -o c.pam --size 40x30 --tf surface
check "floats: the same" cmp a.pam c.pam
finish
