/*
 * configuration_everything.c - all that one device can use together.
 */
#include "size.h"

size_use *const size_uses[] = {use_classification, use_orthographic, use_perspective,
                               use_progress,       use_extinction,   use_dithering,
                               use_pyramid,        use_freevoxels,   NULL};
