/*
 * float_renderer.h - what one writes where there is a floating-point unit: the
 * plain loop over samples in float, for the same scene and the same picture.
 * Orthographic cameras and RGBA8 storage, opacity-weighted, front to back.
 */
#ifndef FLOAT_RENDERER_H
#define FLOAT_RENDERER_H

#include "qvol.h"

/* Renders width x height pixels as R,G,B,A bytes; returns the samples taken. */
unsigned long float_render(uint8_t *rgba, const qv_scene *scene, int width, int height);

#endif /* FLOAT_RENDERER_H */
