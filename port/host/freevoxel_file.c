/*
 * freevoxel_file.c - maps a FreeVoxel file and checks it: after that, no record lies outside of it.
 */
#define _POSIX_C_SOURCE 200809L

#include "freevoxel_file.h"
#include "error.h"
#include "freevoxel_header.h"
#include "voxel_storage.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- The file as a whole ------------------------------------------------------ */

bool freevoxel_file_is(const char *name)
{
    uint8_t start[FREEVOXEL_MAGIC_BYTES] = {0};
    struct stat status;
    FILE *file = stat(name, &status) == 0 && S_ISREG(status.st_mode) ? fopen(name, "rb") : NULL;
    size_t count;
    if (file == NULL) {
        return false;
    }
    count = fread(start, 1, sizeof start, file);
    fclose(file);
    return count == sizeof start && memcmp(start, freevoxel_magic, sizeof start) == 0;
}

/* Returns its length. */
static uint64_t map(struct freevoxel_file *file, const char *name)
{
    struct stat status;
    int descriptor = open(name, O_RDONLY);
    void *bytes;
    if (descriptor < 0 || fstat(descriptor, &status) != 0) {
        system_error(name, NULL);
    }
    if (!S_ISREG(status.st_mode)) {
        data_error(name, NULL, "no regular file, which is needed to map it into memory");
    }
    if (status.st_size == 0 || (uint64_t)status.st_size > SIZE_MAX) {
        data_error(name, "length", "%lld bytes", (long long)status.st_size);
    }
    bytes = mmap(NULL, (size_t)status.st_size, PROT_READ, MAP_SHARED, descriptor, 0);
    if (bytes == MAP_FAILED) {
        system_error(name, NULL);
    }
    close(descriptor);
    file->name = name;
    file->bytes = bytes;
    return (uint64_t)status.st_size;
}

static uint64_t field(const struct freevoxel_file *file, unsigned place, unsigned bytes)
{
    return little_get(file->bytes + place, bytes);
}

/* Magic, version, lengths and checksum: the rest is what was written. */
static void check_whole(const struct freevoxel_file *file, uint64_t length)
{
    uint64_t header_bytes, total, version;
    if (length < FREEVOXEL_MAGIC_BYTES ||
        memcmp(file->bytes, freevoxel_magic, FREEVOXEL_MAGIC_BYTES) != 0) {
        data_error(file->name, "format", "no FreeVoxel file; qvol freevoxel makes one");
    }
    if (length < FREEVOXEL_FIXED_BYTES) {
        data_error(file->name, "header", "%llu of %u bytes", (unsigned long long)length,
                   FREEVOXEL_FIXED_BYTES);
    }
    version = field(file, FREEVOXEL_AT_VERSION, 4);
    if (version != FREEVOXEL_VERSION) {
        data_error(file->name, "version", "%llu, only %d is known", (unsigned long long)version,
                   FREEVOXEL_VERSION);
    }
    header_bytes = field(file, FREEVOXEL_AT_HEADER_BYTES, 4);
    if (header_bytes < FREEVOXEL_FIXED_BYTES || header_bytes > length) {
        data_error(file->name, "header bytes", "%llu, the file has %llu",
                   (unsigned long long)header_bytes, (unsigned long long)length);
    }
    if (field(file, FREEVOXEL_AT_CHECKSUM, 4) !=
        freevoxel_header_checksum(file->bytes, (uint32_t)header_bytes)) {
        data_error(file->name, "checksum", "is not the header's, which was changed or damaged");
    }
    total = field(file, FREEVOXEL_AT_TOTAL_BYTES, 8);
    if (total != length) {
        data_error(file->name, "total bytes", "%llu, the file has %llu", (unsigned long long)total,
                   (unsigned long long)length);
    }
}

/* ---- Fields of the header ------------------------------------------------------- */

static void read_size(struct freevoxel_file *file)
{
    qv_volume *volume = &file->header.volume;
    for (unsigned a = 0; a < 3; a++) {
        volume->size[a] = (uint16_t)field(file, FREEVOXEL_AT_SIZE + 2 * a, 2);
        volume->spacing[a] = (uint32_t)field(file, FREEVOXEL_AT_SPACING + 4 * a, 4);
        if (volume->size[a] == 0 || volume->size[a] > QV_AXIS_MAX) {
            data_error(file->name, "size", "%u voxels on axis %u, not 1 to %d", volume->size[a], a,
                       QV_AXIS_MAX);
        }
        if (volume->spacing[a] < FREEVOXEL_SPACING_LEAST ||
            volume->spacing[a] > FREEVOXEL_SPACING_MOST) {
            data_error(file->name, "spacing", "%g on axis %u, not 1/16 to 256",
                       volume->spacing[a] / (double)QV_ONE_Q16, a);
        }
    }
}

/* What the fourth channel means. */
static void read_opacity(struct freevoxel_file *file)
{
    qv_volume *volume = &file->header.volume;
    bool holds_extinction;
    volume->storage = file->bytes[FREEVOXEL_AT_STORAGE];
    if (volume->storage < QV_STORAGE_RGBA8 || volume->storage > QV_STORAGE_INDEXED8_T16) {
        data_error(file->name, "storage", "%u is unknown", volume->storage);
    }
    holds_extinction = storage_holds_extinction((qv_storage)volume->storage);
    volume->unit_distance = (uint32_t)field(file, FREEVOXEL_AT_UNIT, 4);
    volume->extinction = (uint32_t)field(file, FREEVOXEL_AT_EXTINCTION, 4);
    if (holds_extinction != (volume->extinction != 0)) {
        data_error(file->name, "extinction", "%s", holds_extinction ? "is 0" : "of opacities");
    }
    if (holds_extinction && volume->unit_distance != 0) {
        data_error(file->name, "unit distance", "of extinction");
    }
}

/* A palette of bytes, or of words that become the machine's. */
static void read_palette(struct freevoxel_file *file)
{
    struct freevoxel_header *header = &file->header;
    qv_storage storage = (qv_storage)header->volume.storage;
    uint32_t bytes = (uint32_t)field(file, FREEVOXEL_AT_PALETTE_BYTES, 2);
    uint32_t wanted = storage_channel_bytes(storage) == 2 ? QV_PALETTE16_BYTES : QV_PALETTE8_BYTES;
    const uint8_t *from = file->bytes + FREEVOXEL_FIXED_BYTES;
    if (!storage_is_indexed(storage)) {
        wanted = 0;
    }
    if (bytes != wanted ||
        field(file, FREEVOXEL_AT_HEADER_BYTES, 4) != FREEVOXEL_FIXED_BYTES + bytes) {
        data_error(file->name, "palette bytes", "%u, the storage takes %u", bytes, wanted);
    }
    if (bytes == 0) {
        return;
    }
    memcpy(header->palette, from, bytes);
    for (uint32_t i = 0; bytes == QV_PALETTE16_BYTES && i < bytes / 2; i++) {
        header->palette[i] = (uint16_t)little_get(from + 2 * i, 2);
    }
    header->volume.palette = (qv_address)header->palette;
    header->volume.palette_bytes = bytes;
}

static void read_order(struct freevoxel_file *file)
{
    struct freevoxel_header *header = &file->header;
    header->order = file->bytes[FREEVOXEL_AT_ORDER];
    header->directions = (uint32_t)field(file, FREEVOXEL_AT_DIRECTIONS, 4);
    if (header->order >= FREEVOXEL_ORDERS) {
        data_error(file->name, "order", "%u is unknown", header->order);
    }
    if (header->directions == 0 || (header->directions & ~QV_DIRECTIONS_ALL) != 0) {
        data_error(file->name, "directions", "the set %08x is empty or has unknown ones",
                   header->directions);
    }
}

static void read_levels(struct freevoxel_file *file)
{
    struct freevoxel_header *header = &file->header;
    unsigned most = qv_pyramid_levels(header->volume.size);
    header->coarser = file->bytes[FREEVOXEL_AT_COARSER];
    header->hierarchy = file->bytes[FREEVOXEL_AT_HIERARCHY];
    if (header->coarser > most) {
        data_error(file->name, "levels", "%u, the size has %u", header->coarser, most);
    }
    if (header->hierarchy >= FREEVOXEL_HIERARCHIES ||
        (header->coarser != 0) != (header->hierarchy != FREEVOXEL_NO_LEVELS)) {
        data_error(file->name, "hierarchy", "%u with %u levels", header->hierarchy,
                   header->coarser);
    }
}

/* The layout follows from the fields, so a header has one encoding. */
static void check_layout(struct freevoxel_file *file, uint64_t length)
{
    static const char *const what = "is not what size, storage, directions and levels make";
    struct freevoxel_header *header = &file->header;
    uint8_t bytes[FREEVOXEL_FIXED_BYTES + QV_PALETTE16_BYTES];
    freevoxel_header_lay_out(header);
    if (header->total_bytes != length) {
        data_error(file->name, "total bytes", "%s", what);
    }
    freevoxel_header_write(bytes, header);
    if (memcmp(bytes, file->bytes, freevoxel_header_bytes(header)) != 0) {
        data_error(file->name, "layout", "%s", what);
    }
}

void freevoxel_file_open(struct freevoxel_file *file, const char *name)
{
    uint64_t length;
    memset(file, 0, sizeof *file);
    length = map(file, name);
    check_whole(file, length);
    read_size(file);
    read_opacity(file);
    read_palette(file);
    read_order(file);
    read_levels(file);
    check_layout(file, length);
}

void freevoxel_file_close(struct freevoxel_file *file)
{
    munmap((void *)(uintptr_t)file->bytes, (size_t)file->header.total_bytes);
}

/* ---- Records -------------------------------------------------------------------- */

const qv_order *freevoxel_order(const struct freevoxel_header *header)
{
    static const qv_order *const orders[FREEVOXEL_ORDERS] = {&qv_order_linear, &qv_order_morton,
                                                             &qv_order_hilbert};
    return orders[header->order];
}

void freevoxel_file_attenuation(qv_attenuation *attenuation, const struct freevoxel_file *file,
                                uint8_t level)
{
    const struct freevoxel_level *l = &file->header.levels[level];
    memset(attenuation, 0, sizeof *attenuation);
    attenuation->records = file->bytes + l->offset + l->voxel_bytes;
    attenuation->bytes = l->voxels * l->record - l->voxel_bytes;
    attenuation->order = freevoxel_order(&file->header);
    attenuation->directions = file->header.directions;
    attenuation->record = l->record;
    memcpy(attenuation->size, l->size, sizeof attenuation->size);
}

static const uint8_t *record_at(const struct freevoxel_file *file, uint8_t level, uint64_t index)
{
    const struct freevoxel_level *l = &file->header.levels[level];
    return file->bytes + l->offset + index * l->record;
}

/* The last of a voxel's channels, in the record or in the palette. */
bool freevoxel_file_is_clear(const struct freevoxel_file *file, uint8_t level, uint64_t index)
{
    const struct freevoxel_header *header = &file->header;
    const uint8_t *record = record_at(file, level, index);
    switch (header->levels[level].storage) {
    case QV_STORAGE_INDEXED8:
    case QV_STORAGE_INDEXED8_T8:
        return header->volume.palette[4u * record[0] + 3u] == 0;
    case QV_STORAGE_INDEXED8_16:
    case QV_STORAGE_INDEXED8_T16:
        return header->palette[4u * record[0] + 3u] == 0;
    case QV_STORAGE_RGBA8:
    case QV_STORAGE_RGBT8:
        return record[3] == 0;
    default:
        return (record[6] | record[7]) == 0;
    }
}

void freevoxel_file_record(struct freevoxel_record *record, const struct freevoxel_file *file,
                           uint8_t level, uint64_t index)
{
    const struct freevoxel_level *l = &file->header.levels[level];
    const uint8_t *bytes = record_at(file, level, index);
    record->voxel.level = level;
    record->voxel.voxel = bytes;
    record->voxel.attenuation = bytes + l->voxel_bytes;
    freevoxel_order(&file->header)->position(record->voxel.position, l->size, index);
    if (l->voxel_bytes == FREEVOXEL_WIDE_ENTRY_BYTES) {
        for (unsigned c = 0; c < 4; c++) {
            record->entry[c] = (uint16_t)little_get(bytes + 2 * c, 2);
        }
        record->voxel.voxel = (qv_address)record->entry;
    }
}
