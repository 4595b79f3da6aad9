#include "fx_wide.h"
#include "qvol.h"

/* z * y * x places: at most 2^12 * 2^24. */
static uint64_t linear_index(const uint16_t size[3], const uint16_t position[3])
{
    uint32_t slice = (uint32_t)size[0] * size[1];
    uint32_t within = (uint32_t)size[0] * position[1] + position[0];
    return fx_wide_product(slice, position[2]) + within;
}

static void linear_position(uint16_t position[3], const uint16_t size[3], uint64_t index)
{
    uint32_t slice = (uint32_t)size[0] * size[1];
    uint64_t z = fx_divide(index, slice);
    uint32_t within = (uint32_t)(index - fx_wide_product(slice, (uint32_t)z)); /* < 2^24 */
    position[0] = (uint16_t)(within % size[0]);
    position[1] = (uint16_t)(within / size[0]);
    position[2] = (uint16_t)z;
}

QV_DESCRIPTOR qv_order qv_order_linear = {linear_index, linear_position};
