/*
 * downsample_fixture.h - random volumes of every storage for tests of pyramids.
 *
 * A volume points into its source, which must stay where it is.
 */
#ifndef DOWNSAMPLE_FIXTURE_H
#define DOWNSAMPLE_FIXTURE_H

#include "check.h"
#include "qvol.h"
#include "random.h"

#include <string.h>

#define SOURCE_VOXELS 1000

static const uint8_t source_storages[] = {
    QV_STORAGE_RGBA8, QV_STORAGE_RGBA16, QV_STORAGE_INDEXED8,    QV_STORAGE_INDEXED8_16,
    QV_STORAGE_RGBT8, QV_STORAGE_RGBT16, QV_STORAGE_INDEXED8_T8, QV_STORAGE_INDEXED8_T16};

#define SOURCE_STORAGES (sizeof source_storages)

typedef struct source {
    uint16_t voxels[SOURCE_VOXELS * 4];
    uint16_t palette[QV_PALETTE_ENTRIES * 4];
    qv_volume volume;
} source;

static inline int source_is_wide(uint8_t storage)
{
    return storage % 2 == 0;
}

static inline int source_is_indexed(uint8_t storage)
{
    return storage == QV_STORAGE_INDEXED8 || storage == QV_STORAGE_INDEXED8_16 ||
           storage == QV_STORAGE_INDEXED8_T8 || storage == QV_STORAGE_INDEXED8_T16;
}

static inline int32_t source_entry_bytes(uint8_t storage)
{
    return source_is_wide(storage) ? 8 : 4;
}

/* A packed volume of this size, x fastest, with nothing in it. */
static inline void source_shape(source *s, uint8_t storage, const uint16_t size[3])
{
    qv_volume *v = &s->volume;
    const int indexed = source_is_indexed(storage);
    memset(v, 0, sizeof *v);
    v->voxels = (qv_address)s->voxels;
    v->palette = indexed ? (qv_address)s->palette : NULL;
    v->palette_bytes = indexed ? (uint32_t)source_entry_bytes(storage) * QV_PALETTE_ENTRIES : 0;
    v->storage = storage;
    v->extinction = QV_ONE_Q16;
    int32_t stride = indexed ? 1 : source_entry_bytes(storage);
    for (unsigned axis = 0; axis < 3; axis++) {
        v->size[axis] = size[axis];
        v->stride[axis] = stride;
        stride *= size[axis];
    }
    v->voxels_bytes = (uint64_t)stride;
}

/* What fourth channels are: anything; anything or 0, or full; 1 .. 3; at least a fifth. */
typedef enum source_filling { NOISE, SPARSE, FAINT, DENSE, FILLINGS } source_filling;

static inline uint16_t source_fourth(source_filling filling, uint32_t random)
{
    const uint16_t any = (uint16_t)(random >> 8);
    switch (filling) {
    case SPARSE:
        return random % 4 == 0 ? any : random % 32 == 1 ? 65535 : 0;
    case FAINT:
        return (uint16_t)(random % 4);
    case DENSE:
        return any < 13107 ? 13107 : any;
    default:
        return any;
    }
}

/* Random entries of 8 or 16 bits a channel. */
static inline void source_entries(uint16_t *to, unsigned count, int wide, source_filling filling,
                                  uint32_t *seed)
{
    uint8_t *narrow = (uint8_t *)to;
    for (unsigned i = 0; i < 4 * count; i++) {
        uint16_t channel = (uint16_t)(random_next(seed) >> 8);
        if (i % 4 == 3)
            channel = source_fourth(filling, random_next(seed));
        if (wide)
            to[i] = channel;
        else
            narrow[i] = (uint8_t)(filling == FAINT && i % 4 == 3 ? channel : channel >> 8);
    }
}

static inline void source_make(source *s, uint8_t storage, const uint16_t size[3],
                               source_filling filling, uint32_t *seed)
{
    const int wide = source_is_wide(storage);
    source_shape(s, storage, size);
    if (!source_is_indexed(storage)) {
        source_entries(s->voxels, SOURCE_VOXELS, wide, filling, seed);
        return;
    }
    source_entries(s->palette, QV_PALETTE_ENTRIES, wide, filling, seed);
    for (unsigned i = 0; i < SOURCE_VOXELS; i++)
        s->voxels[i] = (uint16_t)random_next(seed);
}

/* Turns the volume round on an axis: the last voxel becomes the first. */
static inline void source_turn(source *s, unsigned axis)
{
    s->volume.voxels += (s->volume.size[axis] - 1) * s->volume.stride[axis];
    s->volume.stride[axis] = -s->volume.stride[axis];
}

static inline size_t source_coarser_bytes(const qv_volume *v)
{
    size_t bytes = (size_t)source_entry_bytes(v->storage);
    for (unsigned axis = 0; axis < 3; axis++)
        bytes *= (v->size[axis] + 1u) / 2u;
    return bytes;
}

#endif /* DOWNSAMPLE_FIXTURE_H */
