/*
 * freevoxel_file.h - FreeVoxels in a file that is mapped into memory, not read.
 *
 * Little-endian, tests/SPEC.md section 67:
 *
 *     0  magic           8   89 51 56 46 0D 0A 1A 0A: a copy that changed line ends is found out
 *     8  version         4   1
 *    12  header bytes    4   280 + palette bytes
 *    16  total bytes     8   of the file
 *    24  size            2 on each axis, of level 0
 *    30  storage         1   a qv_storage
 *    31  order           1   0 linear, 1 Morton, 2 Hilbert
 *    32  spacing         4 on each axis, Q16.16
 *    44  unit distance   4   Q16.16; 0: opacities hold for a step of any direction
 *    48  extinction      4   Q16.16, of storage that holds it; else 0
 *    52  directions      4   the set
 *    56  levels          1   coarser than level 0
 *    57  hierarchy       1   0 no levels, 1 geometric means, 2 rebuilt of each level's own voxels
 *    58  palette bytes   2   0, 1024 or 2048
 *    60  zero            4
 *    64  13 of: offset   8   of a level's records, a multiple of 64
 *               record   2   bytes from one to the next
 *               zero     6   all 16 are zero where there is no level
 *   272  zero            4
 *   276  checksum        4   CRC-32 of bytes 0 .. 275 and the palette
 *   280  palette             entries of 4 channels, of 8 or 16 bits
 *
 * Then the levels, in this order, without gaps but for the multiples of 64. A level has one record
 * for each voxel, in the file's order: the voxel (level 0: as the storage says; others: an entry
 * of its channels), the bytes of its attenuation, one for each direction of the set, lowest number
 * first, and a zero where that makes records of voxels with 16-bit channels even.
 */
#ifndef QVOL_HOST_FREEVOXEL_FILE_H
#define QVOL_HOST_FREEVOXEL_FILE_H

#include "qvol.h"

#include <stdbool.h>

/* Levels that a volume of QV_AXIS_MAX has, level 0 included. */
#define FREEVOXEL_LEVELS 13

enum freevoxel_order { FREEVOXEL_LINEAR, FREEVOXEL_MORTON, FREEVOXEL_HILBERT, FREEVOXEL_ORDERS };
/* The library's range of spacings, 1/16 .. 256, Q16.16. */
#define FREEVOXEL_SPACING_LEAST (QV_ONE_Q16 / 16)
#define FREEVOXEL_SPACING_MOST  (QV_ONE_Q16 * 256)

enum freevoxel_hierarchy {
    FREEVOXEL_NO_LEVELS,
    FREEVOXEL_GEOMETRIC,
    FREEVOXEL_REBUILT,
    FREEVOXEL_HIERARCHIES
};

/* The records of one level. */
struct freevoxel_level {
    uint64_t offset; /* in the file */
    uint64_t voxels; /* as many records */
    uint16_t size[3];
    uint16_t record;      /* bytes from one to the next */
    uint16_t voxel_bytes; /* before those of attenuation */
    uint8_t storage;      /* a qv_storage, of the voxels */
};

/* All that the header says. The layout follows from it, so a writer and a reader agree. */
struct freevoxel_header {
    qv_volume volume; /* level 0, without voxels; palette: `palette`, in the machine's byte order */
    uint16_t palette[QV_PALETTE16_BYTES / 2];
    uint32_t directions;
    uint8_t order;     /* enum freevoxel_order */
    uint8_t hierarchy; /* enum freevoxel_hierarchy */
    uint8_t coarser;   /* levels beside level 0 */
    struct freevoxel_level levels[FREEVOXEL_LEVELS];
    uint64_t total_bytes;
};

/* Holds pointers into itself: it is not to be copied. */
struct freevoxel_file {
    const char *name;
    const uint8_t *bytes; /* mapped: the whole file */
    struct freevoxel_header header;
};

/* A record's voxel for qv_splat. It may point into itself: it is not to be copied. */
struct freevoxel_record {
    qv_freevoxel voxel;
    uint16_t entry[4]; /* channels of 16 bits, in the machine's byte order */
};

/* Whether a regular file of that name begins as a FreeVoxel file does. Ends with no error. */
bool freevoxel_file_is(const char *name);

/* Maps a file and checks every field. What is wrong ends the command. */
void freevoxel_file_open(struct freevoxel_file *file, const char *name);
void freevoxel_file_close(struct freevoxel_file *file);

/* Linear, Morton or Hilbert. */
const qv_order *freevoxel_order(const struct freevoxel_header *header);

/* The attenuation of a level as it lies in the file. */
void freevoxel_file_attenuation(qv_attenuation *attenuation, const struct freevoxel_file *file,
                                uint8_t level);

/* Whether a record has no opacity, so that it adds nothing to a picture. index < voxels. */
bool freevoxel_file_is_clear(const struct freevoxel_file *file, uint8_t level, uint64_t index);

/* The voxel with that index in the file's order. index < voxels. */
void freevoxel_file_record(struct freevoxel_record *record, const struct freevoxel_file *file,
                           uint8_t level, uint64_t index);

/*
 * For writers. Fills in the layout, levels and total_bytes, of a header of which volume,
 * directions, order, hierarchy and coarser are set.
 */
void freevoxel_header_lay_out(struct freevoxel_header *header);

/* Bytes of the header with its palette, and their encoding. */
uint32_t freevoxel_header_bytes(const struct freevoxel_header *header);
void freevoxel_header_write(uint8_t *bytes, const struct freevoxel_header *header);

/* A voxel of the machine's byte order as it stands in a record. */
void freevoxel_put_voxel(uint8_t *record, const struct freevoxel_level *level, const void *voxel);

#endif
