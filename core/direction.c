#include "direction.h"

#include "fx_root.h"
#include "fx_wide.h"
#include "layout.h"

/* Of the 27 steps, the one to the voxel itself is no direction. */
#define MIDDLE 13u

uint8_t qv_direction(int dx, int dy, int dz)
{
    if (dx < -1 || dx > 1 || dy < -1 || dy > 1 || dz < -1 || dz > 1)
        return 255;
    unsigned step = (unsigned)(dx + 1 + 3 * (dy + 1) + 9 * (dz + 1));
    if (step == MIDDLE)
        return 255;
    return (uint8_t)(step < MIDDLE ? step : step - 1u);
}

uint8_t qv_directions_count(uint32_t directions)
{
    uint8_t count = 0;
    for (uint32_t left = directions & QV_DIRECTIONS_ALL; left != 0; left &= left - 1u)
        count++;
    return count;
}

void qv_direction_step(int8_t step[3], uint8_t direction)
{
    unsigned left = direction < MIDDLE ? direction : direction + 1u;
    for (unsigned axis = 0; axis < 3; axis++, left /= 3u)
        step[axis] = (int8_t)((int)(left % 3u) - 1);
}

uint8_t qv_direction_slot(uint32_t directions, uint8_t direction)
{
    return qv_directions_count(directions & (((uint32_t)1 << direction) - 1u));
}

/* n / sqrt(n): the square, below 3 * 2^62, is cut to 32 bits where the root multiplies it; before
   that it is shifted left by an even number of bits, so that it keeps 30 of them or more. */
uint32_t qv_length_of(const uint32_t v[3])
{
    uint64_t square = 0;
    unsigned doubled = 0, exponent;
    for (unsigned axis = 0; axis < 3; axis++)
        square += fx_wide_product(v[axis], v[axis]);
    if (square == 0)
        return 0;
    for (; square >> 62 == 0; square <<= 2)
        doubled++;
    uint32_t root = fx_rsqrt(square, &exponent); /* of 2^62 .. 2^64: the exponent is 31 or 32 */
    uint64_t length = fx_wide_product((uint32_t)(square >> 32), root); /* Q, <= 2^63 */
    unsigned shift = exponent - 2u + doubled; /* square * root * 2^-30 * 2^-exponent * 2^-doubled */
    return (uint32_t)((length + ((uint64_t)1 << (shift - 1u))) >> shift);
}

uint32_t qv_direction_length(const uint32_t spacing[3], uint8_t direction)
{
    int8_t step[3];
    uint32_t v[3];
    qv_direction_step(step, direction);
    for (unsigned axis = 0; axis < 3; axis++)
        v[axis] = step[axis] != 0 ? qv_spacing(spacing, axis) << 7 : 0; /* <= 2^24 * 2^7 */
    return qv_length_of(v);
}
