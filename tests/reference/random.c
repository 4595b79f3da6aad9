#include "random.h"

#include <math.h>

ref_random ref_random_seeded(uint32_t seed)
{
    /* Any state but 0 will do; odd multiples of the golden ratio spread small seeds. */
    ref_random random = {(2 * (uint64_t)seed + 1) * 0x9e3779b97f4a7c15u};
    for (int i = 0; i < 8; i++) {
        (void)ref_random_next(&random);
    }
    return random;
}

/* xorshift64* (Vigna, 2016), upper half. */
uint32_t ref_random_next(ref_random *random)
{
    uint64_t x = random->state;
    x ^= x >> 12;
    x ^= x << 25;
    x ^= x >> 27;
    random->state = x;
    return (uint32_t)(x * 0x2545f4914f6cdd1du >> 32);
}

uint32_t ref_random_below(ref_random *random, uint32_t limit)
{
    return (uint32_t)((uint64_t)ref_random_next(random) * limit >> 32);
}

bool ref_random_once_in(ref_random *random, uint32_t n)
{
    return ref_random_below(random, n) == 0;
}

double ref_random_real(ref_random *random, double low, double high)
{
    return low + (high - low) * ref_random_next(random) / 4294967295.0;
}

double ref_random_scale(ref_random *random, double low, double high)
{
    return exp(ref_random_real(random, log(low), log(high)));
}
