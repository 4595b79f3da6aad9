/*
 * The reciprocal square root of every number of 64 bits. It reads the upper 32
 * bits of n once n is shifted to 2^62 or more, so every upper half with the
 * least and the greatest lower half stands for all of them: between these two,
 * 1/sqrt(n) only falls. Smaller n are shifted by whole factors of 4.
 */
#include "check.h"
#include "fx_root.h"

#include <math.h>
#include <stdio.h>

static void error_over_all_upper_halves(void **state)
{
    long double worst = 0;
    (void)state;

    for (uint64_t upper = 1u << 30; upper < (uint64_t)1 << 32; upper++) {
        const uint64_t least = upper << 32, greatest = least | 0xFFFFFFFFu;
        unsigned exponent, same;
        const uint32_t root = fx_rsqrt(least, &exponent);
        const long double real = ldexpl(root, -30 - (int)exponent);

        if (fx_rsqrt(greatest, &same) != root || same != exponent || exponent != 32 ||
            root < 1u << 30 || root > 1u << 31)
            fail_msg("upper half %ju: %u, exponent %u", (uintmax_t)upper, root, exponent);
        worst = fmaxl(worst, fabsl(real * sqrtl((long double)least) - 1));
        worst = fmaxl(worst, fabsl(real * sqrtl((long double)greatest) - 1));
    }
    printf("# reciprocal square root: worst relative error %.4f * 2^-28\n",
           (double)ldexpl(worst, 28));
    assert_true(worst <= ldexpl(1, -28));
}

/* n / 4^k has the result of n, its exponent less by k. */
static void smaller_numbers(void **state)
{
    (void)state;

    for (uint64_t n = (uint64_t)1 << 62; n < (uint64_t)3 << 62; n += ((uint64_t)1 << 42) + 12345)
        for (unsigned k = 1; k < 32; k++) {
            unsigned exponent, shifted;
            const uint64_t kept = n >> (2 * k) << (2 * k);
            const uint32_t root = fx_rsqrt(kept, &exponent);
            if (fx_rsqrt(kept >> (2 * k), &shifted) != root || shifted + k != exponent)
                fail_msg("%ju >> %u", (uintmax_t)n, 2 * k);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(error_over_all_upper_halves),
        cmocka_unit_test(smaller_numbers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
