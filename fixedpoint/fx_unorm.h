/*
 * fx_unorm.h - unsigned normalised numbers: n bits stand for 0 .. 1 in steps of
 * 1/(2^n - 1), so that 255 and 65535 are exactly 1.
 *
 * Division by 255 and 65535 is exact, in 32-bit arithmetic and without a
 * division: 1/255 = 1/256 + 1/256^2 + ..., and two terms and a bias decide every
 * rounding in the stated range. tests/ proves each formula for every input.
 */
#ifndef FX_UNORM_H
#define FX_UNORM_H

#include <stdint.h>

typedef uint8_t fx_unorm8;   /* 255 is 1 */
typedef uint16_t fx_unorm16; /* 65535 is 1 */

/* round(x / 255) for x <= 65662; no ties occur, 255 being odd. */
static inline uint32_t fx_div255_round(uint32_t x)
{
    uint32_t t = x + 128u;
    return (t + (t >> 8)) >> 8;
}

/* floor(x / 255) for x < 65535. */
static inline uint32_t fx_div255_floor(uint32_t x)
{
    return (x + 1u + (x >> 8)) >> 8;
}

/* round(x / 65535) for x <= 65535^2; t + (t >> 16) < 2^32. */
static inline uint32_t fx_div65535_round(uint32_t x)
{
    uint32_t t = x + 32768u;
    return (t + (t >> 16)) >> 16;
}

/* floor(x / 65535) for x <= 65535^2. */
static inline uint32_t fx_div65535_floor(uint32_t x)
{
    return (x + 1u + (x >> 16)) >> 16;
}

/* a * b, correctly rounded. */
static inline fx_unorm8 fx_unorm8_mul(fx_unorm8 a, fx_unorm8 b)
{
    return (fx_unorm8)fx_div255_round((uint32_t)a * b);
}

/* a * b, correctly rounded. */
static inline fx_unorm16 fx_unorm16_mul(fx_unorm16 a, fx_unorm16 b)
{
    return (fx_unorm16)fx_div65535_round((uint32_t)a * b);
}

/* Exact: 65535 = 255 * 257. */
static inline fx_unorm16 fx_unorm8_to_unorm16(fx_unorm8 a)
{
    return (fx_unorm16)(a * 257u);
}

/* Correctly rounded: a * 255 / 65535. */
static inline fx_unorm8 fx_unorm16_to_unorm8(fx_unorm16 a)
{
    return (fx_unorm8)(((uint32_t)a * 255u + 32895u) >> 16);
}

/* v * 65535 / 2^31 for v <= 2^31, to nearest but for 2^-15 of the last place. */
static inline fx_unorm16 fx_unorm16_of_q31(uint32_t v)
{
    return (fx_unorm16)((v - (v >> 16) + 0x4000u) >> 15);
}

#endif /* FX_UNORM_H */
