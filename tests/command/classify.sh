#!/bin/sh
# Classified volumes draw what the scan draws; C arrays compile and hold the same.
. tests/command/common
cd "$work" || exit 1
"$PYTHON" "$TESTS/volumes.py" in_12x10x8_uint8.raw
IN=in_12x10x8_uint8.raw
VIEW="--size 40x30 --azimuth 20 --elevation 10 --as raw"

round_trip() { # round_trip NAME TYPE STORAGE-OPTIONS -- OPTIONS-TO-READ
    name=$1 type=$2
    shift 2
    storage=
    while [ "$1" != -- ]; do
        storage="$storage $1"
        shift
    done
    shift
    # shellcheck disable=SC2086
    "$QVOL" classify $IN -o voxels.bin --tf surface $storage
    # shellcheck disable=SC2086
    "$QVOL" render voxels.bin --dims 12x10x8 --type "$type" -o a.raw $VIEW "$@"
    # shellcheck disable=SC2086,SC2046
    "$QVOL" render $IN -o b.raw --tf surface $VIEW $(echo "$storage" | sed 's/--endian [a-z]*//')
    check "round trip: $name" cmp a.raw b.raw
}
round_trip rgba8 rgba8 --storage rgba8 --
round_trip rgba16le rgba16le --storage rgba16 --
round_trip rgba16be rgba16be --storage rgba16 --endian big --
round_trip "shaded rgba8" rgba8 --storage rgba8 --shade --azimuth 20 --elevation 10 --
round_trip indexed8 indexed8 --storage indexed8 -- --palette voxels.bin.palette
check "a palette of 8 bits has 1024 bytes" test "$(wc -c <voxels.bin.palette)" -eq 1024
round_trip "indexed8, 16-bit palette" indexed8 --storage indexed8 --palette-bits 16 -- --palette voxels.bin.palette
check "a palette of 16 bits has 2048 bytes" test "$(wc -c <voxels.bin.palette)" -eq 2048
round_trip "indexed8, big-endian palette" indexed8 --storage indexed8 --palette-bits 16 --endian big -- \
    --palette voxels.bin.palette --endian big
"$QVOL" classify $IN -o little.bin --storage rgba16
"$QVOL" classify $IN -o big.bin --storage rgba16 --endian big
check "--endian swaps pairs" "$PYTHON" -c '
a, b = open("little.bin", "rb").read(), open("big.bin", "rb").read()
assert a != b and len(a) == 12 * 10 * 8 * 8 and a[0::2] == b[1::2] and a[1::2] == b[0::2]'
"$QVOL" classify $IN -o - --storage rgba16 >stdout.bin
check "standard output" cmp little.bin stdout.bin
"$QVOL" classify $IN -o one.bin --storage rgba16 --threads 1
check "--threads changes no byte" cmp little.bin one.bin
refuses "classified data are not classified again" 1 "classified already" \
    "$QVOL" classify little.bin --dims 12x10x8 --type rgba16le -o x.bin

# Reduction: means of boxes, and the factors that fit.
"$QVOL" classify $IN -o half.bin --reduce 2
check "--reduce 2 takes means" "$PYTHON" -c '
from volumes import blob
v = blob()
at = lambda x, y, z: v[x + 12 * (y + 10 * z)]
boxes = [(sum(at(2 * x + i, 2 * y + j, 2 * z + k) for i in (0, 1) for j in (0, 1) for k in (0, 1)) * 2
          + 8) // 16 for z in range(4) for y in range(5) for x in range(6)]
assert bytes(boxes) == open("half.bin", "rb").read()'
"$QVOL" classify $IN -o part.bin --reduce 5x1x3
check "--reduce rounds sizes up" test "$(wc -c <part.bin)" -eq $((3 * 10 * 3))
fits() { # fits BYTES EXPECTED OPTION...
    most=$1 expected=$2
    shift 2
    "$QVOL" classify $IN -o fit.bin --fit "$most" "$@"
    check "--fit $most $*" test "$(wc -c <fit.bin)" -eq "$expected"
}
fits 1984 960
fits 1983 120
fits 1144 120
fits 1143 48
fits 3000 120 --palette-bits 16
fits 1100 48 --spacing 1x1x1
fits 1264 240 --spacing 1x1x2
fits 1263 64 --spacing 1x1x2
refuses "--fit too little" 1 "not even" "$QVOL" classify $IN -o fit2.bin --fit 1024

# C arrays.
cat >main.c <<'END'
#include <stdio.h>
#ifdef VOLUME_HEADER
#include VOLUME_HEADER
#else
#include "qvol.h"
extern const qv_volume VOLUME;
#endif
int main(void)
{
    const qv_volume *v = &VOLUME;
    if (qv_volume_check(v) != QV_OK)
        return 1;
    fwrite(v->voxels, 1, (size_t)v->voxels_bytes, stdout);
    if (v->palette_bytes > 0)
        fwrite(v->palette, 1, v->palette_bytes, stdout);
    if ((v->storage >= QV_STORAGE_RGBT8 && v->storage <= QV_STORAGE_INDEXED8_T16) !=
        (v->extinction != 0))
        return 2;
    fprintf(stderr, "%u %u %u %u %u %u\n", v->size[0], v->size[1], v->size[2], (unsigned)v->spacing[0],
            (unsigned)v->spacing[1], (unsigned)v->spacing[2]);
    return 0;
}
END
SOURCES="$TESTS/../../core $TESTS/../../fixedpoint"
STRICT="-std=c99 -pedantic -Wall -Wextra -Werror -Wconversion -Wcast-qual -Wno-unused-const-variable"
# shellcheck disable=SC2086
for folder in $SOURCES; do
    FLAGS="${FLAGS:-} -I$folder"
done
array() { # array NAME ENDING OPTION...
    ending=$2 name="C array: $1, $2"
    shift 2
    rm -f array.* program
    "$QVOL" classify $IN -o array.$ending --spacing 1x1x2 "$@"
    "$QVOL" classify $IN -o array.bin --spacing 1x1x2 "$@"
    if [ "$ending" = h ]; then
        extra="-DVOLUME_HEADER=\"array.h\""
    else
        extra=array.c
    fi
    # shellcheck disable=SC2086
    check "$name compiles" "$CC" $STRICT $FLAGS -I. -DVOLUME=array_volume main.c $extra \
        "$TESTS"/../../core/*.c "$TESTS"/../../fixedpoint/*.c -o program
    ./program >held 2>geometry
    if [ -e array.bin.palette ]; then
        cat array.bin array.bin.palette >expected
    else
        cp array.bin expected
    fi
    check "$name holds the raw file's bytes" cmp held expected
    check "$name holds the geometry" grep -qx '12 10 8 65536 65536 131072' geometry
}
array indexed8 c
array indexed8 h
array "indexed8, 16-bit palette" h --palette-bits 16
array rgba8 c --storage rgba8 --tf surface
array associated8 h --storage associated8 --tf surface
array "rgba16, shaded" h --storage rgba16 --tf surface --shade
array rgbt8 c --storage rgbt8 --tf surface
array rgbt16 h --storage rgbt16 --tf surface
array "indexed8, extinction" c --extinction auto
array "indexed8, extinction of 16 bits" h --palette-bits 16 --extinction 30
check "the extinction is in the descriptor" grep -q "^ *1966080u, /\* extinction" array.h
"$QVOL" classify $IN -o "9 odd-name.c"
check "a name is made from any file's" grep -q "const qv_volume v9_odd_name_volume = {" "9 odd-name.c"
reserved() { # reserved FILE NAME: the names in the C array begin with NAME, a letter
    "$QVOL" classify $IN -o "$1"
    check "no name in $1 begins with an underscore" sh -c \
        'grep -q "const qv_volume $2_volume = {" "$1" && ! grep -q "[ )]_" "$1"' - "$1" "$2"
}
reserved .c v
reserved _X.c v_X
reserved _x.h v_x
"$QVOL" classify $IN -o "9 odd-name.c" --name good
check "--name" grep -q "const qv_volume good_volume = {" "9 odd-name.c"
cp $IN "a*__12x10x8_uint8.raw"
"$QVOL" classify "a*__12x10x8_uint8.raw" -o comment.h --tf surface
check "the comment tells size, window and transfer function" sh -c \
    'grep -q "12 x 10 x 8" comment.h && grep -q "window  *0 .. 255" comment.h && grep -q "transfer  *surface" comment.h'
finish
