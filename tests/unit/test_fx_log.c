/*
 * Depth of an opacity and reciprocal against the mathematics library.
 */
#include "check.h"
#include "deviation.h"
#include "fx_log.h"
#define FX_COUNTS_ZEROS 0 /* the portable count; the library's own may differ */
#include "fx_bits.h"

#define WHOLE ((fx_depth)1 << 32)
#define FALL  ((fx_depth)1 << 5) /* 2^-27 */

static void leading_zeros(void **state)
{
    (void)state;
    for (unsigned bit = 0; bit < 32; bit++) {
        assert_int_equal(fx_leading_zeros(1u << bit), 31 - bit);
        assert_int_equal(fx_leading_zeros(0xFFFFFFFFu >> bit), bit);
    }
}

/* -log2(t) for t in units of 1/(2^32 - 1), in units of 2^-32. */
static long double exact(uint32_t t)
{
    return ldexpl(log2l(4294967295.0L / t), 32);
}

static void wide_error(void **state)
{
    deviation d = {0, 0, 0, 0};
    fx_depth last = 0;
    (void)state;

    for (uint32_t t = UINT32_MAX; t > 1; t -= t >> 21 > 1 ? t >> 21 : 1) {
        const fx_depth depth = fx_depth_of_transmittance(t);
        if (depth + FALL < last)
            fail_msg("falls at %u", t);
        last = depth;
        deviation_add(&d, depth, exact(t));
    }
    deviation_print(&d, "depth of a transmittance, units of 2^-28", 16);
    assert_true(d.worst <= 1.4 * 16);
}

static void wide_ends(void **state)
{
    (void)state;
    assert_true(fx_depth_of_transmittance(UINT32_MAX) == 0);
    assert_true(fx_depth_of_transmittance(1) < 32 * WHOLE + 32);
    assert_true(fx_depth_of_transmittance(0) == 64 * WHOLE);
    assert_true(fx_depth_of_opacity(UINT32_MAX) == FX_OPAQUE_DEPTH);
    assert_true(fx_depth_of_opacity(0) == 0);
    assert_true(fx_depth_of_unorm16(0) == 0);
    assert_true(fx_depth_of_opacity(12345) == fx_depth_of_transmittance(UINT32_MAX - 12345));
}

/* An opacity's extinction in units of 2^-24; full opacity has none. */
static long double extinction(uint32_t opacity, uint32_t one)
{
    return ldexpl(log2l((long double)one / (one - opacity)), 24);
}

static void stored_opacities(void **state)
{
    deviation wide = {0, 0, 0, 0}, narrow = {0, 0, 0, 0};
    uint32_t last = 0;
    (void)state;

    for (uint32_t a = 0; a < 65535; a++) {
        const fx_extinction x = fx_extinction_of_unorm16((fx_unorm16)a);
        assert_true(a == 0 ? x == 0 : x > last);
        last = x;
        deviation_add(&wide, x, extinction(a, 65535));
    }
    for (uint32_t a = 0; a < 255; a++)
        deviation_add(&narrow, fx_extinction_of_unorm8((fx_unorm8)a), extinction(a, 255));
    deviation_print(&wide, "extinction of 16 bits, units of 2^-24", 1);
    deviation_print(&narrow, "extinction of 8 bits, units of 2^-24", 1);
    assert_true(wide.worst <= .61);
    assert_true(narrow.worst <= .5);
    assert_int_equal(fx_extinction_of_unorm16(65535), FX_OPAQUE);
    assert_int_equal(fx_extinction_of_unorm8(255), FX_OPAQUE);
}

/* Extinction and back is the opacity again, through either transmittance. */
static void there_and_back(void **state)
{
    (void)state;
    for (uint32_t a = 0; a < 65536; a++) {
        const fx_extinction x = fx_extinction_of_unorm16((fx_unorm16)a);
        const uint32_t q31 = fx_opacity((fx_depth)x << 8);
        assert_int_equal(fx_opacity16(x), a);
        assert_int_equal(((uint64_t)q31 * 65535 + 0x40000000) >> 31, a);
    }
}

/* The samples of steps of 1/16 .. 16 voxels that fall into a voxel of full opacity
   leave nothing, wherever the first one lies. */
static void full_opacity_over_a_voxel(void **state)
{
    (void)state;
    for (uint32_t step = 4096; step <= 1u << 20; step += 61)
        for (unsigned phase = 0; phase < 8; phase++) {
            fx_depth depth = 0;
            uint32_t at = (uint32_t)((uint64_t)(step < 65536 ? step : 65535) * phase / 8);
            for (; at < 65536; at += step)
                depth += ((fx_depth)FX_OPAQUE << 8 >> 16) * step;
            if (fx_transmittance(depth) != 0)
                fail_msg("step %u, phase %u of 8", step, phase);
        }
}

static void reciprocals(void **state)
{
    double worst = 0;
    (void)state;
    for (uint32_t v = 1u << 27; v <= 1u << 31; v += 4099) {
        const double product = ldexp(fx_reciprocal(v), -27) * ldexp(v, -31);
        worst = fmax(worst, fabs(product - 1));
    }
    printf("# reciprocal: max %.4f * 2^-20 of it\n", ldexp(worst, 20));
    assert_true(worst <= ldexp(1, -20));
    assert_int_equal(fx_reciprocal(1u << 31), 1u << 27);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(leading_zeros),  cmocka_unit_test(wide_error),
        cmocka_unit_test(wide_ends),      cmocka_unit_test(stored_opacities),
        cmocka_unit_test(there_and_back), cmocka_unit_test(full_opacity_over_a_voxel),
        cmocka_unit_test(reciprocals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
