/*
 * voxel_storage.c - a table of the library's storages.
 */
#include "voxel_storage.h"

static const struct kind {
    const char *name;
    const char *constant;
    unsigned voxel_bytes;
    unsigned channel_bytes;
    qv_storage entries;
    qv_storage opacity, extinction; /* the same with either fourth channel */
} kinds[] = {
    {"rgba8", "QV_STORAGE_RGBA8", 4, 1, QV_STORAGE_RGBA8, QV_STORAGE_RGBA8, QV_STORAGE_RGBT8},
    {"rgba16", "QV_STORAGE_RGBA16", 8, 2, QV_STORAGE_RGBA16, QV_STORAGE_RGBA16, QV_STORAGE_RGBT16},
    {"indexed8", "QV_STORAGE_INDEXED8", 1, 1, QV_STORAGE_RGBA8, QV_STORAGE_INDEXED8,
     QV_STORAGE_INDEXED8_T8},
    {"indexed8", "QV_STORAGE_INDEXED8_16", 1, 2, QV_STORAGE_RGBA16, QV_STORAGE_INDEXED8_16,
     QV_STORAGE_INDEXED8_T16},
    {"rgbt8", "QV_STORAGE_RGBT8", 4, 1, QV_STORAGE_RGBT8, QV_STORAGE_RGBA8, QV_STORAGE_RGBT8},
    {"rgbt16", "QV_STORAGE_RGBT16", 8, 2, QV_STORAGE_RGBT16, QV_STORAGE_RGBA16, QV_STORAGE_RGBT16},
    {"indexed8", "QV_STORAGE_INDEXED8_T8", 1, 1, QV_STORAGE_RGBT8, QV_STORAGE_INDEXED8,
     QV_STORAGE_INDEXED8_T8},
    {"indexed8", "QV_STORAGE_INDEXED8_T16", 1, 2, QV_STORAGE_RGBT16, QV_STORAGE_INDEXED8_16,
     QV_STORAGE_INDEXED8_T16},
    {"associated8", "QV_STORAGE_ASSOCIATED8", 4, 1, QV_STORAGE_ASSOCIATED8, QV_STORAGE_RGBA8,
     QV_STORAGE_RGBT8},
};

static const struct kind *kind_of(qv_storage storage)
{
    return &kinds[storage - QV_STORAGE_RGBA8];
}

unsigned storage_voxel_bytes(qv_storage storage)
{
    return kind_of(storage)->voxel_bytes;
}

unsigned storage_channel_bytes(qv_storage storage)
{
    return kind_of(storage)->channel_bytes;
}

bool storage_is_indexed(qv_storage storage)
{
    return kind_of(storage)->entries != storage;
}

bool storage_holds_extinction(qv_storage storage)
{
    return kind_of(storage)->extinction == storage;
}

bool storage_is_associated(qv_storage storage)
{
    return storage == QV_STORAGE_ASSOCIATED8;
}

qv_storage storage_with_extinction(qv_storage storage)
{
    return kind_of(storage)->extinction;
}

qv_storage storage_with_opacity(qv_storage storage)
{
    return kind_of(storage)->opacity;
}

qv_storage storage_of_entries(qv_storage storage)
{
    return kind_of(storage)->entries;
}

const char *storage_name(qv_storage storage)
{
    return kind_of(storage)->name;
}

const char *storage_constant(qv_storage storage)
{
    return kind_of(storage)->constant;
}
