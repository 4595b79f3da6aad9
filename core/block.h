/*
 * block.h - blocks of a volume.
 */
#ifndef QV_BLOCK_H
#define QV_BLOCK_H

#include "fx_wide.h"
#include "access.h"
#include "qvol.h"

/* Whether a block is not empty and lies in a box of this size. */
static inline int qv_block_valid(const qv_block *block, const uint16_t size[3])
{
    for (unsigned axis = 0; axis < 3; axis++)
        if (block->first[axis] >= block->end[axis] || block->end[axis] > size[axis])
            return 0;
    return 1;
}

/* Bytes that a valid block fills with voxels of up to 8 bytes: at most 2^36 * 8. */
static inline uint64_t qv_block_bytes(const qv_block *block, uint32_t voxel_bytes)
{
    uint32_t extent[3];
    for (unsigned axis = 0; axis < 3; axis++)
        extent[axis] = (uint32_t)block->end[axis] - block->first[axis];
    return fx_wide_product(extent[0] * extent[1], extent[2] * voxel_bytes);
}

/* Address of a voxel. Checked strides keep every sum within the memory given. */
static inline qv_address qv_voxel_at(const qv_volume *volume, const uint16_t position[3])
{
    qv_address at = volume->voxels;
    for (unsigned axis = 0; axis < 3; axis++)
        if (position[axis] != 0) /* an axis of size 1 may have any stride */
            at = qv_at(at, (qv_offset)volume->stride[axis] * (qv_offset)position[axis]);
    return at;
}

#endif /* QV_BLOCK_H */
