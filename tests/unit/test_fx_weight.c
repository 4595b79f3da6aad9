/*
 * The numbers of interpolation: which operations are exact, how the others
 * round, and that the stated maxima fit.
 */
#include "check.h"
#include "fx_weight.h"
#include "random.h"

/* All fractions with each other. */
static void products_of_fractions_are_exact(void **state)
{
    (void)state;

    for (uint32_t f = 0; f < 256; f++) {
        assert_int_equal(fx_weight_bits(fx_weight_of_fraction(fx_fraction_of(f))), f * 256);
        for (uint32_t g = 0; g < 256; g++)
            assert_int_equal(fx_weight_bits(fx_fraction_mul(fx_fraction_of(f), fx_fraction_of(g))),
                             f * g);
    }
}

/* All weights with all fractions: to nearest, ties upwards. */
static void products_of_weights_round_to_nearest(void **state)
{
    (void)state;

    for (uint32_t w = 0; w <= FX_WEIGHT_ONE; w++)
        for (uint32_t f = 0; f < 256; f++) {
            const uint32_t product =
                fx_weight_bits(fx_weight_mul(fx_weight_of(w), fx_fraction_of(f)));
            if (product != (2 * w * f + 256) / 512)
                fail_msg("%u * %u: %u", w, f, product);
        }
}

static void sums_and_differences(void **state)
{
    const fx_weight a = fx_weight_of(40000), b = fx_weight_of(25536);
    (void)state;

    assert_int_equal(fx_weight_bits(fx_weight_add(a, b)), FX_WEIGHT_ONE);
    assert_int_equal(fx_weight_bits(fx_weight_sub(a, b)), 14464);
    assert_int_equal(fx_share_bits(fx_share_add(fx_share_of(7), fx_share_of(8))), 15);
    assert_int_equal(fx_sum_bits(fx_sum_add(fx_sum_of(0xFFFFFFFE), fx_sum_of(1))), 0xFFFFFFFF);
}

/* Units of 1 of both storages, as the header lists them. */
static void greatest_values_fit(void **state)
{
    const fx_weight one = fx_weight_of(FX_WEIGHT_ONE);
    const fx_channel full8 = fx_channel_of(255), full16 = fx_channel_of(65535);
    const fx_share share8 = fx_share_mul(one, full8), share16 = fx_share_mul(one, full16);
    (void)state;

    assert_int_equal(fx_share_bits(share8), 65536u * 255);
    assert_int_equal(fx_share_bits(share16), 65536u * 65535);
    assert_int_equal(fx_sum_bits(fx_sum_of_weight(one, full16)), 65536u * 65535);
    assert_int_equal(fx_sum_bits(fx_sum_of_share8(share8, full8)), 65536u * 255 * 255);
    assert_int_equal(fx_sum_bits(fx_sum_of_share16(share16, full16)), 65535u * 65535);
}

static void wide_shares_round_down(void **state)
{
    uint32_t seed = 71;
    (void)state;

    for (unsigned i = 0; i < 1000000; i++) {
        const uint32_t w = random_below(&seed, FX_WEIGHT_ONE + 1), a = random_next(&seed) >> 16;
        const uint32_t c = random_next(&seed) >> 16;
        const fx_share share = fx_share_mul(fx_weight_of(w), fx_channel_of(a));
        const fx_sum sum = fx_sum_of_share16(share, fx_channel_of(c));
        assert_int_equal(fx_share_bits(share), w * a);
        assert_int_equal(fx_sum_bits(sum), ((uint64_t)w * a * c) >> 16);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products_of_fractions_are_exact),
        cmocka_unit_test(products_of_weights_round_to_nearest),
        cmocka_unit_test(sums_and_differences),
        cmocka_unit_test(greatest_values_fit),
        cmocka_unit_test(wide_shares_round_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
