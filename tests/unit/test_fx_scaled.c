/*
 * Numbers with an exponent: products, quotients and comparisons against doubles, over the whole
 * range of mantissas and a wide one of exponents.
 */
#include "check.h"
#include "fx_scaled.h"
#include "random.h"

#include <math.h>

#define PAIRS 200000

static double value_of(fx_scaled a)
{
    return ldexp(a.mantissa, a.exponent);
}

static fx_scaled random_number(uint32_t *random)
{
    const uint32_t high = random_next(random), shift = random_below(random, 64);
    const uint64_t v = ((uint64_t)high << 32 | random_next(random)) >> shift;
    return fx_scaled_of(v == 0 ? 1 : v, (int)random_below(random, 200) - 100);
}

static void mantissas_are_full(void **state)
{
    (void)state;
    for (unsigned bit = 0; bit < 64; bit++) {
        const uint64_t v = (uint64_t)1 << bit;
        const fx_scaled a = fx_scaled_of(v, -7), b = fx_scaled_of(v | (v - 1), -7);
        assert_int_equal(a.mantissa, 0x80000000u);
        assert_true(value_of(a) == ldexp(1, (int)bit - 7));
        assert_true(b.mantissa >= 0x80000000u);
        assert_true(value_of(b) <= ldexp((double)(v | (v - 1)), -7));
        assert_true(value_of(b) >= ldexp((double)(v | (v - 1)), -7) * (1 - ldexp(1, -31)));
    }
    assert_int_equal(fx_scaled_of(0, 5).mantissa, 0);
}

static void products_and_quotients(void **state)
{
    uint32_t random = 11;
    double worst_product = 0, worst_quotient = 0;
    (void)state;
    for (unsigned i = 0; i < PAIRS; i++) {
        const fx_scaled a = random_number(&random), b = random_number(&random);
        const double product = value_of(a) * value_of(b), quotient = value_of(a) / value_of(b);
        worst_product = fmax(worst_product, fabs(value_of(fx_scaled_times(a, b)) / product - 1));
        worst_quotient = fmax(worst_quotient, fabs(value_of(fx_scaled_over(a, b)) / quotient - 1));
    }
    assert_true(worst_product <= ldexp(1, -31));
    assert_true(worst_product > ldexp(1, -33));
    assert_true(worst_quotient <= pow(2, -19.9));
}

static void powers_of_two_divide_exactly(void **state)
{
    uint32_t random = 12;
    (void)state;
    for (int exponent = -40; exponent <= 40; exponent++) {
        const fx_scaled a = random_number(&random);
        const fx_scaled quotient = fx_scaled_over(a, fx_scaled_of(1, exponent));
        assert_int_equal(quotient.mantissa, a.mantissa);
        assert_int_equal(quotient.exponent, a.exponent - exponent);
    }
}

static void zero_stays_zero(void **state)
{
    const fx_scaled zero = fx_scaled_of(0, 0), one = fx_scaled_of(1, 0);
    (void)state;
    assert_int_equal(fx_scaled_times(zero, one).mantissa, 0);
    assert_int_equal(fx_scaled_over(zero, one).mantissa, 0);
    assert_int_equal(fx_scaled_fixed(zero, 31, 7), 0);
    assert_true(fx_scaled_at_most(zero, one) && fx_scaled_at_most(zero, zero));
    assert_false(fx_scaled_at_most(one, zero));
}

static void fixed_numbers_are_cut_and_limited(void **state)
{
    uint32_t random = 13;
    (void)state;
    for (unsigned i = 0; i < PAIRS; i++) {
        const fx_scaled a = random_number(&random);
        const int fraction = (int)random_below(&random, 64) - 16;
        const uint32_t most = random_next(&random);
        const double exact = floor(ldexp(value_of(a), fraction));
        assert_true((double)fx_scaled_fixed(a, fraction, most) == fmin(exact, most));
    }
}

static void comparisons(void **state)
{
    uint32_t random = 14;
    (void)state;
    for (unsigned i = 0; i < PAIRS; i++) {
        const fx_scaled a = random_number(&random), b = random_number(&random);
        assert_int_equal(fx_scaled_at_most(a, b), value_of(a) <= value_of(b));
        assert_true(fx_scaled_at_most(a, a));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mantissas_are_full),
        cmocka_unit_test(products_and_quotients),
        cmocka_unit_test(powers_of_two_divide_exactly),
        cmocka_unit_test(zero_stays_zero),
        cmocka_unit_test(fixed_numbers_are_cut_and_limited),
        cmocka_unit_test(comparisons),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
