/*
 * splat_over.h - conventional splatting of a FreeVoxel file, back to front, for comparison.
 */
#ifndef QVOL_HOST_SPLAT_OVER_H
#define QVOL_HOST_SPLAT_OVER_H

#include "splat_frame.h"

/* Draws the finest level of the scene. Returns how many voxels had opacity. */
uint64_t splat_over_render(struct frame *frame, const struct freevoxel_file *file,
                           const qv_splats *splats, const struct settings *settings);

#endif
