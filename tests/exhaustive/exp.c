/*
 * Transmittance of every depth: the wide form for every fraction, then for every
 * whole part; the 16-bit form for all its inputs.
 */
#include "check.h"
#include "deviation.h"
#include "fx_exp.h"

#define WHOLE ((fx_depth)1 << 32)

/* Depths of 0 .. 1 take the least shift of the power, and so its greatest error. */
static void every_fraction(void **state)
{
    deviation d = {0, 0, 0, 0};
    uint32_t last = FX_CLEAR_Q31;
    (void)state;

    for (fx_depth depth = 0; depth <= WHOLE; depth++) {
        const uint32_t t = fx_transmittance(depth);
        if (t > last)
            fail_msg("rises at %ju", (uintmax_t)depth);
        last = t;
        deviation_add(&d, t, exp2l(31 - ldexpl((long double)depth, -32)));
    }
    deviation_print(&d, "transmittance, units of 2^-31", 1);
    assert_true(d.worst <= .78);
}

/* Depth + 1 is half of the same power: never higher, and a half within rounding. */
static void every_whole_part(void **state)
{
    (void)state;
    for (fx_depth fraction = 0; fraction < WHOLE; fraction += 1021) {
        uint32_t last = fx_transmittance(fraction);
        for (fx_depth whole = 1; whole <= 33; whole++) {
            const uint32_t t = fx_transmittance(whole * WHOLE + fraction);
            if (t > (last + 1) / 2 || t < last / 2)
                fail_msg("%ju + %ju", (uintmax_t)whole, (uintmax_t)fraction);
            last = t;
        }
    }
}

static void every_depth_of_24_fraction_bits(void **state)
{
    deviation d = {0, 0, 0, 0};
    uint32_t last = 65535, depth = 0;
    (void)state;

    do {
        const uint32_t t = fx_transmittance16(depth);
        if (t > last)
            fail_msg("rises at %u", depth);
        last = t;
        if (depth < 18u << 24)
            deviation_add(&d, t, 65535 * exp2l(-ldexpl(depth, -24)));
    } while (++depth != 0);
    deviation_print(&d, "transmittance of 16 bits, units of 1/65535", 1);
    assert_int_equal(last, 0);
    assert_true(d.worst <= .51);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_fraction),
        cmocka_unit_test(every_whole_part),
        cmocka_unit_test(every_depth_of_24_fraction_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
