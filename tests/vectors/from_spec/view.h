/*
 * view.h - tests/SPEC.md, sections 2.1 and 4 to 6: from a view to a camera.
 */
#ifndef VIEW_H
#define VIEW_H

#include "number.h"
#include "ray.h"

typedef struct turn {
    number sine, cosine;
} turn;

turn turn_of(number angle);
number voxels(number length, number spacing);

/* M: right, down, forward. */
typedef struct rotation {
    triple row[3];
} rotation;

rotation rotation_of(number azimuth, number elevation, number roll);

typedef struct view {
    triple size, spacing;
    rotation M;
    number pitch, step, W, H;
} view;

camera orthographic(const view *v);
camera perspective(const view *v, number field);

#endif /* VIEW_H */
