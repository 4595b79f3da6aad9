#!/bin/sh
# Files that lie, are cut short or damaged: one line, status 1, no output.
. tests/command/common
cd "$work" || exit 1
cat >make.py <<'END'
from volumes import *
values = blob()
good = nifti(values)
two = nifti(values, version=2)
def patched(data, offset, form, *fields):
    bytes_ = struct.pack("<" + form, *fields)
    return data[:offset] + bytes_ + data[offset + len(bytes_):]
bad = {
    "short_header": good[:200],
    "four_bytes": good[:4],
    "magic": patched(good, 344, "4s", b"n+7\0"),
    "pair": patched(good, 344, "4s", b"ni1\0"),
    "dim0_zero": patched(good, 40, "h", 0),
    "dim0_huge": patched(good, 40, "h", 8),
    "dim0_negative": patched(good, 40, "h", -1),
    "dim_negative": patched(good, 42, "h", -12),
    "dim_zero": patched(good, 44, "h", 0),
    "dim_huge": patched(good, 42, "3h", 4096, 4096, 4096),
    "dim_beyond": patched(good, 42, "h", 32767),
    "four_d": patched(good, 40, "5h", 4, 12, 10, 4, 2),
    "rgb": patched(good, 70, "hh", 128, 24),
    "complex": patched(good, 70, "hh", 32, 64),
    "int64": patched(good, 70, "hh", 1024, 64),
    "datatype": patched(good, 70, "h", 9999),
    "bitpix": patched(good, 72, "h", 16),
    "offset_nan": patched(good, 108, "f", float("nan")),
    "offset_inside": patched(good, 108, "f", 0),
    "offset_negative": patched(good, 108, "f", -352),
    "offset_beyond": patched(good, 108, "f", 1e6),
    "offset_huge": patched(good, 108, "f", 1e30),
    "pixdim_zero": patched(good, 80, "f", 0),
    "pixdim_nan": patched(good, 84, "f", float("nan")),
    "pixdim_infinite": patched(good, 84, "f", float("inf")),
    "pixdim_apart": patched(good, 80, "f", 100),
    "sform_zero": patched(good, 254, "h", 1),
    "sform_nan": patched(good, 254, "h13f", 1, *[0] * 6, *[float("nan")] * 7),
    "sform_flat": nifti(values, sform=[[1, 1, 0, 0], [1, 1, 0, 0], [0, 0, 1, 0]]),
    "truncated": good[:-1],
    "longer": good + b"\0",
    "all_nan": nifti([float("nan")] * len(values), code="f"),
    "two_dim_huge": patched(two, 16, "4q", 3, 1 << 62, 1 << 62, 1 << 62),
    "two_dim_negative": patched(two, 24, "q", -1),
    "two_offset": patched(two, 168, "q", 1 << 62),
    "two_truncated": two[:-1],
    "two_short": two[:300],
}
for name, data in bad.items():
    write(f"{name}.nii", data)
    write(f"{name}.nii.gz", gzip.compress(data))
packed_good = gzip.compress(good)
write("cut.nii.gz", packed_good[:-40])
write("flipped.nii.gz", packed_good[:-30] + bytes([packed_good[-30] ^ 255]) + packed_good[-29:])
write("not_gzip.nii.gz", b"\x1f\x8b" + b"x" * 500)
write("bomb.nii.gz", gzip.compress(patched(good, 42, "3h", 4096, 4096, 64)))
write("empty.nii", b"")
write("text.nii", b"this is no volume, but it is long enough to hold a header" * 20)

def header(*lines):
    return ("\n".join(("NRRD0004",) + lines) + "\n\n").encode()
data = packed(values)
ok = ("type: uchar", "dimension: 3", "sizes: 12 10 8", "encoding: raw")
def but(index, line):
    return header(*ok[:index], line, *ok[index + 1:])
bad = {
    "type": but(0, "type: quaternion") + data,
    "type_block": header("type: block", "block size: 1", *ok[1:]) + data,
    "type_long": but(0, "type: longlong") + data,
    "no_type": header(*ok[1:]) + data,
    "dimension_four": header(ok[0], "dimension: 4", "sizes: 3 4 10 8", ok[3]) + data,
    "dimension_zero": but(1, "dimension: 0") + data,
    "dimension_huge": but(1, "dimension: 99999999999") + data,
    "sizes_zero": but(2, "sizes: 12 0 8") + data,
    "sizes_negative": but(2, "sizes: -12 10 8") + data,
    "sizes_huge": but(2, "sizes: 4096 4096 4096") + data,
    "sizes_overflow": but(2, "sizes: 4294967296 4294967296 4294967296") + data,
    "sizes_few": but(2, "sizes: 12 10") + data,
    "encoding": but(3, "encoding: rot13") + data,
    "ascii": but(3, "encoding: ascii") + b"1 2 3\n",
    "truncated": header(*ok) + data[:-1],
    "longer": header(*ok) + data + b"\0",
    "no_data": header(*ok),
    "no_blank_line": ("NRRD0004\n" + "\n".join(ok)).encode(),
    "version": header(*ok).replace(b"0004", b"9999") + data,
    "only_magic": b"NRRD0004\n",
    "spacings_nan": header(*ok, "spacings: 1 nan 0") + data,
    "spacings_apart": header(*ok, "spacings: 1 1 99") + data,
    "directions_flat": header(*ok, "space: RAS", "space directions: (1,0,0) (2,0,0) (0,0,1)") + data,
    "no_such_file": header(*ok, "data file: nowhere.data"),
    "pattern": header(*ok, "data file: x%s%s%n.raw 1 8 1 2"),
    "list": header(*ok, "data file: LIST") + b"a\nb\n",
    "skip_beyond": header(*ok, "byte skip: 99999") + data,
    "long_line": header(*ok, "content: " + "x" * 5000) + data,
}
for name, contents in bad.items():
    write(f"{name}.nrrd", contents)
zipped = gzip.compress(data)
gz = header(*ok[:3], "encoding: gzip")
write("gz_cut.nrrd", gz, zipped[:-20])
write("gz_none.nrrd", gz)
write("gz_damaged.nrrd", gz, b"\x1f\x8b\x08\0" + bytes(200))
write("gz_bomb.nrrd", header(ok[0], ok[1], "sizes: 4096 4096 64", "encoding: gzip"), zipped)
write("detached_short.nhdr", header(*ok, "data file: short.data"))
write("detached_long.nhdr", header(*ok, "data file: long.data"))
write("detached_gz_short.nhdr", gz[:-1] + b"data file: short.data.gz\n\n")
write("short.data", data[:-1])
write("long.data", data + b"\0")
write("short.data.gz", gzip.compress(data[:-1]))
write("in_12x10x8_uint8.raw", data)
write("short.raw", data[:-1])
write("long.raw", data + b"\0")
write("empty.raw")
# 12x10x8 of 4 bytes, and its levels 6x5x4, 3x3x2, 2x2x1, 1x1x1.
LEVELS = (120, 18, 4, 1)
write("levels.rgba8", bytes(4 * (960 + sum(LEVELS))))
write("levels.cut", bytes(4 * (960 + sum(LEVELS)) - 1))
write("levels.long", bytes(4 * (960 + sum(LEVELS)) + 1))
write("levels.between", bytes(4 * (960 + sum(LEVELS[:2]) + 1)))
write("levels.wide", bytes(4 * 960 + 8 * sum(LEVELS)))
write("levels.indexed8", bytes(960 + 4 * sum(LEVELS)))
write("levels.palette16", bytes(2048))
END
check "files are made" "$PYTHON" make.py
cat >untouched.pam <<'END'
what stood there before
END
cp untouched.pam out.pam
# Absurd sizes must not be allocated: 512 MiB are plenty for these files.
count=0
for file in *.nii *.nii.gz *.nrrd *.nhdr; do
    name=$file
    # shellcheck disable=SC3045
    timeout 20 sh -c 'ulimit -v ${MEMORY_KB:-524288}; exec "$1" render "$2" -o out.pam --size 8x8 --threads 1' - "$QVOL" "$file" \
        >.out 2>.err </dev/null
    status=$?
    good=0
    [ $status -eq 1 ] || good=1
    [ "$(wc -l <.err)" -eq 1 ] || good=1
    grep -q "^qvol render: $file: [A-Za-z]" .err || good=1
    [ -s .out ] && good=1
    cmp -s out.pam untouched.pam || good=1
    [ $good -eq 0 ] || { echo "# status $status"; sed 's/^/# /' .err; } >&2
    outcome $good "refuses $name: $(head -c 90 .err | sed 's/^[^:]*: [^:]*: //; s/#/number/')"
    count=$((count + 1))
done
check "all files were tried" test $count -gt 100

field() { # field FILE PATTERN: the line names the field
    "$QVOL" info "$1" 2>.err
    grep -q -e "$2" .err
    outcome $? "$1 names $2"
}
field dim_negative.nii 'dim\[1\]: -12'
field four_d.nii 'dim\[4\]: 2'
field rgb.nii 'datatype: code 128'
field offset_inside.nii vox_offset
field sform_zero.nii sform
field two_dim_huge.nii 'dim\[1\]'
field longer.nii 'more than the 960'
field bomb.nii.gz 'implies 1073741824'
field truncated.nrrd 'implies 960 bytes, the file has 959'
field dimension_four.nrrd 'dimension: 4 axes'
field ascii.nrrd encoding
field pattern.nrrd 'data file: several data files'
field list.nrrd 'data file: several data files'

raw() { # raw NAME PATTERN STATUS ARGUMENT...
    name=$1 pattern=$2 status=$3
    shift 3
    refuses "$name" "$status" "$pattern" "$QVOL" render "$@" -o out.pam
}
raw "raw, a byte short" "959 bytes, but" 1 short.raw --dims 12x10x8 --type u8
raw "raw, a byte long" "961 bytes, but" 1 long.raw --dims 12x10x8 --type u8
raw "raw, empty" "0 bytes, but" 1 empty.raw --dims 12x10x8 --type u8
raw "raw, huge" "make 0 + 549755813888" 1 short.raw --dims 4096x4096x4096 --type f64le
raw "raw, skip beyond the end" "960 bytes, but" 1 in_12x10x8_uint8.raw --skip 9000000000000000
raw "raw, pipe too short" "standard input: size: 0 bytes" 1 - --dims 12x10x8 --type u8
"$PYTHON" -c 'print("x" * 100000)' >endless
piped() { # piped NAME PATTERN ARGUMENT...: a pipe that holds more than is wanted
    name=$1 pattern=$2
    shift 2
    # shellcheck disable=SC2016
    refuses "$name" 1 "$pattern" sh -c 'cat endless | "$@"' - "$QVOL" "$@"
}
piped "raw, pipe too long" "standard input: size: more than 4096 bytes, but .* make 0 + 4096" \
    info - --dims 16x16x16 --type u8
piped "raw, pipe too long after --skip" "more than 4106 bytes, but .* make 10 + 4096" \
    info - --dims 16x16x16 --type u8 --skip 10
piped "palette, pipe too long" "standard input: palette: more than 2048 bytes" \
    render in_12x10x8_uint8.raw --type indexed8 --palette - -o out.pam
raw "indexed without a palette" "need one" 2 in_12x10x8_uint8.raw --type indexed8
printf '%1023s' x >p1023
printf '%1024s' x >p1024
printf '%2049s' x >p2049
raw "palette a byte short" "palette: 1023 bytes" 1 in_12x10x8_uint8.raw --type indexed8 --palette p1023
raw "palette a byte long" "palette: 2049 bytes" 1 in_12x10x8_uint8.raw --type indexed8 --palette p2049
raw "palette missing" "No such file" 1 in_12x10x8_uint8.raw --type indexed8 --palette nowhere
raw "classified data with --tf" "classified already" 2 in_12x10x8_uint8.raw --dims 6x10x4 --type rgba8 --tf fog
levelled() { # levelled NAME PATTERN FILE TYPE: whole files of voxels and levels, or none
    for command in info "render -o out.pam --level 1"; do
        # shellcheck disable=SC2086
        refuses "$1: $command" 1 "$3: $2" "$QVOL" $command "$3" --dims 12x10x8 --type "$4"
    done
}
check "levels as they should be" "$QVOL" info levels.rgba8 --dims 12x10x8 --type rgba8
levelled "a level cut" "size: 4411 bytes, but .* make 0 + 3840" levels.cut rgba8
levelled "a byte after the levels" "size: 4413 bytes" levels.long rgba8
levelled "half a level" "size: 4396 bytes" levels.between rgba8
levelled "levels of wider voxels" "size: 4984 bytes" levels.wide rgba8
levelled "levels of data that are not classified" "size: 1532 bytes" levels.indexed8 u8
raw "levels of another palette" "levels.indexed8: levels: 572 bytes are none of a palette of 2048" 1 \
    levels.indexed8 --dims 12x10x8 --type indexed8 --palette levels.palette16
piped "levels, pipe too long" "standard input: size: more than 8824 bytes" \
    info - --dims 12x10x8 --type rgba16le
raw "extinction of no depth" "--extinction: data of type rgbt8 need the depth" 2 levels.rgba8 --dims 12x10x8 --type rgbt8
raw "extinction of depth auto" "--extinction: data of type rgbt8 need the depth" 2 levels.rgba8 --dims 12x10x8 \
    --type rgbt8 --extinction auto
raw "extinction of opacity" "--extinction: data of type rgba8 hold opacity" 2 levels.rgba8 --dims 12x10x8 \
    --type rgba8 --extinction 5
raw "a unit distance of extinction" "--unit-distance: the input holds extinction" 2 levels.rgba8 --dims 12x10x8 \
    --type rgbt8 --extinction 5 --unit-distance 1
raw "an indexed palette of extinction auto" "need the depth" 2 levels.indexed8 --dims 12x10x8 --type indexed8 \
    --palette p1024 --extinction auto
raw "no file" "No such file" 1 nowhere.nii
raw "a folder" "neither a file nor a pipe" 1 .
raw "a device" "neither a file nor a pipe" 1 /dev/zero --dims 12x10x8 --type u8
raw "no volume at all" "neither NIfTI nor NRRD" 1 make.py

transfer() { # transfer NAME TEXT PATTERN
    printf '%b' "$2" >bad.tf
    refuses "transfer function: $1" 1 "$3" "$QVOL" render in_12x10x8_uint8.raw -o out.pam --tf ./bad.tf
}
transfer "empty" "" "no control point"
transfer "only a comment" "# 1 2 3 4 5\n" "no control point"
transfer "a word" "0 0 0 red 0\n" "line 1: a number"
transfer "a field short" "0 0 0 0 0\n5 1 2 3\n" "line 2: expected"
transfer "a field long" "0 0 0 0 0 0\n" "line 1: expected"
transfer "many fields" "0 0 0 0 0 0 0 0 0 0 0\n" "line 1: expected"
transfer "index 256" "256 0 0 0 0\n" "line 1: a number"
transfer "index negative" "-1 0 0 0 0\n" "line 1: a number"
transfer "index 1.5" "1.5 0 0 0 0\n" "whole number"
transfer "index falls" "9 0 0 0 0\n\n8 0 0 0 0\n" "line 3: the index does not rise"
transfer "index twice" "9 0 0 0 0\n9 0 0 0 0\n" "line 2: the index does not rise"
transfer "colour 256" "0 256 0 0 0\n" "line 1: a number"
transfer "opacity 1.1" "0 0 0 0 1.1\n" "line 1: a number"
transfer "not a number" "0 0 0 0 nan\n" "line 1: a number"
transfer "shading exponent 3" "0 0 0 0 0\nshading .1 .1 .1 3 0\n" "exponent"
transfer "a zero byte" "0 0 0 0 0\n\0000\n" "not a text"
head -c 70000 /dev/zero | tr '\0' '#' >big.tf
refuses "transfer function: too long" 1 "not a text" "$QVOL" render in_12x10x8_uint8.raw -o out.pam --tf ./big.tf
refuses "transfer function: a folder" 1 "directory" "$QVOL" render in_12x10x8_uint8.raw -o out.pam --tf .
check "the output was never touched" cmp out.pam untouched.pam
check "nothing was left beside it" sh -c '! ls | grep -e "^out.pam." -e "\.tmp$"'
finish
