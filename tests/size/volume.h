/*
 * volume.h - a small volume in program memory, with empty, thin and opaque voxels in the light
 * and in the shade, so that a ray takes every way through the code.
 */
#ifndef VOLUME_H
#define VOLUME_H

#include "qvol.h"

enum { VOLUME_EDGE = 5, VOLUME_VOXELS = VOLUME_EDGE * VOLUME_EDGE * VOLUME_EDGE };

/* Describes it: QV_STORAGE_INDEXED8, opacities for a unit distance of one voxel. */
void volume_describe(qv_volume *volume);

/* Bytes of all directions. */
void volume_attenuation(qv_attenuation *attenuation);

#endif /* VOLUME_H */
