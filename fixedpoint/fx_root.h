/*
 * fx_root.h - reciprocal square root, for vectors that must have length 1.
 */
#ifndef FX_ROOT_H
#define FX_ROOT_H

#include <stdint.h>

/*
 * 1/sqrt(n) = result * 2^-30 * 2^-exponent for n >= 1, with the result in
 * 2^30 .. 2^31 and the exponent in 1 .. 32. Relative error at most 2^-28.
 * n = 0 is treated as 1. Source: Newton's iteration from a linear estimate.
 */
uint32_t fx_rsqrt(uint64_t n, unsigned *exponent);

#endif /* FX_ROOT_H */
