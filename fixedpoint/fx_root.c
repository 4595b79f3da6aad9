#include "fx_root.h"

#include "fx_wide.h"

/* round(a * b / 2^31) of two numbers whose product stays below 2^63. */
static uint32_t times_q31(uint32_t a, uint32_t b)
{
    return (uint32_t)((fx_wide_product(a, b) + 0x40000000u) >> 31);
}

/*
 * Relative error of the estimate 2.13 - 1.2 x is below .09 on 1/4 .. 1; an
 * iteration takes e to 3/2 e^2, so four of them leave the rounding alone.
 */
#define ESTIMATE_AT_0  0x8851EB85u /* 2.13 in Q2.30 */
#define ESTIMATE_SLOPE 0x4CCCCCCDu /* 1.2 in Q2.30 */
#define THREE_Q30      0xC0000000u
#define ITERATIONS     4

uint32_t fx_rsqrt(uint64_t n, unsigned *exponent)
{
    unsigned shift = 0;
    if (n == 0)
        n = 1;
    while (n < (uint64_t)1 << 62) {
        n <<= 2;
        shift++;
    }
    *exponent = 32u - shift;

    uint32_t x = (uint32_t)(n >> 32);                                   /* Q0.32 in 1/4 .. 1 */
    uint32_t root = ESTIMATE_AT_0 - fx_high_product(x, ESTIMATE_SLOPE); /* Q2.30, .93 .. 1.83 */
    for (unsigned i = 0; i < ITERATIONS; i++) {
        /* x*r <= 1.1, Q1.31; x*r*r <= 1.2, Q2.30; r*(3 - x r r)/2 <= 2, Q2.30 */
        uint32_t square = times_q31(times_q31(x, root), root);
        root = times_q31(root, THREE_Q30 - square);
    }
    return root > 0x80000000u ? 0x80000000u : root;
}
