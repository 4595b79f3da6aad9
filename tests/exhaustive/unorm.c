/*
 * Division by 65535 and products of 16 bits for every input.
 */
#include "check.h"
#include "fx_unorm.h"

/* x from 0 to 65535^2 with quotient and rest counted along, not divided. */
static void division_by_65535(void **state)
{
    uint32_t quotient = 0, rest = 0, x = 0;
    (void)state;

    for (; quotient < 65535 || rest == 0; x++) {
        if (fx_div65535_floor(x) != quotient)
            fail_msg("floor(%u / 65535): %u", x, fx_div65535_floor(x));
        if (fx_div65535_round(x) != quotient + (rest > 32767))
            fail_msg("round(%u / 65535): %u", x, fx_div65535_round(x));
        rest++;
        if (rest == 65535) {
            rest = 0;
            quotient++;
        }
    }
    assert_int_equal(x, 65535u * 65535u + 1);
}

static void products_of_16_bits(void **state)
{
    (void)state;

    for (uint32_t a = 0; a < 65536; a++)
        for (uint32_t b = 0; b < 65536; b++) {
            const uint32_t product = fx_unorm16_mul((fx_unorm16)a, (fx_unorm16)b);
            if (product != ((uint64_t)a * b + 32767) / 65535)
                fail_msg("%u * %u: %u", a, b, product);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(division_by_65535),
        cmocka_unit_test(products_of_16_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
