/*
 * freevoxel_header.c - the header of a FreeVoxel file: layout, and encoding in little-endian bytes.
 */
#include "freevoxel_header.h"
#include "crc32.h"
#include "voxel_storage.h"

#include <string.h>

const uint8_t freevoxel_magic[FREEVOXEL_MAGIC_BYTES] = {0x89, 'Q',  'V',  'F',
                                                        '\r', '\n', 0x1A, '\n'};

void little_put(uint8_t *bytes, unsigned count, uint64_t value)
{
    for (unsigned i = 0; i < count; i++) {
        bytes[i] = (uint8_t)(value >> 8 * i);
    }
}

uint64_t little_get(const uint8_t *bytes, unsigned count)
{
    uint64_t value = 0;
    for (unsigned i = count; i-- > 0;) {
        value = value << 8 | bytes[i];
    }
    return value;
}

/* At most 8 + 26 bytes; even where the voxel's channels are to lie at even addresses. */
static uint16_t record_bytes(uint8_t storage, uint32_t directions)
{
    unsigned bytes = storage_voxel_bytes((qv_storage)storage) + qv_directions_count(directions);
    bool wide =
        !storage_is_indexed((qv_storage)storage) && storage_channel_bytes((qv_storage)storage) == 2;
    return (uint16_t)(wide ? bytes + bytes % 2 : bytes);
}

/* Offsets are below 2^42: 8/7 of 2^36 voxels of 34 bytes. */
void freevoxel_header_lay_out(struct freevoxel_header *header)
{
    const qv_volume *volume = &header->volume;
    uint64_t end = freevoxel_header_bytes(header);
    for (unsigned l = 0; l <= header->coarser; l++) {
        struct freevoxel_level *level = &header->levels[l];
        qv_storage storage = (qv_storage)volume->storage;
        level->storage = (uint8_t)(l == 0 ? storage : storage_of_entries(storage));
        level->voxel_bytes = (uint16_t)storage_voxel_bytes((qv_storage)level->storage);
        level->record = record_bytes(level->storage, header->directions);
        level->voxels = 1;
        for (unsigned a = 0; a < 3; a++) {
            level->size[a] = (uint16_t)((volume->size[a] + (1u << l) - 1u) >> l);
            level->voxels *= level->size[a];
        }
        level->offset = (end + FREEVOXEL_ALIGNMENT - 1) / FREEVOXEL_ALIGNMENT * FREEVOXEL_ALIGNMENT;
        end = level->offset + level->voxels * level->record;
    }
    header->total_bytes = end;
}

uint32_t freevoxel_header_bytes(const struct freevoxel_header *header)
{
    return FREEVOXEL_FIXED_BYTES + header->volume.palette_bytes;
}

/* Words of 16 bits, or bytes as they are. */
static void put_palette(uint8_t *bytes, const qv_volume *volume)
{
    for (uint32_t i = 0; i < volume->palette_bytes; i++) {
        bytes[i] = volume->palette[i];
    }
    if (volume->palette_bytes == QV_PALETTE16_BYTES) {
        for (uint32_t i = 0; i < volume->palette_bytes; i += 2) {
            uint16_t word;
            memcpy(&word, volume->palette + i, sizeof word);
            little_put(bytes + i, 2, word);
        }
    }
}

static void put_levels(uint8_t *bytes, const struct freevoxel_header *header)
{
    for (unsigned l = 0; l <= header->coarser; l++) {
        uint8_t *entry = bytes + FREEVOXEL_AT_LEVELS + FREEVOXEL_LEVEL_BYTES * l;
        little_put(entry, 8, header->levels[l].offset);
        little_put(entry + 8, 2, header->levels[l].record);
    }
}

uint32_t freevoxel_header_checksum(const uint8_t *bytes, uint32_t count)
{
    uint32_t crc = crc32_update(0, bytes, FREEVOXEL_AT_CHECKSUM);
    return crc32_update(crc, bytes + FREEVOXEL_FIXED_BYTES, count - FREEVOXEL_FIXED_BYTES);
}

void freevoxel_header_write(uint8_t *bytes, const struct freevoxel_header *header)
{
    const qv_volume *volume = &header->volume;
    uint32_t count = freevoxel_header_bytes(header);
    memset(bytes, 0, count);
    memcpy(bytes, freevoxel_magic, FREEVOXEL_MAGIC_BYTES);
    little_put(bytes + FREEVOXEL_AT_VERSION, 4, FREEVOXEL_VERSION);
    little_put(bytes + FREEVOXEL_AT_HEADER_BYTES, 4, count);
    little_put(bytes + FREEVOXEL_AT_TOTAL_BYTES, 8, header->total_bytes);
    for (unsigned a = 0; a < 3; a++) {
        little_put(bytes + FREEVOXEL_AT_SIZE + 2 * a, 2, volume->size[a]);
        little_put(bytes + FREEVOXEL_AT_SPACING + 4 * a, 4, volume->spacing[a]);
    }
    bytes[FREEVOXEL_AT_STORAGE] = volume->storage;
    bytes[FREEVOXEL_AT_ORDER] = header->order;
    little_put(bytes + FREEVOXEL_AT_UNIT, 4, volume->unit_distance);
    little_put(bytes + FREEVOXEL_AT_EXTINCTION, 4, volume->extinction);
    little_put(bytes + FREEVOXEL_AT_DIRECTIONS, 4, header->directions);
    bytes[FREEVOXEL_AT_COARSER] = header->coarser;
    bytes[FREEVOXEL_AT_HIERARCHY] = header->hierarchy;
    little_put(bytes + FREEVOXEL_AT_PALETTE_BYTES, 2, volume->palette_bytes);
    put_levels(bytes, header);
    put_palette(bytes + FREEVOXEL_FIXED_BYTES, volume);
    little_put(bytes + FREEVOXEL_AT_CHECKSUM, 4, freevoxel_header_checksum(bytes, count));
}

void freevoxel_put_voxel(uint8_t *record, const struct freevoxel_level *level, const void *voxel)
{
    const uint8_t *bytes = voxel;
    if (level->voxel_bytes != FREEVOXEL_WIDE_ENTRY_BYTES) {
        memcpy(record, bytes, level->voxel_bytes);
        return;
    }
    for (unsigned c = 0; c < 4; c++) {
        uint16_t word;
        memcpy(&word, bytes + 2 * c, sizeof word);
        little_put(record + 2 * c, 2, word);
    }
}
