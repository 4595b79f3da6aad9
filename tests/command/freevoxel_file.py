"""FreeVoxel files for the tests of the command: tests/SPEC.md section 67, in Python alone."""
import math
import struct
import zlib

MAGIC = b"\x89QVF\r\n\x1a\n"
FIXED = 280
RGBA8, RGBA16, INDEXED8, INDEXED8_16, RGBT8, RGBT16, INDEXED8_T8, INDEXED8_T16 = range(1, 9)
ORDERS = ("linear", "morton", "hilbert")
STEPS = [(d % 3 - 1, d // 3 % 3 - 1, d // 9 - 1) for d in range(27) if d != 13]


def entry_storage(storage):
    return {INDEXED8: RGBA8, INDEXED8_16: RGBA16, INDEXED8_T8: RGBT8, INDEXED8_T16: RGBT16}.get(storage, storage)


def voxel_bytes(storage):
    return {RGBA8: 4, RGBT8: 4, RGBA16: 8, RGBT16: 8}.get(storage, 1)


def with_checksum(data):
    """The same file with the header's checksum made right."""
    data = bytearray(data)
    end = min(max(struct.unpack_from("<I", data, 12)[0], FIXED), len(data)) if len(data) >= FIXED else 0
    if end:
        struct.pack_into("<I", data, 276, zlib.crc32(data[FIXED:end], zlib.crc32(data[:276])))
    return bytes(data)


class File:
    """A file whose every field is checked while it is read."""

    def __init__(self, name):
        data = self.data = open(name, "rb").read()
        assert data[:8] == MAGIC and with_checksum(data) == data
        version, header, total = struct.unpack_from("<IIQ", data, 8)
        assert version == 1 and total == len(data)
        self.size = struct.unpack_from("<3H", data, 24)
        self.storage, self.order = data[30], ORDERS[data[31]]
        self.spacing = struct.unpack_from("<3I", data, 32)
        self.unit, self.extinction, self.set = struct.unpack_from("<3I", data, 44)
        self.coarser, self.hierarchy = data[56], data[57]
        palette, zero = struct.unpack_from("<HI", data, 58)
        indexed = self.storage in (INDEXED8, INDEXED8_16, INDEXED8_T8, INDEXED8_T16)
        wide = entry_storage(self.storage) in (RGBA16, RGBT16)
        assert header == FIXED + palette and zero == 0 and palette == (1024 << wide if indexed else 0)
        assert struct.unpack_from("<I", data, 272)[0] == 0
        entries = struct.unpack_from("<1024H" if wide else "<1024B", data, FIXED) if indexed else ()
        self.palette = [entries[4 * i:4 * i + 4] for i in range(256)]
        self.directions = [d for d in range(26) if self.set >> d & 1]
        self.levels, end = [], header
        for level in range(13):
            offset, record, a, b = struct.unpack_from("<QHHI", data, 64 + 16 * level)
            assert a == b == 0
            if level > self.coarser:
                assert offset == record == 0
                continue
            storage = entry_storage(self.storage) if level else self.storage
            size = tuple((n + (1 << level) - 1) >> level for n in self.size)
            bytes_ = voxel_bytes(storage) + len(self.directions)
            assert offset == -(-end // 64) * 64 and record == bytes_ + (voxel_bytes(storage) == 8 and bytes_ % 2)
            assert not any(data[end:offset])
            self.levels.append((offset, record, size, storage))
            end = offset + record * math.prod(size)
        assert end == total

    def records(self, level=0):
        """(voxel, bytes of attenuation) of each index of a level."""
        offset, record, size, storage = self.levels[level]
        voxel, count = voxel_bytes(storage), len(self.directions)
        found = []
        for i in range(math.prod(size)):
            start = offset + i * record
            assert not any(self.data[start + voxel + count:start + record])
            found.append((self.data[start:start + voxel], self.data[start + voxel:start + voxel + count]))
        return found

    def entry(self, voxel, level=0):
        storage = self.levels[level][3]
        if voxel_bytes(storage) == 1:
            return self.palette[voxel[0]]
        return struct.unpack("<4H" if voxel_bytes(storage) == 8 else "4B", voxel)

    def step(self, direction):
        """The length of a step in unit distances, or 1."""
        length = math.sqrt(sum((d * s / 65536) ** 2 for d, s in zip(STEPS[direction], self.spacing)))
        if self.extinction:
            return length * self.extinction / 65536
        return length / (self.unit / 65536) if self.unit else 1

    def depth(self, entry):
        """Of a voxel for a step of length 1."""
        full = 65535 if entry_storage(self.storage) in (RGBA16, RGBT16) else 255
        share = entry[3] / full
        if self.extinction:
            return share
        return 64 if entry[3] == full else -math.log2(1 - share)

    def depths(self, direction):
        """Of a file in linear order: the depth between each voxel and the outside."""
        nx, ny, nz = self.size
        own = [self.depth(self.entry(voxel)) * self.step(direction) for voxel, _ in self.records()]
        dx, dy, dz = STEPS[direction]
        between = {}
        for z in (range(nz - 1, -1, -1) if dz > 0 else range(nz)):
            for y in (range(ny - 1, -1, -1) if dy > 0 else range(ny)):
                for x in (range(nx - 1, -1, -1) if dx > 0 else range(nx)):
                    u, v, w = x + dx, y + dy, z + dz
                    inside = 0 <= u < nx and 0 <= v < ny and 0 <= w < nz
                    between[x, y, z] = between[u, v, w] + own[u + nx * (v + ny * w)] if inside else 0
        return between


def mean_depth(depths, size, level, place):
    """The mean over the voxels of a block, none of which counts as more than 64."""
    ranges = [range(c << level, min((c + 1) << level, n)) for c, n in zip(place, size)]
    found = [min(64, depths[x, y, z]) for z in ranges[2] for y in ranges[1] for x in ranges[0]]
    return sum(found) / len(found)


def linear(place, size):
    return place[0] + size[0] * (place[1] + size[1] * place[2])


def morton_sorted(size):
    """The voxels of a box in Morton order."""
    def code(place):
        return sum(((place[a] >> b) & 1) << (3 * b + a) for b in range(13) for a in range(3))
    return sorted(((x, y, z) for z in range(size[2]) for y in range(size[1]) for x in range(size[0])), key=code)
