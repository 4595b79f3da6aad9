/*
 * The reciprocal square root against the mathematics library.
 */
#include "check.h"
#include "fx_root.h"
#include "random.h"

#include <math.h>
#include <stdio.h>

static double worst;

/* Checks the stated ranges and keeps the worst relative error. */
static void measure(uint64_t n)
{
    unsigned exponent;
    const uint32_t root = fx_rsqrt(n, &exponent);
    const long double real = ldexpl(root, -30 - (int)exponent) * sqrtl((long double)n);

    if (root < 1u << 30 || root > 1u << 31 || exponent < 1 || exponent > 32)
        fail_msg("%ju: %u, exponent %u", (uintmax_t)n, root, exponent);
    worst = fmax(worst, (double)fabsl(real - 1));
}

static void error_is_below_2_to_the_minus_28(void **state)
{
    uint32_t seed = 43;
    (void)state;

    worst = 0;
    for (uint64_t n = 1; n <= 1000000; n++)
        measure(n);
    for (unsigned bit = 1; bit < 64; bit++) {
        measure(((uint64_t)1 << bit) - 1);
        measure((uint64_t)1 << bit);
        measure(((uint64_t)1 << bit) + 1);
        for (unsigned i = 0; i < 20000; i++) {
            uint64_t any = (uint64_t)random_next(&seed) << 32;
            any |= random_next(&seed);
            measure((any | (uint64_t)1 << 63) >> (63 - bit));
        }
    }
    measure(UINT64_MAX);
    printf("# reciprocal square root: worst relative error %.3f * 2^-28\n", ldexp(worst, 28));
    assert_true(worst <= ldexp(1, -28));
}

static void zero_counts_as_one(void **state)
{
    unsigned of_zero, of_one;
    (void)state;

    assert_int_equal(fx_rsqrt(0, &of_zero), fx_rsqrt(1, &of_one));
    assert_int_equal(of_zero, of_one);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(error_is_below_2_to_the_minus_28),
        cmocka_unit_test(zero_counts_as_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
