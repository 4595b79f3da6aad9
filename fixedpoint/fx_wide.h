/*
 * fx_wide.h - the one product of two 32-bit numbers that is wider than 32 bits,
 * and the shifts that round what it leaves.
 *
 * Machines without a 32x32->64 multiplication (Cortex-M0, M23, AVR, RV32I) build it
 * from four 16x16->32 products; FX_NARROW chooses that form. Both forms give the
 * same bits.
 */
#ifndef FX_WIDE_H
#define FX_WIDE_H

#include <stdint.h>

#ifndef FX_NARROW
#if defined(__ARM_ARCH_6M__) || defined(__ARM_ARCH_8M_BASE__) || defined(__AVR__) ||               \
    (defined(__riscv) && !defined(__riscv_mul))
#define FX_NARROW 1
#else
#define FX_NARROW 0
#endif
#endif

/* a * b, exact. GCC's multiplication of 16 bits on an AVR takes a third of that of 32, which it
   takes where it sees that the operands are parts of wider ones. */
static inline uint32_t fx_product16(uint16_t a, uint16_t b)
{
#if defined(__AVR__)
    __asm__("" : "+r"(a), "+r"(b));
#endif
    return (uint32_t)a * b;
}

/* |v|, also of -2^31. */
static inline uint32_t fx_magnitude(int32_t v)
{
    return v < 0 ? 0u - (uint32_t)v : (uint32_t)v;
}

/* a * b, exact: the form for machines without a wide multiplication. */
uint64_t fx_wide_product_narrow(uint32_t a, uint32_t b);

/* round(a * b / 2^32), ties upwards: the same form's upper half. */
uint32_t fx_high_product_narrow(uint32_t a, uint32_t b);

/* The same where speed counts: what lands on bits 16 to 31 is summed up in two steps, of which
   neither passes 65535^2 + 65535 + 32768 < 2^32. */
static inline uint32_t fx_high_product_digits(uint32_t a, uint32_t b)
{
    uint16_t al = (uint16_t)a, ah = (uint16_t)(a >> 16);
    uint16_t bl = (uint16_t)b, bh = (uint16_t)(b >> 16);
    uint32_t middle = fx_product16(ah, bl) + (fx_product16(al, bl) >> 16);
    uint32_t rest = fx_product16(al, bh) + (middle & 0xFFFFu) + 0x8000u;
    return fx_product16(ah, bh) + (middle >> 16) + (rest >> 16);
}

/* a * b, exact. */
static inline uint64_t fx_wide_product(uint32_t a, uint32_t b)
{
#if FX_NARROW
    return fx_wide_product_narrow(a, b);
#else
    return (uint64_t)a * b;
#endif
}

/* round(a * b / 2^32), ties upwards. At most 2^32 - 2, so it never wraps. */
static inline uint32_t fx_high_product(uint32_t a, uint32_t b)
{
#if FX_NARROW
    return fx_high_product_narrow(a, b);
#else
    return (uint32_t)(((uint64_t)a * b + 0x80000000u) >> 32);
#endif
}

/* sum + round(a * b / 2^32), ties upwards, modulo 2^32: with the sum as the upper half of what
   is added to, one instruction where machines multiply and accumulate. */
static inline uint32_t fx_add_high_product(uint32_t sum, uint32_t a, uint32_t b)
{
#if FX_NARROW && defined(__OPTIMIZE_SIZE__)
    return sum + fx_high_product_narrow(a, b);
#elif FX_NARROW
    return sum + fx_high_product_digits(a, b);
#else
    return (uint32_t)((((uint64_t)sum << 32 | 0x80000000u) + (uint64_t)a * b) >> 32);
#endif
}

/* floor(a * b / 2^16) for a 16-bit b: a 32-bit result, since a * b < 2^48. */
static inline uint32_t fx_product_shift16(uint32_t a, uint16_t b)
{
#if FX_NARROW
    return fx_product16((uint16_t)(a >> 16), b) + (fx_product16((uint16_t)a, b) >> 16);
#else
    return (uint32_t)(((uint64_t)a * b) >> 16);
#endif
}

/* floor(v / 2^n) for 0 <= n < 63, without shifting a negative number. */
static inline int64_t fx_shift_floor(int64_t v, unsigned n)
{
    return v < 0 ? ~(~v >> n) : v >> n;
}

/* v * n modulo 2^64; exact where |v * n| < 2^63, which callers state. */
int64_t fx_multiply(int64_t v, int32_t n);

/* round(v * factor / 2^30), ties upwards; factor is Q2.30, |v| <
   2^61. Error at most 1/2 unit of v. */
int64_t fx_scale_q30(int64_t v, int32_t factor);

/* floor(n / d) by shift and subtract, for set-up; 0 < d < 2^31. */
uint64_t fx_divide(uint64_t n, uint32_t d);

/* round(n / d), ties upwards, but at most 65535, also for d = 0. In as many steps as the
   result has bits. n + d / 2 < 2^64. */
uint16_t fx_quotient16(uint64_t n, uint64_t d);

#endif /* FX_WIDE_H */
