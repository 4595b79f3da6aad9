#include "curve.h"

static uint64_t morton_index(const uint16_t size[3], const uint16_t position[3])
{
    return qv_curve_index(size, position, NULL);
}

static void morton_position(uint16_t position[3], const uint16_t size[3], uint64_t index)
{
    qv_curve_position(position, size, index, NULL);
}

QV_DESCRIPTOR qv_order qv_order_morton = {morton_index, morton_position};
