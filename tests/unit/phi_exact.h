/*
 * phi_exact.h - phi of a depth by the mathematics library.
 */
#ifndef QV_PHI_EXACT_H
#define QV_PHI_EXACT_H

#include <math.h>
#include <stdint.h>

#define LN_2 0.693147180559945309417232121458176568L

/* (1 - 2^-x) / (x ln 2) of a depth in Q32.32. */
static inline long double phi_exact(uint64_t depth)
{
    const long double t = ldexpl((long double)depth, -32) * LN_2;
    return depth == 0 ? 1 : -expm1l(-t) / t;
}

#endif /* QV_PHI_EXACT_H */
