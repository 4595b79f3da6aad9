#include "fx_dither.h"

uint32_t fx_hash(uint32_t v)
{
    v ^= v >> 16;
    v *= 0x7FEB352Du;
    v ^= v >> 15;
    v *= 0x846CA68Bu;
    return v ^ (v >> 16);
}

/* min(floor(n / d), 2^bits - 1) by shift and subtract: d << bits never passes n. */
static uint32_t quotient(uint32_t n, uint32_t d, unsigned bits)
{
    uint32_t q = 0;
    while (bits-- != 0)
        if (n >> bits >= d) {
            n -= d << bits;
            q |= (uint32_t)1 << bits;
        }
    return q;
}

fx_period fx_period_of(uint32_t slices)
{
    fx_period period = {slices, quotient(((uint32_t)1 << 18) + slices - 1u, slices, 18)};
    return period;
}

uint32_t fx_phase(const fx_period *period, uint32_t slice)
{
    return slice - period->slices * quotient(slice, period->slices, 31);
}

/* With 17 fraction bits, the lowest of which is the rounding's half; 7 bits of the quotient
   hold any period. */
uint32_t fx_hits(const fx_period *period, uint32_t opacity, uint32_t base, uint32_t bump)
{
    uint32_t rest = opacity - (base << 16);                 /* at most 255 * 2^16 */
    uint32_t n = 2u * period->slices * rest + (bump << 16); /* at most 129 * 255 * 2^16 < 2^32 */
    uint32_t hits = quotient(n, bump << 17, 7);
    return hits < period->slices ? hits : period->slices;
}

uint32_t fx_plateau(uint32_t opacity, uint32_t full)
{
    return opacity == 0 ? 0 : full - quotient(full >> 1, opacity, 16);
}

uint32_t fx_overcoming(uint32_t value, uint32_t full)
{
    return value == full ? full + 1u : quotient(full >> 1, full - value, 16) + 1u;
}

uint32_t fx_bump(uint32_t value, uint32_t base)
{
    uint32_t bump = 1;
    while (bump < 255u && bump * (255u - value) < 128u)
        bump = 2u * bump + 1u;
    return bump < 255u - base ? bump : 255u - base;
}
