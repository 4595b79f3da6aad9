#include "fx_scaled.h"

#include "fx_log.h"
#include "fx_wide.h"

#define LEAST_MANTISSA 0x80000000u

fx_scaled fx_scaled_of(uint64_t v, int exponent)
{
    fx_scaled scaled = {0, 0};
    if (v == 0)
        return scaled;
    for (; v >> 32 != 0; v >>= 1)
        exponent++;
    for (; v < LEAST_MANTISSA; v <<= 1)
        exponent--;
    scaled.mantissa = (uint32_t)v;
    scaled.exponent = (int16_t)exponent;
    return scaled;
}

fx_scaled fx_scaled_times(fx_scaled a, fx_scaled b)
{
    uint64_t product = fx_wide_product(a.mantissa, b.mantissa); /* 0 or 2^62 .. 2^64 - 2^33 + 1 */
    uint32_t high = (uint32_t)(product >> 32), low = (uint32_t)product;
    int exponent = a.exponent + b.exponent + 32;
    if (high == 0)
        return fx_scaled_of(0, 0);
    if (high < LEAST_MANTISSA) {
        high = high << 1 | low >> 31;
        low <<= 1;
        exponent--;
    }
    high += low >> 31;
    if (high == 0) { /* rounded up to 2^32 */
        high = LEAST_MANTISSA;
        exponent++;
    }
    fx_scaled scaled = {high, (int16_t)exponent};
    return scaled;
}

/* 1 / (mantissa * 2^exponent): fx_reciprocal takes mantissa / 2 as Q1.31, that is the mantissa by
   2^32, and gives Q5.27. */
static fx_scaled reciprocal(fx_scaled a)
{
    if (a.mantissa == LEAST_MANTISSA)
        return fx_scaled_of(1, -31 - a.exponent);
    return fx_scaled_of(fx_reciprocal(a.mantissa >> 1), -27 - 32 - a.exponent);
}

fx_scaled fx_scaled_over(fx_scaled a, fx_scaled b)
{
    return fx_scaled_times(a, reciprocal(b));
}

uint32_t fx_scaled_fixed(fx_scaled a, int fraction, uint32_t most)
{
    int shift = -a.exponent - fraction;
    if (a.mantissa == 0 || shift >= 32)
        return 0;
    if (shift < 0 || a.mantissa >> shift > most)
        return most;
    return a.mantissa >> shift;
}

int fx_scaled_at_most(fx_scaled a, fx_scaled b)
{
    if (a.mantissa == 0 || b.mantissa == 0)
        return a.mantissa == 0;
    if (a.exponent != b.exponent)
        return a.exponent < b.exponent;
    return a.mantissa <= b.mantissa;
}
