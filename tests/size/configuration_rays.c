/*
 * configuration_rays.c - a ray caster: both cameras, a few pixels a call, voxels classified on the
 * device.
 */
#include "size.h"

size_use *const size_uses[] = {use_classification, use_orthographic, use_perspective, use_progress,
                               NULL};
