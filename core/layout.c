#include "layout.h"

#include "fx_wide.h"

#define LEAST_SPACING    (QV_ONE_Q16 / 16u)
#define GREATEST_SPACING (QV_ONE_Q16 * 256u)

/* Every offset within the memory must fit a qv_offset, which is signed. */
#define OFFSET_BITS (8u * sizeof(qv_offset) - 1u)

static uint32_t magnitude(int32_t v)
{
    return v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
}

/* Bytes from the first element to the last along every axis whose step is at most
   `limit`, and one element more. Below 3 * 2^43. */
static uint64_t span(const uint16_t size[3], const uint32_t step[3], uint32_t limit,
                     uint32_t element_bytes)
{
    uint64_t bytes = element_bytes;
    for (unsigned axis = 0; axis < 3; axis++)
        if (step[axis] <= limit)
            bytes += fx_wide_product(step[axis], size[axis] - 1u);
    return bytes;
}

/*
 * An axis nests in the others where its step, the stride's magnitude, is at least
 * what the axes of smaller steps span; the span up to and with its own is then at
 * most size times its step. (Two axes of equal step fail: one more extent is in it.)
 */
qv_status qv_layout_check(const uint16_t size[3], const int32_t stride[3], uint64_t bytes,
                          uint32_t element_bytes, uint32_t alignment)
{
    uint32_t step[3];
    for (unsigned axis = 0; axis < 3; axis++) {
        if (size[axis] == 0 || size[axis] > QV_AXIS_MAX)
            return QV_ERROR_SIZE;
        step[axis] = magnitude(stride[axis]);
    }
    for (unsigned axis = 0; axis < 3; axis++)
        if (size[axis] != 1 &&
            ((step[axis] & (alignment - 1u)) != 0 ||
             span(size, step, step[axis], element_bytes) > fx_wide_product(step[axis], size[axis])))
            return QV_ERROR_STRIDE;
    uint64_t all = span(size, step, 0xFFFFFFFFu, element_bytes);
    return all > bytes || all >> OFFSET_BITS != 0 ? QV_ERROR_STRIDE : QV_OK;
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
