/*
 * fx_scaled.h - positive numbers with an exponent, for set-up and for lengths that no
 * one Q-format spans.
 */
#ifndef FX_SCALED_H
#define FX_SCALED_H

#include <stdint.h>

/* mantissa * 2^exponent, the mantissa 2^31 .. 2^32 - 1; or 0, with the mantissa 0. Exponents
   stay within +-16384, which callers see to. */
typedef struct fx_scaled {
    uint32_t mantissa;
    int16_t exponent;
} fx_scaled;

/* v * 2^exponent, cut to 32 bits: less by at most 2^-31 of itself. */
fx_scaled fx_scaled_of(uint64_t v, int exponent);

/* a * b, to nearest: within 2^-32 of itself. */
fx_scaled fx_scaled_times(fx_scaled a, fx_scaled b);

/* a / b, b not 0: within 2^-19.9 of itself; exact but for a product's rounding where b is a power
   of 2. */
fx_scaled fx_scaled_over(fx_scaled a, fx_scaled b);

/* a with so many fraction bits, cut, but at most `most`. */
uint32_t fx_scaled_fixed(fx_scaled a, int fraction, uint32_t most);

/* Whether a <= b. */
int fx_scaled_at_most(fx_scaled a, fx_scaled b);

#endif /* FX_SCALED_H */
