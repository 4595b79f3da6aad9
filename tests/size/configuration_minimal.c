/*
 * configuration_minimal.c - the smallest useful program: one mode, an orthographic camera.
 */
#include "size.h"

size_use *const size_uses[] = {use_orthographic, NULL};
