/*
 * depth.h - tests/SPEC.md, part C: sections 27 to 30.
 */
#ifndef DEPTH_H
#define DEPTH_H

#include "number.h"

/* The numbers on the way, of the names in SPEC.md; i is the place in a table. */
typedef struct power_steps {
    number w, g, i, B, t, s, r, power;
} power_steps;

number transmittance_steps(number x, power_steps *on_the_way);
number transmittance(number x); /* T(x) */

typedef struct power16_steps {
    number w, g, B, t, r, p, q;
} power16_steps;

number transmittance16_steps(number x, power16_steps *on_the_way);
number transmittance16(number x); /* T16(x) */

typedef struct depth_steps {
    number w, n, i, e, p, r;
} depth_steps;

number depth_of_steps(number t, depth_steps *on_the_way);
number depth_of(number t); /* D(t) */
number ext16(number a);
number recip(number v);

typedef struct phi_steps {
    number o, y, i, b, c, s, v;
} phi_steps;

number phi_with_steps(number x, phi_steps *on_the_way);
number phi(number x);

number scale(number x, number k);
number correct(number a, number k);
number correction_factor(number a, number k); /* factor(a, k) */

#endif /* DEPTH_H */
