/*
 * depth.h - tests/SPEC.md, part C: sections 27 to 30.
 */
#ifndef DEPTH_H
#define DEPTH_H

#include "number.h"

/* The numbers on the way, of the names in SPEC.md; i is the place in a table. */
typedef struct power_steps {
    number w, g, i, B, t;
} power_steps;

number transmittance_steps(number x, power_steps *on_the_way);
number transmittance(number x); /* T(x) */

typedef struct power16_steps {
    number w, g, B, t;
} power16_steps;

number transmittance16_steps(number x, power16_steps *on_the_way);
number transmittance16(number x); /* T16(x) */

typedef struct depth_steps {
    number w, n, i, e, p;
} depth_steps;

number depth_of_steps(number t, depth_steps *on_the_way); /* all 0 for t = 0 */
number depth_of(number t);                                /* D(t) */
number depth_of_opacity(number a);                        /* D(65537 (65535 - a)) */
number ext16(number a);
number recip_steps(number v, depth_steps *on_the_way);
number recip(number v);
number phi(number x);

/* unorm16 of 2^31 - T(d), as in sections 30 and 31. */
number opacity_of_depth(number d);

number scale(number x, number k);
number correct(number a, number k);
number correction_factor(number a, number k); /* factor(a, k) */

#endif /* DEPTH_H */
