/*
 * slices.h - tests/SPEC.md, sections 51 and 57: opacities that take turns from slice to slice.
 */
#ifndef SLICES_H
#define SLICES_H

#include "number.h"

/* Section 51. */
typedef struct technique {
    number period, slope[2], cutoff;
} technique;

/* A slice in a pixel: its phase, and u where it hits at random. */
typedef struct turn_of_slice {
    bool is_random;
    number phase, u;
} turn_of_slice;

number rounded_opacity(number o);
number simple_opacity(const technique *t, number o, const turn_of_slice *at);
number bumped_opacity(const technique *t, number o, number v, const turn_of_slice *at);
number corrected_opacity(number o, number c, number v, number u);

/* Section 57: n is the slice's number in its order. */
enum sequence { SEQUENCE_ROUNDED, SEQUENCE_GOLDEN, SEQUENCE_HASHED, SEQUENCE_BLOCKS };

number slice_dither(enum sequence of, number n, number frame, number shift, bool has_technique);
number slice_phase(number n, number frame, number shift, number period);

#endif /* SLICES_H */
