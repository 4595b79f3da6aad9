/*
 * ray.h - tests/SPEC.md, sections 8 to 11 and 37 and 38: where samples lie.
 */
#ifndef RAY_H
#define RAY_H

#include "number.h"

/* Of a camera, sections 6 and 7. */
typedef struct camera {
    triple origin, across, down, along, pace;
    bool is_perspective;
} camera;

/* The numbers on the way of a perspective ray; NULL where SPEC.md does not reach them. */
typedef struct ray_steps {
    triple v, m, unit;
    number h, N, r, e;
} ray_steps;

typedef struct ray {
    triple place, advance;
    number first_sample; /* the least number of a sample */
    bool is_there;       /* a pixel may have none */
} ray;

ray ray_of_pixel(const camera *c, number x, number y, number phase, ray_steps *step);

/* The numbers of its samples, from first to last: none where last is less. */
typedef struct span {
    number first, last;
} span;

span clip(const ray *r, const triple *size);

/* The point of a sample in the box, section 10. */
triple sample_point(const ray *r, number k);

typedef struct cell {
    triple i, f, i0, i1;
} cell;

cell cell_of_point(const triple *point, const triple *size);
number corner_index(const cell *c, unsigned q, unsigned axis);
number address(const triple *index, const triple *stride);

/* Section 11, with the products on the way. */
typedef struct weights {
    number xy, xz, yz, xyz;
    number w[8];
} weights;

weights weights_of(const triple *f);

#endif /* RAY_H */
