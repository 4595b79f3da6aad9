/*
 * bricks.h - parts of a volume that are drawn one by one.
 */
#ifndef QVOL_HOST_BRICKS_H
#define QVOL_HOST_BRICKS_H

#include "qvol.h"

/*
 * The scene of a brick, `number` of them after the farthest: back to front, for bricks lie on a
 * grid. Its samples are those of the whole scene whose points lie in it; values at its faces
 * are clamped as they are at the volume's. count: bricks on each axis, at most its voxels.
 */
void brick_scene(qv_scene *brick, const qv_scene *whole, const uint32_t count[3], uint32_t number);

#endif
