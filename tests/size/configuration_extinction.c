/*
 * configuration_extinction.c - the ray caster, and sampling of extinction.
 */
#include "size.h"

size_use *const size_uses[] = {use_classification, use_orthographic, use_perspective,
                               use_progress,       use_extinction,   NULL};
