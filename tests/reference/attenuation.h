/*
 * attenuation.h - how much light passes between a voxel and the outside of its volume, in real
 * numbers, from the declarations of qvol.h alone. Depths are in base 2.
 */
#ifndef REFERENCE_ATTENUATION_H
#define REFERENCE_ATTENUATION_H

#include "qvol.h"

/* -1, 0 or 1 on each axis. */
void ref_direction_step(int step[3], int direction);

/* The depth of a voxel along a whole step of a direction. */
double ref_step_depth(const qv_volume *volume, int direction, const int32_t at[3]);

/* The depth of all voxels from a voxel to the outside, without its own. */
double ref_outer_depth(const qv_volume *volume, int direction, const int32_t at[3]);

/* The same for every voxel of a volume, x fastest. */
void ref_outer_depths(double *depths, const qv_volume *volume, int direction);

/* The mean over the voxels of a block of level 1 and up, of depths that count as 64 at most. */
double ref_mean_depth(const double *depths, const uint16_t size[3], int level, const int32_t at[3]);

/* 255 times what passes: the byte before it is rounded. */
double ref_attenuation(double depth);

#endif /* REFERENCE_ATTENUATION_H */
