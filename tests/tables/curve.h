/*
 * curve.h - polynomials for the tables of fixedpoint, computed with MPFR.
 */
#ifndef CURVE_H
#define CURVE_H

#include <mpfr.h>
#include <stdint.h>

enum { CURVE_BITS = 200, CURVE_DEGREE_MAX = 3 };

/* A function on 0 .. 1: one segment of what is tabulated. */
typedef void curve_function(mpfr_t value, const mpfr_t place, unsigned segment);

/*
 * The polynomial of a degree up to CURVE_DEGREE_MAX that meets the function at the
 * roots of Chebyshev's polynomial, stretched so that the outermost ones are 0 and
 * 1: nearly the least error of all that are exact at both ends, and so continuous
 * from segment to segment. c[0] is the constant term.
 */
void curve_fit(mpfr_t c[], unsigned degree, curve_function *function, unsigned segment);

void curve_init(mpfr_t c[], unsigned count);
void curve_clear(mpfr_t c[], unsigned count);

/* round(value * 2^exponent), which must lie in 0 .. limit; else the program ends. */
uint32_t curve_round(const mpfr_t value, int exponent, uint32_t limit);

#endif /* CURVE_H */
