/*
 * fx_bits.h - the place of the leading bit, for functions that normalise.
 */
#ifndef FX_BITS_H
#define FX_BITS_H

#include <stdint.h>

/* One instruction on these; elsewhere GCC would call a function of its library. */
#ifndef FX_COUNTS_ZEROS
#if defined(__ARM_FEATURE_CLZ) || (defined(__GNUC__) && defined(__x86_64__))
#define FX_COUNTS_ZEROS 1
#else
#define FX_COUNTS_ZEROS 0
#endif
#endif

/* Zeros above the leading 1 of v, which is not 0: 0 .. 31. */
static inline unsigned fx_leading_zeros(uint32_t v)
{
#if FX_COUNTS_ZEROS
    return (unsigned)__builtin_clz(v); /* int has 32 bits on these machines */
#else
    unsigned zeros = 0;
    for (unsigned step = 16; step != 0; step >>= 1)
        if (v >> (32u - step) == 0) {
            v <<= step;
            zeros += step;
        }
    return zeros;
#endif
}

#endif /* FX_BITS_H */
