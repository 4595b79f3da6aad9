/*
 * freevoxel_header.h - where the fields of a FreeVoxel file's header lie; freevoxel_file.h tells
 * what they mean.
 */
#ifndef QVOL_HOST_FREEVOXEL_HEADER_H
#define QVOL_HOST_FREEVOXEL_HEADER_H

#include "freevoxel_file.h"

#define FREEVOXEL_VERSION     1
#define FREEVOXEL_MAGIC_BYTES 8
#define FREEVOXEL_FIXED_BYTES 280u /* before the palette */
#define FREEVOXEL_LEVEL_BYTES 16u  /* of a level's entry */
#define FREEVOXEL_ALIGNMENT   64u  /* of levels: a line of cache */
/* R, G, B and the fourth of 16 bits. */
#define FREEVOXEL_WIDE_ENTRY_BYTES 8

enum freevoxel_place {
    FREEVOXEL_AT_VERSION = 8,
    FREEVOXEL_AT_HEADER_BYTES = 12,
    FREEVOXEL_AT_TOTAL_BYTES = 16,
    FREEVOXEL_AT_SIZE = 24,
    FREEVOXEL_AT_STORAGE = 30,
    FREEVOXEL_AT_ORDER = 31,
    FREEVOXEL_AT_SPACING = 32,
    FREEVOXEL_AT_UNIT = 44,
    FREEVOXEL_AT_EXTINCTION = 48,
    FREEVOXEL_AT_DIRECTIONS = 52,
    FREEVOXEL_AT_COARSER = 56,
    FREEVOXEL_AT_HIERARCHY = 57,
    FREEVOXEL_AT_PALETTE_BYTES = 58,
    FREEVOXEL_AT_LEVELS = 64,
    FREEVOXEL_AT_CHECKSUM = 276
};

extern const uint8_t freevoxel_magic[FREEVOXEL_MAGIC_BYTES];

/* Integers of `count` bytes, the lowest first. */
void little_put(uint8_t *bytes, unsigned count, uint64_t value);
uint64_t little_get(const uint8_t *bytes, unsigned count);

/* Of a header of `count` bytes, at least FREEVOXEL_FIXED_BYTES. */
uint32_t freevoxel_header_checksum(const uint8_t *bytes, uint32_t count);

#endif
