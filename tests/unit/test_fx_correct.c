/*
 * Opacity correction and its colour factor against the mathematics library.
 */
#include "check.h"
#include "correct_exact.h"
#include "phi_exact.h"
#include "random.h"

#define WHOLE ((fx_depth)1 << 32)

static const uint32_t ratios[] = {FX_RATIO_LEAST, 5000,   8192,   16384,  32768,
                                  45875,          65535,  65536,  65537,  131072,
                                  196608,         300000, 524288, 777777, FX_RATIO_GREATEST};

static void error(void **state)
{
    correct_errors errors = {{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}};
    (void)state;

    for (unsigned i = 0; i < sizeof ratios / sizeof *ratios; i++)
        for (uint32_t a = 0; a < 65536; a += 5)
            correct_measure(&errors, a, correct_logarithm(a), ratios[i]);
    correct_judge(&errors);
}

static void fixed_points(void **state)
{
    (void)state;
    for (uint32_t a = 0; a < 65536; a++)
        assert_int_equal(fx_correct_opacity((fx_unorm16)a, 65536), a);
    for (unsigned i = 0; i < sizeof ratios / sizeof *ratios; i++) {
        assert_int_equal(fx_correct_opacity(0, ratios[i]), 0);
        assert_int_equal(fx_correct_opacity(65535, ratios[i]), 65535);
        assert_int_equal(fx_correct_colour(65535, ratios[i]), 1u << 27);
        assert_in_range(fx_correct_colour(0, ratios[i]), (ratios[i] << 11) - 4, ratios[i] << 11);
    }
    assert_int_equal(fx_correct_opacity(65535, 0), 65535);
    assert_int_equal(fx_correct_opacity(40000, 0), 0);
    assert_in_range(fx_correct_opacity(1, UINT32_MAX), 41424, 41428); /* 65535 (1 - 1/e) */
    assert_int_equal(fx_correct_opacity(65534, UINT32_MAX), 65535);
}

static void never_falls(void **state)
{
    (void)state;
    for (unsigned i = 0; i < sizeof ratios / sizeof *ratios; i++)
        for (uint32_t a = 1; a < 65536; a++) {
            const uint32_t corrected = fx_correct_opacity((fx_unorm16)a, ratios[i]);
            assert_true(corrected >= fx_correct_opacity((fx_unorm16)(a - 1), ratios[i]));
        }
    for (uint32_t a = 1; a < 65536; a += 4096)
        for (uint32_t ratio = FX_RATIO_LEAST; ratio < FX_RATIO_GREATEST; ratio += 7)
            assert_true(fx_correct_opacity((fx_unorm16)a, ratio) <=
                        fx_correct_opacity((fx_unorm16)a, ratio + 7));
}

static void depths_scale(void **state)
{
    (void)state;
    assert_true(fx_depth_scale(0, UINT32_MAX) == 0);
    assert_true(fx_depth_scale(5 * WHOLE + 12345, 65536) == 5 * WHOLE + 12345);
    assert_true(fx_depth_scale(64 * WHOLE, FX_RATIO_GREATEST) == 1024 * WHOLE);
    assert_true(fx_depth_scale(64 * WHOLE, UINT32_MAX) == 64 * (fx_depth)UINT32_MAX << 16);
    assert_true(fx_depth_scale(15, FX_RATIO_LEAST) == 0);
    assert_true(fx_depth_scale(16, FX_RATIO_LEAST) == 1);
}

/* A number of 32 bits, of any magnitude, so that products are exact in long double. */
static uint64_t random_number(uint32_t *seed, unsigned bits)
{
    return (uint64_t)(random_next(seed) | 1u) << 32 >> random_below(seed, bits);
}

/* Cut, by less than a unit of the result. */
static void depths_times_a_ratio(void **state)
{
    uint32_t seed = 5;
    (void)state;
    for (unsigned i = 0; i < 300000; i++) {
        const fx_depth depth = random_number(&seed, 64) & 0x3FFFFFFFFFF; /* < 2^10 */
        const uint64_t ratio = random_number(&seed, 64) & 0xFFFFFFFFFFF; /* < 2^12 */
        const long double exact = ldexpl((long double)depth * (long double)ratio, -32);
        const long double short_by = exact - (long double)fx_depth_times(depth, ratio);
        assert_true(short_by >= 0 && short_by < 1);
    }
    assert_true(fx_depth_times(64 * WHOLE, WHOLE) == 64 * WHOLE);
    assert_true(fx_depth_times(UINT64_MAX, WHOLE) == UINT64_MAX);
    assert_true(fx_depth_times(0, UINT64_MAX) == 0);
}

/* Depths up to 23, where fx_correct_colour reaches 16. */
static void shares_of_phi(void **state)
{
    double worst = 0;
    (void)state;
    for (fx_depth depth = 0; depth < 23 * WHOLE; depth += WHOLE / 61)
        for (fx_depth scaled = 1; scaled < WHOLE << 16; scaled += 1 + scaled / 7) {
            const long double exact = ldexpl(phi_exact(scaled) / phi_exact(depth), 27);
            const double off = (double)(fx_phi_share(depth, scaled) / exact - 1);
            worst = fmax(worst, fabs(off) - (double)(1 / exact));
        }
    printf("# share of phi, beyond the last place: max %.4f * 2^-16 of it\n", ldexp(worst, 16));
    assert_true(ldexp(worst, 16) <= .4);
    assert_int_equal(fx_phi_share(0, 0), 1u << 27);
}

/* slices and wanted: as in the paper's figure 3, the ends, and longer slices. */
static const uint32_t numbers[][2] = {{128, 275},  {128, 600},      {100, 1000},
                                      {1, 2},      {200, 100},      {600, 128},
                                      {999, 1000}, {1, 0x7FFFFFFF}, {65535, 1}};

/* Equation 3 in units of 2^-32, where the bound is 16 (ratio + 1/2) units. */
static void numbers_of_slices(void **state)
{
    (void)state;
    for (unsigned i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        const double ratio = (double)numbers[i][0] / numbers[i][1];
        deviation d = {0, 0, 0, 0};
        for (uint32_t a = 1; a < UINT32_MAX - a / 999; a += 1 + a / 999) {
            const long double depth = (long double)ratio * log1pl((long double)a / -4294967295.0L);
            const long double exact = -4294967295.0L * expm1l(depth);
            deviation_add(&d, fx_correct_slices(a, numbers[i][0], numbers[i][1]), exact);
        }
        assert_true(d.worst <= 16 * (ratio + .5));
        assert_int_equal(fx_correct_slices(0, numbers[i][0], numbers[i][1]), 0);
        assert_int_equal(fx_correct_slices(UINT32_MAX, numbers[i][0], numbers[i][1]), UINT32_MAX);
    }
    assert_int_equal(fx_correct_slices(123456789, 65535, 65535), 123456789);
    assert_int_equal(fx_correct_slices(0xFFFF0000u, 65535, 1), UINT32_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(error),
        cmocka_unit_test(fixed_points),
        cmocka_unit_test(never_falls),
        cmocka_unit_test(depths_scale),
        cmocka_unit_test(depths_times_a_ratio),
        cmocka_unit_test(shares_of_phi),
        cmocka_unit_test(numbers_of_slices),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
