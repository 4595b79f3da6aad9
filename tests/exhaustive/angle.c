/*
 * Sine and cosine of every angle: the error on an eighth of a turn, and the
 * symmetries that carry it to the other seven.
 */
#include "check.h"
#include "fx_angle.h"

#include <math.h>
#include <stdio.h>

#define TWO_PI      6.283185307179586476925286766559005768L
#define EIGHTH_TURN 0x20000000u

static void error_on_an_eighth_of_a_turn(void **state)
{
    long double worst = 0;
    (void)state;

    for (uint32_t angle = 0; angle <= EIGHTH_TURN; angle++) {
        const long double radians = ldexpl((long double)angle, -32) * TWO_PI;
        int32_t sine, cosine;
        fx_sine_cosine(&sine, &cosine, angle);
        worst = fmaxl(worst, fabsl(sinl(radians) - ldexpl(sine, -30)));
        worst = fmaxl(worst, fabsl(cosl(radians) - ldexpl(cosine, -30)));
    }
    printf("# sine and cosine: worst error %.4f * 2^-28\n", (double)ldexpl(worst, 28));
    assert_true(worst <= ldexpl(1.08L, -30)); /* as the precision report has it */
}

/* sin(90 - a) = cos(a), sin(90 + a) = cos(a), sin(-a) = -sin(a) and their like. */
static void symmetries(void **state)
{
    uint32_t angle = 0;
    (void)state;

    do {
        int32_t s, c, mirrored_s, mirrored_c, turned_s, turned_c, negative_s, negative_c;
        fx_sine_cosine(&s, &c, angle);
        fx_sine_cosine(&mirrored_s, &mirrored_c, FX_QUARTER_TURN - angle);
        fx_sine_cosine(&turned_s, &turned_c, FX_QUARTER_TURN + angle);
        fx_sine_cosine(&negative_s, &negative_c, 0u - angle);
        if (mirrored_s != c || mirrored_c != s || turned_s != c || turned_c != -s ||
            negative_s != -s || negative_c != c)
            fail_msg("angle %u", angle);
    } while (++angle != 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(error_on_an_eighth_of_a_turn),
        cmocka_unit_test(symmetries),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
