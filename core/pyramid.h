/*
 * pyramid.h - where the levels of a pyramid lie.
 */
#ifndef QV_PYRAMID_H
#define QV_PYRAMID_H

#include "fx_inline.h"
#include "qvol.h"
#include "storage.h"

/* Voxels on an axis of the next coarser level: half of them, rounded up. */
static inline uint16_t qv_coarser_size(uint16_t size)
{
    return (uint16_t)((size + 1u) >> 1);
}

/* Voxels on an axis of a level. */
static inline uint16_t qv_level_size(uint16_t size, unsigned level)
{
    return (uint16_t)((size + ((uint32_t)1 << level) - 1u) >> level);
}

/* Whether a checked volume can have this pyramid. QV_OK, QV_ERROR_LEVEL (also without
   a pyramid), _NULL, _STRIDE, _BUFFER. */
qv_status qv_pyramid_check(const qv_volume *volume, const qv_pyramid *pyramid);

/* Where a level lies, 0 .. pyramid->levels; 0 is the volume. */
qv_address qv_pyramid_voxels(const qv_volume *volume, const qv_pyramid *pyramid, uint8_t number);

/*
 * What sampling reads of a level, 0 .. pyramid->levels, but for its voxels: sizes and strides,
 * which are those of tightly packed entries of the storage. Written out, no more is kept of it.
 */
FX_INLINE void qv_level_shape(qv_volume *level, const qv_volume *volume, unsigned number,
                              unsigned storage)
{
    int32_t packed[3];
    level->size[0] = qv_level_size(volume->size[0], number);
    level->size[1] = qv_level_size(volume->size[1], number);
    level->size[2] = qv_level_size(volume->size[2], number);
    packed[0] = (int32_t)qv_entry_bytes(storage);
    packed[1] = packed[0] * level->size[0];
    packed[2] = packed[1] * level->size[1]; /* <= 8 * 2^22 */
    level->stride[0] = number == 0 ? volume->stride[0] : packed[0];
    level->stride[1] = number == 0 ? volume->stride[1] : packed[1];
    level->stride[2] = number == 0 ? volume->stride[2] : packed[2];
}

/* Describes a level, 1 .. pyramid->levels, of a volume and pyramid that were checked. */
void qv_pyramid_describe(qv_volume *level, const qv_volume *volume, const qv_pyramid *pyramid,
                         uint8_t number);

#endif /* QV_PYRAMID_H */
