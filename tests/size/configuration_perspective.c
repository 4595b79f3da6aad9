/*
 * configuration_perspective.c - the same with a perspective camera.
 */
#include "size.h"

size_use *const size_uses[] = {use_perspective, NULL};
