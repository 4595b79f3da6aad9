/*
 * Source: FreeVoxels, section 4.3.
 */
#include "qvol.h"

#include "attenuation.h"
#include "block.h"
#include "cell.h"
#include "entry.h"
#include "lighting.h"
#include "order.h"
#include "overlap.h"

/* What the voxels of one call share. */
typedef struct pass {
    const qv_volume *volume;
    const qv_attenuation *attenuation; /* null: no lamp shines */
    const qv_lighting *lighting;
    uint16_t record; /* of the attenuation */
    qv_bearing lamp[QV_LAMPS_MAX];
} pass;

/* The bytes of a voxel; null where no lamp shines. */
static qv_address bytes_of(const pass *p, const uint16_t position[3])
{
    if (!p->attenuation)
        return 0;
    return qv_attenuation_of(p->attenuation, p->record, position);
}

/* A voxel's entry, lit: at most 8 bytes. */
static void light_voxel(uint8_t *to, const pass *p, const uint16_t position[3])
{
    const qv_volume *volume = p->volume;
    qv_address voxel = qv_voxel_at(volume, position);
    fx_unorm16 entry[4];
    qv_entry_read(entry, qv_entry(voxel, volume, volume->storage), volume->storage);
    qv_lighting_colour(entry, p->lighting, p->lamp, bytes_of(p, position));
    qv_entry_write(to, volume->storage, entry);
}

static FX_NOINLINE void light_block(uint8_t *to, const pass *p, const qv_block *block)
{
    uint16_t at[3];
    for (at[2] = block->first[2]; at[2] < block->end[2]; at[2]++)
        for (at[1] = block->first[1]; at[1] < block->end[1]; at[1]++)
            for (at[0] = block->first[0]; at[0] < block->end[0]; at[0]++) {
                light_voxel(to, p, at);
                to += qv_entry_bytes(p->volume->storage);
            }
}

static qv_status check_attenuation(const qv_attenuation *attenuation, const uint16_t size[3])
{
    if (!attenuation || !attenuation->records)
        return QV_ERROR_NULL;
    qv_status status = qv_attenuation_check(attenuation, attenuation->bytes);
    return status == QV_OK && !qv_box_equals(attenuation->size, size) ? QV_ERROR_SIZE : status;
}

/* Whether each voxel of a valid block is written where it is itself, after it was read. */
static int in_place(uintptr_t distance, const qv_volume *volume, const qv_block *block)
{
    uint32_t packed = qv_entry_bytes(volume->storage); /* for z at most 8 * 2^24; then unused */
    if (distance != 0 || qv_storage_indexed(volume->storage))
        return 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t extent = (uint32_t)block->end[axis] - block->first[axis];
        int moves = extent > 1 && volume->stride[axis] != (int32_t)packed;
        if (moves || extent != volume->size[axis])
            return 0;
        packed *= extent;
    }
    return 1;
}

/* Whether a block would be written over what it is made of. */
static FX_NOINLINE int overlaps(const void *to, const pass *p, const qv_block *block)
{
    uint64_t bytes = qv_block_bytes(block, qv_entry_bytes(p->volume->storage));
    uintptr_t distance;
    if (qv_palette_meets(p->volume, to, bytes))
        return 1;
    if (p->attenuation && qv_records_meet(p->attenuation, to, bytes))
        return 1;
    return qv_voxels_meet(p->volume, to, bytes) &&
           !(qv_distance(&distance, to, p->volume->voxels) && in_place(distance, p->volume, block));
}

/* Checks what is lit, and by what. */
static FX_NOINLINE qv_status check(const pass *p, uint8_t interpolation)
{
    qv_status status = qv_volume_check(p->volume);
    if (status == QV_OK)
        status = qv_lighting_check(p->lighting);
    if (status == QV_OK && interpolation > QV_BETWEEN_DEPTHS)
        status = QV_ERROR_DIRECTION;
    if (status != QV_OK || p->lighting->count == 0)
        return status;
    return check_attenuation(p->attenuation, p->volume->size);
}

/* The bearings of lamps, if any shines. */
static qv_status set_lamps(pass *p, uint8_t interpolation)
{
    if (p->lighting->count == 0)
        return QV_OK;
    p->record = qv_attenuation_record(p->attenuation);
    qv_compass compass;
    qv_compass_of(&compass, p->volume, p->attenuation->directions, interpolation);
    return qv_lighting_bearings(p->lamp, p->lighting, &compass, p->volume->spacing);
}

qv_status qv_illuminate(void *voxels, size_t bytes, const qv_volume *volume,
                        const qv_attenuation *attenuation, const qv_lighting *lighting,
                        uint8_t interpolation, const qv_block *block)
{
    if (!voxels || !lighting || !block)
        return QV_ERROR_NULL;
    pass p = {.volume = volume,
              .attenuation = lighting->count != 0 ? attenuation : NULL,
              .lighting = lighting};
    qv_status status = check(&p, interpolation);
    if (status == QV_OK)
        status = set_lamps(&p, interpolation);
    if (status != QV_OK)
        return status;
    if (!qv_block_valid(block, volume->size))
        return QV_ERROR_SIZE;
    if (bytes < qv_block_bytes(block, qv_entry_bytes(volume->storage)))
        return QV_ERROR_BUFFER;
    if (overlaps(voxels, &p, block))
        return QV_ERROR_OVERLAP;
    light_block((uint8_t *)voxels, &p, block);
    return QV_OK;
}
