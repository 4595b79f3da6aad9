/*
 * dither.h - tests/SPEC.md, sections 45, 46 and 48 to 52: frame buffers of few bits.
 */
#ifndef DITHER_H
#define DITHER_H

#include "number.h"
#include "pixels.h"

/* Section 45. */
number hash_of(number v);
number golden(number n);
number hashed(number n);
number blocks(number n);
number dither_at(number u, number x, number y, number f);

/* Section 46. */
number hits_of(number P, number o, number base, number bump);
bool hits_ordered(number P, number hits, number n);
bool hits_randomly(number P, number hits, number u);
number plateau(number o, number F);
number over_least(number v, number F); /* over(v) */
number bump_of(number v, number base); /* bump(v, base) */

/* Section 47: o32 for M slices in place of N. */
number opacity_for_slices(number o32, number N, number M);

/* Section 48; n is the bits of a state, f its fraction bits. */
number light_opacity(number o32);        /* A */
number opacity32_of_level(number level); /* o32 of v */
number div_ones(number x, unsigned n);   /* div(x) */
number blend_plain(number S, number c, number a, unsigned n);
number blend_associated(number S, number c, number a, unsigned n);
number blend_dithered(number S, number C, number A, number u, unsigned f);
number blend_24(number S, number C, number o32, number u);

/* Section 49. */
number rest_behind(number T, number o32); /* T' */
number share_of(number c, number T, unsigned f);
number blend_colour_under(number S, number c, number T, number o32, unsigned f);
number blend_light_under(number S, number C, number T, number o32, number u, unsigned f);

/* Section 50. */
number state_level(number S, unsigned f);
number state_residual(number S, unsigned f);

/* Section 52; s is R, G, B and a. */
channels replay(const channels *s, const channels *S, const channels *K);

#endif /* DITHER_H */
