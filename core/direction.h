/*
 * direction.h - the 26 directions from a voxel to its neighbours.
 */
#ifndef QV_DIRECTION_H
#define QV_DIRECTION_H

#include "qvol.h"

/* A set that names no direction that there is not, and at least one. */
static inline int qv_directions_known(uint32_t directions)
{
    return directions != 0 && (directions & ~QV_DIRECTIONS_ALL) == 0;
}

/* -1, 0 or 1 on each axis, of a direction below QV_DIRECTIONS. */
void qv_direction_step(int8_t step[3], uint8_t direction);

/* Which of a voxel's bytes is that of a direction of the set. */
uint8_t qv_direction_slot(uint32_t directions, uint8_t direction);

/* Length of (x, y, z), Q9.23 each, in the same unit: at most sqrt 3 * 256 < 2^9. Error at most
   2^-27 of itself, and half its last place. */
uint32_t qv_length_of(const uint32_t v[3]);

/* World length of a direction's step, Q9.23, in a volume of this spacing, which was checked. */
uint32_t qv_direction_length(const uint32_t spacing[3], uint8_t direction);

#endif /* QV_DIRECTION_H */
