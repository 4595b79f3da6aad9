/*
 * configuration_dithering.c - the ray caster, and dithered slices.
 */
#include "size.h"

size_use *const size_uses[] = {use_classification, use_orthographic, use_perspective,
                               use_progress,       use_dithering,    NULL};
