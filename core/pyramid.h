/*
 * pyramid.h - where the levels of a pyramid lie.
 */
#ifndef QV_PYRAMID_H
#define QV_PYRAMID_H

#include "qvol.h"

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

/* Where a level lies, 1 .. pyramid->levels, and its size. */
void qv_pyramid_place(qv_address *voxels, uint16_t size[3], const qv_volume *volume,
                      const qv_pyramid *pyramid, uint8_t number);

/* Strides of a level of this size: tightly packed entries of the storage, or of its palette. */
void qv_pyramid_strides(int32_t stride[3], const uint16_t size[3], unsigned storage);

/* Describes a level, 1 .. pyramid->levels, of a volume and pyramid that were checked. */
void qv_pyramid_describe(qv_volume *level, const qv_volume *volume, const qv_pyramid *pyramid,
                         uint8_t number);

#endif /* QV_PYRAMID_H */
