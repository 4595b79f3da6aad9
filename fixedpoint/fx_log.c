#include "fx_log.h"

#include "fx_bits.h"
#include "fx_log_table.h"
#include "fx_wide.h"

/* A number normalised to 1/2 .. 1 lies in one of 32 segments. Times the reciprocal
   of the segment's end it is 1 - gap, with a gap below 1/32. */
#define SEGMENT_BITS 5
#define SEGMENT_MASK 31u
#define ONE_Q31      0x80000000u

/* The gap of a number >= 2^31 in Q0.32: Q1.31, below 2^26. Exact but for one unit. */
static uint32_t gap_of(uint32_t number, uint16_t reciprocal)
{
    return ONE_Q31 - fx_product_shift16(number, reciprocal); /* Q0.32 * Q1.15 / 2^16 */
}

fx_depth fx_depth_of_transmittance(uint32_t transmittance)
{
    if (transmittance == 0)
        return FX_OPAQUE_DEPTH;
    unsigned whole = fx_leading_zeros(transmittance);
    uint32_t number = transmittance << whole;
    unsigned segment = (number >> (31 - SEGMENT_BITS)) & SEGMENT_MASK;
    uint32_t gap = gap_of(number, fx_table16(&log_reciprocal[segment]));
    uint32_t place = gap << (SEGMENT_BITS + 1); /* of 1/32, Q0.32 */

    /* -log2(1 - gap): at most .0444 in Q1.31; the depth of the segment's end is below 1 */
    uint32_t square = LOG_SQUARE + (LOG_CUBE * (place >> 16) >> 16); /* LOG_CUBE < 2^16 */
    uint32_t rise = fx_high_product(place, LOG_LINEAR + fx_high_product(place, square));
    /* 0 .. 1, within the error: the table's -1 meets a rise of at least 1 */
    uint32_t fraction = fx_table32(&log_depth[segment]) + rise;
    return ((fx_depth)whole << 32) + ((fx_depth)fraction << 1);
}

fx_extinction fx_extinction_of_unorm16(fx_unorm16 opacity)
{
    return (fx_extinction)((fx_depth_of_unorm16(opacity) + 0x80u) >> 8); /* <= 2^30 */
}

/*
 * 1 / (1 - gap) = (1 + gap)(1 + gap^2) but for gap^4 < 2^-20. place = 32 * gap, so
 * its square is 1024 * gap^2. What normalising has shifted v by, shifts the result
 * by as much.
 */
uint32_t fx_reciprocal(uint32_t v)
{
    uint32_t number = v == ONE_Q31 ? 0xFFFFFFFFu : v << 1;
    unsigned shift = fx_leading_zeros(number);
    number <<= shift;
    uint16_t reciprocal =
        fx_table16(&log_reciprocal[(number >> (31 - SEGMENT_BITS)) & SEGMENT_MASK]);
    uint32_t gap = gap_of(number, reciprocal), place = gap << (SEGMENT_BITS + 1);
    uint32_t sum = ONE_Q31 + gap; /* Q1.31, below 1.04 */
    sum += fx_high_product(sum, fx_high_product(place, place)) >> (2 * SEGMENT_BITS);
    return fx_product_shift16(sum, reciprocal) >> (3u - shift); /* Q2.30, to Q5.27 */
}
