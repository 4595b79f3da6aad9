#include "layout.h"

#include "fx_wide.h"

#define LEAST_SPACING    (QV_ONE_Q16 / 256u)
#define GREATEST_SPACING (QV_ONE_Q16 * 256u)

static uint32_t magnitude(int32_t v)
{
    return v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
}

/* The axis with the smallest stride among those not in `used`; 3 where none is
   left. Axes of size 1 have no stride that matters. */
static unsigned next_axis(const uint16_t size[3], const int32_t stride[3], unsigned used)
{
    unsigned best = 3;
    for (unsigned axis = 0; axis < 3; axis++) {
        if ((used >> axis & 1u) != 0 || size[axis] == 1)
            continue;
        if (best == 3 || magnitude(stride[axis]) < magnitude(stride[best]))
            best = axis;
    }
    return best;
}

qv_status qv_layout_check(const uint16_t size[3], const int32_t stride[3], uint64_t bytes,
                          uint32_t element_bytes, uint32_t alignment)
{
    unsigned used = 0;
    uint64_t span = element_bytes; /* from the lowest byte to the highest so far */
    for (unsigned axis = 0; axis < 3; axis++)
        if (size[axis] == 0 || size[axis] > QV_AXIS_MAX)
            return QV_ERROR_SIZE;
    for (unsigned axis; (axis = next_axis(size, stride, used)) < 3; used |= 1u << axis) {
        uint32_t step = magnitude(stride[axis]);
        if (step < span || step % alignment != 0)
            return QV_ERROR_STRIDE;
        span += fx_wide_product(step, size[axis] - 1u); /* < 3 * 2^43 */
    }
    return span > bytes ? QV_ERROR_STRIDE : QV_OK;
}

qv_status qv_spacing_check(const uint32_t spacing[3])
{
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t length = qv_spacing(spacing, axis);
        if (length < LEAST_SPACING || length > GREATEST_SPACING)
            return QV_ERROR_SPACING;
    }
    return QV_OK;
}
