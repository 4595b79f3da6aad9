/*
 * phi against the mathematics library.
 */
#include "check.h"
#include "deviation.h"
#include "fx_phi.h"
#include "phi_exact.h"

#define WHOLE ((fx_depth)1 << 32)

/* The next depth to look at: dense up to 32, then by the size. */
static fx_depth next(fx_depth depth)
{
    return depth + (depth < 32 * WHOLE ? 49999 : depth >> 16);
}

static void error(void **state)
{
    deviation d = {0, 0, 0, 0};
    double relative = 0;
    uint32_t last = FX_CLEAR_Q31;
    (void)state;

    for (fx_depth depth = 0; depth < WHOLE << 20; depth = next(depth)) {
        const uint32_t phi = fx_phi(depth);
        const long double exact = ldexpl(phi_exact(depth), 31);
        if (phi > last)
            fail_msg("rises at %ju", (uintmax_t)depth);
        last = phi;
        deviation_add(&d, phi, exact);
        relative = fmax(relative, (double)((fabsl(phi - exact) - 1) / exact));
    }
    deviation_print(&d, "phi, units of 2^-16", 32768);
    printf("# phi, beyond the last place: max %.4f * 2^-16 of it\n", ldexp(relative, 16));
    assert_true(ldexp(d.worst, -15) <= .02);
    assert_true(ldexp(relative, 16) <= .16);
}

static void ends(void **state)
{
    (void)state;
    assert_int_equal(fx_phi(0), FX_CLEAR_Q31);
    assert_int_equal(fx_phi(1), FX_CLEAR_Q31);
    assert_true(fx_phi(64) < FX_CLEAR_Q31);
    assert_int_equal(fx_phi(UINT64_MAX), 1);
}

/* Segments are 1/4 wide below 2, then an eighth of an octave. */
static void segments(void **state)
{
    (void)state;
    for (fx_depth start = WHOLE / 4; start <= WHOLE << 20;) {
        for (unsigned i = 0; i < 300; i++) {
            assert_true(fx_phi(start + i) <= fx_phi(start + i - 1));
            assert_true(fx_phi(start - i) <= fx_phi(start - i - 1));
        }
        fx_depth width = WHOLE / 4;
        while (start >= 16 * width)
            width *= 2;
        start += width;
    }
}

/* Extinction-weighted colour times phi is the opacity: x ln 2 phi(x) = 1 - 2^-x. */
static void turns_extinction_into_opacity(void **state)
{
    (void)state;
    for (fx_depth depth = WHOLE >> 12; depth < 40 * WHOLE; depth += depth >> 7) {
        const long double weighted = ldexpl((long double)depth, -32) * LN_2 * fx_phi(depth);
        const long double opacity = fx_opacity(depth);
        assert_true(fabsl(weighted - opacity) <= ldexpl(opacity, -18) + 1 + ldexpl(depth, -32));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(error),
        cmocka_unit_test(ends),
        cmocka_unit_test(segments),
        cmocka_unit_test(turns_extinction_into_opacity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
