/*
 * Sine and cosine against the mathematics library.
 */
#include "check.h"
#include "fx_angle.h"

#include <math.h>
#include <stdio.h>

#define TWO_PI 6.283185307179586476925286766559005768L

static int32_t sine_of(fx_angle angle)
{
    int32_t sine, cosine;
    fx_sine_cosine(&sine, &cosine, angle);
    return sine;
}

static int32_t cosine_of(fx_angle angle)
{
    int32_t sine, cosine;
    fx_sine_cosine(&sine, &cosine, angle);
    return cosine;
}

/* The greater error of the two. */
static double error_at(fx_angle angle)
{
    const long double radians = (long double)angle / 4294967296.0L * TWO_PI;
    const long double sine = ldexpl(sine_of(angle), -30), cosine = ldexpl(cosine_of(angle), -30);
    return (double)fmaxl(fabsl(sine - sinl(radians)), fabsl(cosine - cosl(radians)));
}

/* 2^32 / 4093 angles, and all of those next to the eighths of a turn. */
static void error_is_below_2_to_the_minus_28(void **state)
{
    double worst = 0;
    (void)state;

    for (uint32_t i = 0; i < 0xFFFFFFFFu / 4093; i++)
        worst = fmax(worst, error_at(i * 4093));
    for (uint32_t eighth = 0; eighth < 8; eighth++)
        for (uint32_t i = 0; i < 2000; i++)
            worst = fmax(worst, error_at((eighth << 29) + i - 1000));
    printf("# sine and cosine: worst error %.3f * 2^-28\n", ldexp(worst, 28));
    assert_true(worst <= ldexp(1, -28));
}

static void quarter_turns_are_exact(void **state)
{
    static const int32_t sines[5] = {0, FX_ONE_Q30, 0, -FX_ONE_Q30, 0};
    (void)state;

    for (unsigned quadrant = 0; quadrant < 4; quadrant++) {
        assert_int_equal(sine_of(quadrant * FX_QUARTER_TURN), sines[quadrant]);
        assert_int_equal(cosine_of(quadrant * FX_QUARTER_TURN), sines[quadrant + 1]);
    }
}

static void symmetries_hold_bit_for_bit(void **state)
{
    (void)state;

    for (uint32_t i = 0; i < 1000000; i++) {
        const fx_angle a = i * 4099;
        assert_int_equal(sine_of(0u - a), -sine_of(a));
        assert_int_equal(cosine_of(0u - a), cosine_of(a));
        assert_int_equal(sine_of(FX_QUARTER_TURN - a), cosine_of(a));
        assert_int_equal(sine_of(a + 2 * FX_QUARTER_TURN), -sine_of(a));
    }
    assert_int_equal(sine_of(FX_QUARTER_TURN / 2), cosine_of(FX_QUARTER_TURN / 2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(error_is_below_2_to_the_minus_28),
        cmocka_unit_test(quarter_turns_are_exact),
        cmocka_unit_test(symmetries_hold_bit_for_bit),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
