/*
 * Depth of every transmittance of 32 bits, and every reciprocal.
 */
#include "check.h"
#include "deviation.h"
#include "fx_log.h"

#define FALL ((fx_depth)1 << 5) /* 2^-27 */

static void every_transmittance(void **state)
{
    deviation d = {0, 0, 0, 0};
    fx_depth last = 0;
    (void)state;

    for (uint32_t t = UINT32_MAX; t > 0; t--) {
        const fx_depth depth = fx_depth_of_transmittance(t);
        const long double exact = ldexpl(log2l(4294967295.0L / t), 32);
        if (depth + FALL < last)
            fail_msg("falls at %u", t);
        last = depth;
        deviation_add(&d, depth, exact);
    }
    deviation_print(&d, "depth of a transmittance, units of 2^-28", 16);
    assert_true(d.worst <= 1.4 * 16);
}

static void every_reciprocal(void **state)
{
    double worst = 0;
    (void)state;

    for (uint32_t v = 1u << 27; v <= 1u << 31; v++)
        worst = fmax(worst, fabs(ldexp(fx_reciprocal(v), -27) * ldexp(v, -31) - 1));
    printf("# reciprocal: max %.4f * 2^-20 of it\n", ldexp(worst, 20));
    assert_true(worst <= ldexp(1, -20));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_transmittance),
        cmocka_unit_test(every_reciprocal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
