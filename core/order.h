/*
 * order.h - boxes of voxels, and what an order is called with.
 */
#ifndef QV_ORDER_H
#define QV_ORDER_H

#include "fx_wide.h"
#include "qvol.h"

/* Whether each axis is 1 .. QV_AXIS_MAX. */
static inline int qv_box_valid(const uint16_t size[3])
{
    for (unsigned axis = 0; axis < 3; axis++)
        if (size[axis] == 0 || size[axis] > QV_AXIS_MAX)
            return 0;
    return 1;
}

/* Voxels of a valid box: at most 2^24 * 2^12. */
static inline uint64_t qv_box_voxels(const uint16_t size[3])
{
    return fx_wide_product((uint32_t)size[0] * size[1], size[2]);
}

static inline int qv_box_equals(const uint16_t size[3], const uint16_t other[3])
{
    return size[0] == other[0] && size[1] == other[1] && size[2] == other[2];
}

/* Whether a voxel lies in a box. */
static inline int qv_box_holds(const uint16_t size[3], const uint16_t position[3])
{
    return position[0] < size[0] && position[1] < size[1] && position[2] < size[2];
}

#endif /* QV_ORDER_H */
