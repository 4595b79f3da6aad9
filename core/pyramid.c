#include "pyramid.h"

#include "fx_wide.h"
#include "access.h"
#include "layout.h"

/* Offsets of voxels must fit a qv_offset, which is signed. */
#define OFFSET_BITS (8u * sizeof(qv_offset) - 1u)

static void halve(uint16_t size[3])
{
    for (unsigned axis = 0; axis < 3; axis++)
        size[axis] = qv_coarser_size(size[axis]);
}

/* Levels hold entries, not indices. At most 2^22 * 2^14. */
static uint64_t level_bytes(const uint16_t size[3], unsigned storage)
{
    return fx_wide_product((uint32_t)size[0] * size[1], size[2] * qv_entry_bytes(storage));
}

uint8_t qv_pyramid_levels(const uint16_t size[3])
{
    uint8_t levels = 0;
    uint16_t level[3] = {size[0], size[1], size[2]};
    for (; level[0] > 1 || level[1] > 1 || level[2] > 1; halve(level))
        levels++;
    return levels;
}

uint64_t qv_pyramid_bytes(const uint16_t size[3], uint8_t storage, uint8_t levels)
{
    uint64_t bytes = 0;
    uint16_t level[3] = {size[0], size[1], size[2]};
    for (; levels != 0; levels--) {
        halve(level);
        bytes += level_bytes(level, storage);
    }
    return bytes;
}

qv_status qv_pyramid_check(const qv_volume *volume, const qv_pyramid *pyramid)
{
    if (!pyramid)
        return QV_ERROR_LEVEL;
    if (qv_storage_associated(volume->storage))
        return QV_ERROR_STORAGE;
    if (!pyramid->voxels)
        return QV_ERROR_NULL;
    if (pyramid->levels == 0 || pyramid->levels > qv_pyramid_levels(volume->size))
        return QV_ERROR_LEVEL;
    if (!qv_aligned(pyramid->voxels, qv_channel_bytes(volume->storage)))
        return QV_ERROR_STRIDE;
    uint64_t bytes = qv_pyramid_bytes(volume->size, volume->storage, pyramid->levels);
    return bytes > pyramid->bytes || bytes >> OFFSET_BITS != 0 ? QV_ERROR_BUFFER : QV_OK;
}

/* The spacing of a level; what cannot be held becomes the most that can. */
static uint32_t wider(uint32_t spacing, uint8_t number)
{
    return spacing > 0xFFFFFFFFu >> number ? 0xFFFFFFFFu : spacing << number;
}

qv_address qv_pyramid_voxels(const qv_volume *volume, const qv_pyramid *pyramid, uint8_t number)
{
    if (number == 0)
        return volume->voxels;
    uint64_t before = qv_pyramid_bytes(volume->size, volume->storage, (uint8_t)(number - 1u));
    return qv_at(pyramid->voxels, (qv_offset)before);
}

void qv_pyramid_describe(qv_volume *level, const qv_volume *volume, const qv_pyramid *pyramid,
                         uint8_t number)
{
    unsigned storage = qv_entry_storage(volume->storage);
    qv_volume v = *volume;
    v.voxels = qv_pyramid_voxels(volume, pyramid, number);
    qv_level_shape(&v, volume, number, storage);
    v.palette = 0;
    v.palette_bytes = 0;
    v.storage = (uint8_t)storage;
    for (unsigned axis = 0; axis < 3; axis++)
        v.spacing[axis] = wider(qv_spacing(volume->spacing, axis), number);
    v.voxels_bytes = level_bytes(v.size, storage);
    *level = v;
}

qv_status qv_pyramid_level(qv_volume *level, const qv_volume *volume, const qv_pyramid *pyramid,
                           uint8_t number)
{
    if (!level)
        return QV_ERROR_NULL;
    qv_status status = qv_volume_check(volume);
    if (status != QV_OK)
        return status;
    if (number == 0) {
        *level = *volume;
        return QV_OK;
    }
    status = qv_pyramid_check(volume, pyramid);
    if (status != QV_OK)
        return status;
    if (number > pyramid->levels)
        return QV_ERROR_LEVEL;
    qv_pyramid_describe(level, volume, pyramid, number);
    return QV_OK;
}
