/*
 * configuration_pyramid.c - the ray caster, and pyramids.
 */
#include "size.h"

size_use *const size_uses[] = {use_classification, use_orthographic, use_perspective,
                               use_progress,       use_pyramid,      NULL};
