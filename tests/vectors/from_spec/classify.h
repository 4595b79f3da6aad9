/*
 * classify.h - tests/SPEC.md, part B: sections 19 to 24, from scalars to colours.
 */
#ifndef CLASSIFY_H
#define CLASSIFY_H

#include "number.h"

number table_entry(number b, number d, number t, number n); /* section 19, t of n ways on */
number index_of_scalar(number s, number low, number high);  /* section 20 */

/* Section 21: S are spacings, none 0. */
triple gradient_scales(const triple *S); /* g */
bool is_long_enough(const triple *d, const triple *S, number at_least, number window);
triple unit(const triple *v, const triple *g);

/* Section 22: coefficients, and what a volume's light comes to. */
typedef struct lighting {
    triple light, half;
    bool has_highlight;
    number ambient, diffuse, specular, gloss;
} lighting;

/* Fills light, half and has_highlight; the coefficients are there. */
void light_directions(lighting *l, const triple *to_light, const triple *to_viewer);

typedef struct shade_steps {
    number lambert, factor, gleam, highlight;
} shade_steps;

shade_steps shade_factors(const lighting *l, const triple *normal);
number shade(const shade_steps *s, number colour);

/* Section 24. */
number reduced_mean(unsigned count, const number scalar[], number least_of_type);

#endif /* CLASSIFY_H */
