#include "unit_vector.h"

#include "fx_angle.h"
#include "fx_root.h"
#include "fx_wide.h"

/* |v| * scale, below 2^64 by contract. */
static uint64_t extent(int32_t v, uint64_t scale)
{
    uint32_t size = v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
    uint64_t high = fx_wide_product(size, (uint32_t)(scale >> 32)); /* < 2^32 */
    return (high << 32) + fx_wide_product(size, (uint32_t)scale);
}

/* How far to shift right to bring the largest of the extents below 2^30. */
static unsigned excess(uint64_t largest)
{
    unsigned shift = 0;
    for (; largest >= (uint64_t)1 << 30; largest >>= 1)
        shift++;
    return shift;
}

void qv_unit_vector(int32_t unit[3], const int32_t v[3], const uint64_t scale[3])
{
    uint64_t all = 0, square = 0;
    uint32_t part[3];
    unsigned exponent;

    for (unsigned axis = 0; axis < 3; axis++)
        all |= extent(v[axis], scale[axis]);
    unsigned shift = excess(all);
    for (unsigned axis = 0; axis < 3; axis++) {
        part[axis] = (uint32_t)(extent(v[axis], scale[axis]) >> shift); /* < 2^30 */
        square += fx_wide_product(part[axis], part[axis]);              /* < 3 * 2^60 */
    }
    uint32_t root = fx_rsqrt(square, &exponent); /* exponent >= 1 */
    for (unsigned axis = 0; axis < 3; axis++) {
        uint64_t product = fx_wide_product(part[axis], root); /* < 2^61 */
        int32_t size = (int32_t)((product + ((uint64_t)1 << (exponent - 1))) >> exponent);
        size = size > FX_ONE_Q30 ? FX_ONE_Q30 : size;
        unit[axis] = v[axis] < 0 ? -size : size;
    }
}

uint32_t qv_unit_cosine(const int32_t a[3], const int32_t b[3])
{
    int64_t sum = 0;
    for (unsigned axis = 0; axis < 3; axis++)
        sum += fx_scale_q30(a[axis], b[axis]);
    if (sum < 0)
        return 0;
    return sum > FX_ONE_Q30 ? FX_ONE_Q30 : (uint32_t)sum;
}
