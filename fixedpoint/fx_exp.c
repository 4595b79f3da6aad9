#include "fx_exp.h"

#include "fx_exp_table.h"
#include "fx_wide.h"

/* A power of 2 splits into one of the table's 64 and the rise from there, which is
   below 2^(1/64) - 1. Rises are in units of 1/64: below .7, Q0.32. */
#define SEGMENT_BITS 6
#define PLACE_BITS   (32 - SEGMENT_BITS)

/*
 * 2^exponent for an exponent in 0 .. 1, Q0.32, as Q1.31. Error at most .53 before
 * the last rounding, downwards. Every term grows with the place in the segment, so
 * that rounding cannot make the sum fall.
 */
static uint32_t power32(uint32_t exponent)
{
    uint32_t base = fx_table32(&exp_power[exponent >> PLACE_BITS]);
    uint32_t place = exponent << SEGMENT_BITS;
    uint32_t square = EXP_SQUARE + (EXP_CUBE * (place >> 16) >> 16); /* EXP_CUBE < 2^16 */
    uint32_t rise = fx_high_product(place, EXP_LINEAR + fx_high_product(place, square));
    return base + (fx_high_product(base, rise) >> SEGMENT_BITS); /* <= 2 * (2^31 - 1) */
}

/* -depth = fraction - whole with a fraction in 0 .. 1: a power of 2 and a shift. */
uint32_t fx_transmittance(fx_depth depth)
{
    uint32_t fraction = 0u - (uint32_t)depth;
    uint32_t whole = (uint32_t)(depth >> 32);
    if (whole >= 32u)
        return 0;
    if (fraction == 0)
        return FX_CLEAR_Q31 >> whole;
    uint32_t twice = power32(fraction) >> whole; /* up to 2^32 - 1 */
    return (twice >> 1) + (twice & 1u);
}

#define DEPTH16_END  0x11000000u /* 17: 65535 * 2^-17 rounds to 0 */
#define FRACTION_24  0xFFFFFFu
#define PLACE16_BITS (24 - SEGMENT_BITS)

/*
 * As above with 16-bit factors: the place has 18 bits, whose lower two meet the
 * slope's mean; the base is off by up to 2^-16 of 1 when it meets the rise, which
 * moves a transmittance by less than .006 of 1/65535.
 */
static uint32_t power16(uint32_t exponent)
{
    uint32_t base = fx_table32(&exp_power[exponent >> PLACE16_BITS]);
    uint32_t place = (exponent >> 2) & 0xFFFFu, rest = exponent & 3u;
    uint32_t slope = EXP16_LINEAR + (EXP16_SQUARE * place >> 8); /* EXP16_SQUARE < 2^16 */
    uint32_t rise = fx_product_shift16(slope, (uint16_t)place) + rest * EXP16_REST;
    return base + (fx_product_shift16(rise, (uint16_t)((base + 0x8000u) >> 16)) >> SEGMENT_BITS);
}

fx_unorm16 fx_transmittance16(uint32_t depth)
{
    uint32_t fraction = (0u - depth) & FRACTION_24;
    uint32_t whole = depth >> 24;
    uint32_t power = fraction == 0 ? FX_CLEAR_Q31 : power16(fraction) >> 1;
    if (depth >= DEPTH16_END)
        return 0;
    power -= power >> 16; /* times 65535/65536 */
    return (fx_unorm16)(((power >> (14u + whole)) + 1u) >> 1);
}
