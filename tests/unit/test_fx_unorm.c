/*
 * Normalised numbers against division by the compiler. Domains of up to 2^24
 * inputs are complete here; tests/exhaustive/unorm.c has those of 2^32.
 */
#include "check.h"
#include "fx_unorm.h"
#include "random.h"

#define GREATEST_PRODUCT (65535u * 65535u)

/* x / n to nearest for an odd n, so without ties. */
static uint32_t rounded(uint32_t x, uint32_t n)
{
    return (uint32_t)(((uint64_t)x + n / 2) / n);
}

static void division_by_255_rounds_correctly(void **state)
{
    (void)state;

    for (uint32_t x = 0; x <= 65662; x++)
        assert_int_equal(fx_div255_round(x), rounded(x, 255));
    assert_int_not_equal(fx_div255_round(65663), rounded(65663, 255));
}

static void division_by_255_floors(void **state)
{
    (void)state;

    for (uint32_t x = 0; x < 65535; x++)
        assert_int_equal(fx_div255_floor(x), x / 255);
    assert_int_not_equal(fx_div255_floor(65535), 65535 / 255);
}

static void check_division_by_65535(uint32_t x)
{
    if (fx_div65535_round(x) != rounded(x, 65535) || fx_div65535_floor(x) != x / 65535)
        fail_msg("%u / 65535: %u and %u", x, fx_div65535_round(x), fx_div65535_floor(x));
}

/* Every quotient at all places where it might change, and a dense sample. */
static void division_by_65535(void **state)
{
    static const uint32_t rests[] = {0, 1, 2, 32766, 32767, 32768, 32769, 65533, 65534};
    (void)state;

    for (uint32_t q = 0; q < 65535; q++)
        for (unsigned i = 0; i < sizeof rests / sizeof rests[0]; i++)
            check_division_by_65535(q * 65535 + rests[i]);
    for (uint32_t x = 0; x < GREATEST_PRODUCT - 997; x += 997)
        check_division_by_65535(x);
    check_division_by_65535(GREATEST_PRODUCT);
}

static void products_of_8_bits(void **state)
{
    (void)state;

    for (uint32_t a = 0; a < 256; a++)
        for (uint32_t b = 0; b < 256; b++)
            assert_int_equal(fx_unorm8_mul((fx_unorm8)a, (fx_unorm8)b), rounded(a * b, 255));
}

static void check_product_of_16_bits(uint32_t a, uint32_t b)
{
    if (fx_unorm16_mul((fx_unorm16)a, (fx_unorm16)b) != rounded(a * b, 65535))
        fail_msg("%u * %u", a, b);
}

/* Each number with the ends of the range and with some others. */
static void products_of_16_bits(void **state)
{
    uint32_t seed = 41;
    (void)state;

    for (uint32_t a = 0; a < 65536; a++) {
        for (uint32_t b = 0; b < 8; b++) {
            check_product_of_16_bits(a, b);
            check_product_of_16_bits(a, 65535 - b);
        }
        for (unsigned i = 0; i < 64; i++)
            check_product_of_16_bits(a, random_next(&seed) >> 16);
        assert_int_equal(fx_unorm16_mul((fx_unorm16)a, 65535), a);
        assert_int_equal(fx_unorm16_mul((fx_unorm16)a, 0), 0);
    }
}

static void conversions(void **state)
{
    (void)state;

    for (uint32_t a = 0; a < 65536; a++)
        assert_int_equal(fx_unorm16_to_unorm8((fx_unorm16)a), rounded(a, 257));
    for (uint32_t a = 0; a < 256; a++) {
        assert_int_equal(fx_unorm8_to_unorm16((fx_unorm8)a), a * 257);
        assert_int_equal(fx_unorm16_to_unorm8(fx_unorm8_to_unorm16((fx_unorm8)a)), a);
    }
}

/* Within 1/2 + 2^-15 of the last place, in units of 2^-31 of it: 2^30 + 2^16. */
static void from_31_fraction_bits(void **state)
{
    const uint64_t one = (uint64_t)1 << 31, most_off = (one >> 1) + 65536;
    (void)state;

    for (uint64_t v = 0; v <= one; v += v % 3 + 997) {
        const uint64_t exact = v * 65535, result = fx_unorm16_of_q31((uint32_t)v) * one;
        assert_in_range(result + most_off - exact, 0, 2 * most_off);
    }
    for (uint64_t i = 0; i < 65536; i++)
        assert_int_equal(fx_unorm16_of_q31((uint32_t)((i * one + 32767) / 65535)), i);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(division_by_255_rounds_correctly),
        cmocka_unit_test(division_by_255_floors),
        cmocka_unit_test(division_by_65535),
        cmocka_unit_test(products_of_8_bits),
        cmocka_unit_test(products_of_16_bits),
        cmocka_unit_test(conversions),
        cmocka_unit_test(from_31_fraction_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
