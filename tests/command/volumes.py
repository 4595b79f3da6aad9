"""Small volumes for the tests of the command, written without any library."""
import gzip
import math
import struct

SIZE = (12, 10, 8)

NIFTI_TYPES = {"B": 2, "h": 4, "i": 8, "f": 16, "d": 64, "b": 256, "H": 512, "I": 768}
NRRD_TYPES = {"B": "uchar", "b": "signed char", "h": "short", "H": "ushort", "i": "int",
              "I": "uint", "f": "float", "d": "double"}


def blob(size=SIZE):
    """A lopsided blob of 0 .. 255, so that no mirror image looks the same."""
    nx, ny, nz = size
    values = []
    for z in range(nz):
        for y in range(ny):
            for x in range(nx):
                u, v, w = (x + .5) / nx - .4, (y + .5) / ny - .55, (z + .5) / nz - .45
                radius = math.sqrt(u * u + 1.5 * v * v + 2 * w * w) + .15 * u * v
                values.append(max(0, min(255, round(300 * (.55 - radius) + 40 * u))))
    return values


def packed(values, code="B", order="<"):
    return struct.pack(f"{order}{len(values)}{code}", *values)


def nifti(values, size=SIZE, code="B", order="<", version=1, sform=None, qform=None,
          spacing=(1, 1, 1), slope=0, inter=0, dims=None, datatype=None, offset=None):
    """A whole file: header, empty extension mark, data. sform: 3 rows of 4."""
    datatype = NIFTI_TYPES[code] if datatype is None else datatype
    bits = 8 * struct.calcsize(code)
    dim = list(dims or (3, *size, 1, 1, 1, 1))
    pixdim = [1, *spacing, 0, 0, 0, 0]
    quaternion = qform or (0, 0, 0, 0, 0, 0)
    rows = [value for row in (sform or ((0,) * 4,) * 3) for value in row]
    codes = (1 if qform else 0, 1 if sform else 0)
    if version == 1:
        offset = 352 if offset is None else offset
        header = struct.pack(order + "i28xi2xbb8h3f4h8f3fhbB4f2i80s24s2h6f12f16s4s", 348, 0, 0, 0,
                             *dim, 0, 0, 0, 0, datatype, bits, 0, *pixdim, offset, slope, inter, 0,
                             0, 10, 0, 0, 0, 0, 0, 0, b"", b"", *codes, *quaternion, *rows, b"",
                             b"n+1\0")
    else:
        offset = 544 if offset is None else offset
        header = struct.pack(order + "i8s2h8q3d8dq6d2q80s24s2i6d12d3i16sb15x", 540,
                             b"n+2\0\r\n\x1a\n", datatype, bits, *dim, 0, 0, 0, *pixdim, offset,
                             slope, inter, 0, 0, 0, 0, 0, 0, b"", b"", *codes, *quaternion, *rows,
                             0, 0, 0, b"", 0)
    return header + b"\0\0\0\0" + packed(values, code, order)


def nrrd(values, size=SIZE, code="B", order="<", encoding="raw", data_file=None, extra=()):
    """(header, data): attached unless data_file names the file of the data."""
    data = packed(values, code, order)
    if encoding == "gzip":
        data = gzip.compress(data, mtime=0)
    lines = ["NRRD0004", f"type: {NRRD_TYPES[code]}", "dimension: 3",
             "sizes: " + " ".join(map(str, size)), f"encoding: {encoding}"]
    if struct.calcsize(code) > 1:
        lines.append("endian: " + ("little" if order == "<" else "big"))
    lines += extra
    if data_file:
        lines.append(f"data file: {data_file}")
    return ("\n".join(lines) + "\n\n").encode(), data


def write(name, *parts):
    with open(name, "wb") as stream:
        stream.write(b"".join(parts))


def turned(values, size, axis, reversed_):
    """Values stored so that world axis w is stored axis axis[w], reversed if told:
    (values, size as stored)."""
    stored_size = [0, 0, 0]
    for world in range(3):
        stored_size[axis[world]] = size[world]
    stored = []
    for k in range(stored_size[2]):
        for j in range(stored_size[1]):
            for i in range(stored_size[0]):
                place = (i, j, k)
                x, y, z = (size[w] - 1 - place[axis[w]] if reversed_[w] else place[axis[w]]
                           for w in range(3))
                stored.append(values[x + size[0] * (y + size[1] * z)])
    return stored, tuple(stored_size)


if __name__ == "__main__":
    import sys
    write(sys.argv[1], packed(blob()))
