/*
 * tables.h - the tables of tests/SPEC.md, part C, computed from what it says they hold.
 */
#ifndef TABLES_H
#define TABLES_H

#include "number.h"

/* Of these: exp_power[0 .. 63], log_reciprocal and log_depth[0 .. 31], phi[0 .. 47]. */
number exp_power(number i);
number log_reciprocal(number i);
number log_depth(number i);
number phi_end(number i);
number phi_linear(number i);
number phi_square(number i);
number phi_cube(number i);

/* log8_extinction[a], a = 0 .. 255. */
number ext8(number a);

/* Computes all of them; before numbers_keep. */
void tables_make(void);

#endif /* TABLES_H */
