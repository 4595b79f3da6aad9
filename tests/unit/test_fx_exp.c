/*
 * Transmittance and opacity against the mathematics library.
 */
#include "check.h"
#include "deviation.h"
#include "fx_exp.h"

#define WHOLE ((fx_depth)1 << 32)

/* 2^-depth in units of 2^-31. */
static long double exact(fx_depth depth)
{
    return exp2l(31 - ldexpl((long double)depth, -32));
}

static void wide_error(void **state)
{
    deviation d = {0, 0, 0, 0};
    uint32_t last = FX_CLEAR_Q31;
    (void)state;

    for (fx_depth depth = 0; depth < 34 * WHOLE; depth += depth < 2 * WHOLE ? 4099 : 104729) {
        const uint32_t t = fx_transmittance(depth);
        if (t > last)
            fail_msg("rises at %ju", (uintmax_t)depth);
        last = t;
        deviation_add(&d, t, exact(depth));
    }
    deviation_print(&d, "transmittance, units of 2^-31", 1);
    assert_true(d.worst <= .78);
}

static void wide_ends(void **state)
{
    (void)state;
    for (unsigned whole = 0; whole < 32; whole++) {
        const uint32_t t = FX_CLEAR_Q31 >> whole;
        assert_int_equal(fx_transmittance(whole * WHOLE), t);
        assert_in_range(fx_transmittance(whole * WHOLE + 1), t - 1, t);
        assert_true(whole == 0 || fx_transmittance(whole * WHOLE - 1) >= t);
    }
    assert_int_equal(fx_transmittance(32 * WHOLE - 1), 1);
    assert_int_equal(fx_transmittance(32 * WHOLE), 0);
    assert_int_equal(fx_transmittance(33 * WHOLE - 1), 0);
    assert_int_equal(fx_transmittance(UINT64_MAX), 0);
    assert_int_equal(fx_opacity(0), 0);
    assert_int_equal(fx_opacity(UINT64_MAX), FX_CLEAR_Q31);
}

/* Segments of 2^26: the power of one's end meets that of the next one's start. */
static void wide_segments(void **state)
{
    (void)state;
    for (fx_depth depth = (fx_depth)1 << 26; depth <= 2 * WHOLE; depth += (fx_depth)1 << 26)
        for (unsigned i = 0; i < 1000; i++)
            assert_true(fx_transmittance(depth + i) <= fx_transmittance(depth + i - 1) &&
                        fx_transmittance(depth - i) <= fx_transmittance(depth - i - 1));
}

static void narrow_error(void **state)
{
    deviation d = {0, 0, 0, 0};
    uint32_t last = 65535;
    (void)state;

    for (uint32_t depth = 0; depth < 18u << 24; depth += 31) {
        const uint32_t t = fx_transmittance16(depth);
        if (t > last || fx_opacity16(depth) != 65535 - t)
            fail_msg("at %u", depth);
        last = t;
        deviation_add(&d, t, 65535 * exp2l(-ldexpl(depth, -24)));
    }
    deviation_print(&d, "transmittance of 16 bits, units of 1/65535", 1);
    assert_true(d.worst <= .51);
}

static void narrow_ends(void **state)
{
    (void)state;
    assert_int_equal(fx_transmittance16(0), 65535);
    assert_int_equal(fx_transmittance16(16u << 24), 1);
    for (unsigned depth = 17; depth < 256; depth++)
        assert_int_equal(fx_transmittance16(depth << 24), 0);
    assert_int_equal(fx_transmittance16(UINT32_MAX), 0);
    assert_int_equal(fx_opacity16(UINT32_MAX), 65535);
}

/* Sums of steps make the transmittance of the whole, whatever the step. */
static void steps(void **state)
{
    const fx_depth depth = WHOLE / 2048 * 2048; /* a multiple of every count */
    (void)state;
    for (unsigned count = 1; count <= 1024; count *= 2) {
        fx_depth sum = 0;
        uint32_t gathered = 0;
        for (unsigned i = 0; i < count; i++) {
            gathered += fx_transmittance(sum) - fx_transmittance(sum + depth / count);
            sum += depth / count;
        }
        assert_int_equal(gathered, fx_opacity(depth));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wide_error),    cmocka_unit_test(wide_ends),
        cmocka_unit_test(wide_segments), cmocka_unit_test(narrow_error),
        cmocka_unit_test(narrow_ends),   cmocka_unit_test(steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
