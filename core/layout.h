/*
 * layout.h - checks of how voxels or scalars lie in memory.
 */
#ifndef QV_LAYOUT_H
#define QV_LAYOUT_H

#include "qvol.h"

/*
 * Whether elements of element_bytes with these strides stay apart from each
 * other and within `bytes`. alignment is 1, 2 or 4. QV_OK, QV_ERROR_SIZE, _STRIDE.
 */
qv_status qv_layout_check(const uint16_t size[3], const int32_t stride[3], uint64_t bytes,
                          uint32_t element_bytes, uint32_t alignment);

/* qv_volume_check of all but the spacing, which may be out of range for a deep level. */
qv_status qv_voxels_check(const qv_volume *volume);

/* Whether each spacing is 0 or 1/16 .. 256. QV_OK, QV_ERROR_SPACING. */
qv_status qv_spacing_check(const uint32_t spacing[3]);

/* The spacing of an axis: Q16.16, with 0 read as 1. */
static inline uint32_t qv_spacing(const uint32_t spacing[3], unsigned axis)
{
    return spacing[axis] != 0 ? spacing[axis] : QV_ONE_Q16;
}

#endif /* QV_LAYOUT_H */
