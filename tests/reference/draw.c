#include "draw.h"

#include <math.h>

draws draw_seeded(uint32_t seed)
{
    /* Any state but 0 will do; odd multiples of the golden ratio spread small seeds. */
    draws random = {(2 * (uint64_t)seed + 1) * 0x9e3779b97f4a7c15u};
    for (int i = 0; i < 8; i++) {
        (void)draw_bits(&random);
    }
    return random;
}

/* xorshift64* (Vigna, 2016), upper half. */
uint32_t draw_bits(draws *from)
{
    uint64_t x = from->state;
    x ^= x >> 12;
    x ^= x << 25;
    x ^= x >> 27;
    from->state = x;
    return (uint32_t)(x * 0x2545f4914f6cdd1du >> 32);
}

uint32_t draw_below(draws *from, uint32_t limit)
{
    return (uint32_t)((uint64_t)draw_bits(from) * limit >> 32);
}

bool draw_once_in(draws *from, uint32_t n)
{
    return draw_below(from, n) == 0;
}

double draw_real(draws *from, double low, double high)
{
    return low + (high - low) * draw_bits(from) / 4294967295.0;
}

double draw_scale(draws *from, double low, double high)
{
    return exp(draw_real(from, log(low), log(high)));
}
