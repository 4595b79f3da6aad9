/*
 * Light of a sample for the length that it stands for: corrected opacity and gathered
 * extinction against real numbers, media whose steps do not matter, and both orders.
 */
#include "check.h"
#include "correct.h"
#include "random.h"

#include <math.h>
#include <string.h>

#define UNIT (65535u * 65535) /* 1 of weighted light, 16 bits */
#define ONE  ((uint64_t)1 << 32)

static const double ln2 = 0.69314718055994530942;

/* Opacity or extinction, 2^32 - 1 is 1, with a colour in 1/65535; of 16 bits. */
static qv_sample sample_of(uint32_t amount, uint32_t colour)
{
    const uint32_t light = (uint32_t)(fx_wide_product(amount, UNIT) / UINT32_MAX);
    const uint32_t part = (uint32_t)(fx_wide_product(light, colour) / 65535);
    const uint32_t share = (uint32_t)(fx_wide_product(amount, 65536u * 65535) / UINT32_MAX);
    const qv_sample sample = {.opacity = fx_share_of(share),
                              .light = {fx_sum_of(light), fx_sum_of(part), fx_sum_of(0)}};
    return sample;
}

/* ---- Opacity-based ---- */

/* Of a ratio, Q32.32, with all levels of so many that it leaves room for. */
static qv_medium corrected_medium(uint64_t ratio, unsigned levels)
{
    qv_medium medium = {.depth = ratio, .light_shift = 1};
    while (ratio << levels >> medium.light_shift >> 32 != 0)
        medium.light_shift++;
    medium.light = (uint32_t)(ratio >> medium.light_shift);
    return medium;
}

static void the_unit_distance_needs_no_correction(void **state)
{
    const qv_medium medium = corrected_medium(ONE, 0);
    uint32_t seed = 1;
    (void)state;

    for (unsigned i = 0; i < 100000; i++) {
        const qv_sample sample = sample_of(random_next(&seed), random_next(&seed) & 0xFFFF);
        uint32_t colour[3];
        assert_int_equal(qv_correct(colour, &sample, &medium, QV_STORAGE_RGBA16),
                         qv_opacity_q32(sample.opacity, QV_STORAGE_RGBA16));
        for (unsigned c = 0; c < 3; c++)
            assert_int_equal(colour[c], fx_sum_bits(sample.light[c]));
    }
}

/* An opacity and a ratio, spread over their magnitudes; opacities near 1 too. */
static uint32_t random_opacity(uint32_t *seed)
{
    const uint32_t opacity = random_next(seed) >> random_below(seed, 24);
    return random_below(seed, 3) != 0 ? opacity : ~opacity;
}

static uint64_t random_ratio(uint32_t *seed)
{
    return (uint64_t)(random_next(seed) | 1u << 31) << 12 >> random_below(seed, 24);
}

/* 1 - (1 - a)^r, and that by a. */
static void expect_corrected(uint32_t opacity, const qv_medium *medium)
{
    const qv_sample sample = sample_of(opacity, 65535);
    const double stored = qv_opacity_q32(sample.opacity, QV_STORAGE_RGBA16) / 4294967295.0;
    const double ratio = ldexp((double)medium->depth, -32);
    const double exact = stored == 0 ? 0 : -expm1(fmax(log1p(-stored), -64 * ln2) * ratio);
    const double factor = stored == 0 ? ratio : exact / stored;
    const uint32_t light = fx_sum_bits(sample.light[0]);
    uint32_t colour[3];
    const double found = ldexp(qv_correct(colour, &sample, medium, QV_STORAGE_RGBA16), -32);
    /* the depth of an opacity is off by 1.4 * 2^-28, which the ratio multiplies */
    const double slope = ratio * (1 - exact) * ln2;
    assert_true(fabs(found - exact) < 0x1p-29 + slope * 1.5 * 0x1p-28);
    /* the medium's light is cut, and the factor; its share of the ratio has 27 bits */
    const double unit = ldexp(1, (int)medium->light_shift - 32);
    const double off = factor * (0x1p-16 + unit / ratio) + unit + ratio * 0x1p-28;
    assert_true(fabs(colour[0] - light * factor) < light * off + 1);
    assert_int_equal(colour[0], colour[1]);
    assert_int_equal(colour[2], 0);
}

static void correction_is_that_of_real_numbers(void **state)
{
    uint32_t seed = 2;
    (void)state;

    for (unsigned i = 0; i < 300000; i++) {
        const qv_medium medium = corrected_medium(random_ratio(&seed), random_below(&seed, 4));
        expect_corrected(random_opacity(&seed), &medium);
    }
}

/* From a depth of 23 on the factor is taken another way; no step is seen there. */
static void the_factor_is_whole_near_full_opacity(void **state)
{
    (void)state;

    for (unsigned shift = 0; shift < 24; shift++) {
        const qv_medium medium = corrected_medium(ONE * 3 << 10 >> shift, 0);
        for (uint32_t below = 1; below < 4096; below += 37)
            expect_corrected(0u - below, &medium);
        expect_corrected(UINT32_MAX, &medium);
    }
}

/* Full opacity is a depth of 64, so that it stays full down to half a unit distance. */
static void full_opacity_stays_full(void **state)
{
    const qv_sample sample = sample_of(UINT32_MAX, 65535);
    (void)state;

    for (uint64_t ratio = ONE / 2; ratio <= ONE << 12; ratio += ratio / 3) {
        const qv_medium medium = corrected_medium(ratio, 0);
        qv_light light = {.transmittance = QV_CLEAR};
        qv_corrected_under(&light, NULL, &sample, &medium, QV_STORAGE_RGBA16);
        assert_int_equal(light.transmittance, 0);
        assert_in_range(fx_high_product(light.colour[0], QV_READ_OUT_16), QV_LEVEL_ONE - 256,
                        QV_LEVEL_ONE + 256);
    }
}

/* ---- Extinction-based ---- */

/* Of the full value's depth for a piece, Q32.32, below 2^54. */
static qv_medium extinction_medium(uint64_t depth)
{
    const uint64_t light = (uint64_t)((double)depth * ln2);
    qv_medium medium = {.depth = depth + (depth >> 16), .light_shift = 1};
    while (light >> medium.light_shift >> 32 != 0)
        medium.light_shift++;
    medium.light = (uint32_t)(light >> medium.light_shift);
    return medium;
}

/* What n pieces gather of one sample, front to back or back to front. */
static qv_light gather(const qv_sample *sample, const qv_medium *medium, unsigned n, int back)
{
    qv_light light = {.transmittance = QV_CLEAR};
    qv_gathered gathered = {.depth = 0};
    for (unsigned i = 0; i < n; i++) {
        if (back)
            qv_extinction_over(&light, &gathered, sample, medium, QV_STORAGE_RGBT16);
        else if (light.transmittance != 0)
            qv_extinction_under(&light, &gathered, sample, medium, QV_STORAGE_RGBT16);
    }
    if (!back)
        qv_gathered_light(&light, &gathered, medium);
    return light;
}

static double level_of(uint32_t colour)
{
    return (double)fx_high_product(colour, QV_READ_OUT_16) / QV_LEVEL_ONE;
}

/* One colour: light and transmittance sum to 1, whatever the pieces. */
static void light_is_what_is_not_transmitted(void **state)
{
    uint32_t seed = 3;
    (void)state;

    for (unsigned i = 0; i < 20000; i++) {
        const uint32_t amount = random_next(&seed) >> random_below(&seed, 8) | 0x800000;
        const qv_sample sample = sample_of(amount, 0x8000);
        const qv_medium medium = extinction_medium(ONE << 12 >> random_below(&seed, 20));
        for (int back = 0; back < 2; back++) {
            const qv_light light = gather(&sample, &medium, 1 + i % 20, back);
            const double opacity = 1 - ldexp(light.transmittance, -31);
            assert_true(fabs(level_of(light.colour[0]) - opacity) < 0x1p-15);
            assert_true(fabs(level_of(light.colour[1]) - opacity * 0x8000 / 65535) < 0x1p-15);
            assert_int_equal(light.colour[2], 0);
        }
    }
}

/* The same transmittance in 1, 2, 4 ... pieces, but for what each depth is cut. */
static void steps_do_not_change_a_medium(void **state)
{
    uint32_t seed = 4;
    (void)state;

    for (unsigned i = 0; i < 2000; i++) {
        const qv_sample sample = sample_of(random_next(&seed) | 0x1000000, 65535);
        const uint64_t depth = ONE << 4 >> random_below(&seed, 10);
        const qv_medium whole = extinction_medium(depth);
        const qv_light once = gather(&sample, &whole, 1, 0);
        for (unsigned halvings = 1; halvings < 9; halvings++) {
            const qv_medium part = extinction_medium(depth >> halvings);
            const qv_light often = gather(&sample, &part, 1u << halvings, 0);
            const int64_t more = (int64_t)often.transmittance - once.transmittance;
            assert_true(more >= -2 && more <= 2 + (1 << halvings));
            assert_true(fabs(level_of(often.colour[0]) - level_of(once.colour[0])) < 0x1p-15);
        }
    }
}

/* Different samples, in either order. */
static void both_orders_agree(void **state)
{
    enum { PIECES = 40 };
    uint32_t seed = 5;
    (void)state;

    for (unsigned round = 0; round < 2000; round++) {
        const qv_medium medium = extinction_medium(ONE << 8 >> random_below(&seed, 14));
        qv_sample samples[PIECES];
        qv_light front = {.transmittance = QV_CLEAR}, back = front;
        qv_gathered forwards = {.depth = 0}, backwards = forwards;
        for (unsigned i = 0; i < PIECES; i++)
            samples[i] = sample_of(random_next(&seed) >> 12, random_next(&seed) & 0xFFFF);
        for (unsigned i = 0; i < PIECES; i++) {
            qv_extinction_under(&front, &forwards, &samples[i], &medium, QV_STORAGE_RGBT16);
            qv_extinction_over(&back, &backwards, &samples[PIECES - 1 - i], &medium,
                               QV_STORAGE_RGBT16);
        }
        qv_gathered_light(&front, &forwards, &medium);
        assert_int_equal(front.transmittance, back.transmittance);
        for (unsigned c = 0; c < 3; c++)
            assert_true(fabs(level_of(front.colour[c]) - level_of(back.colour[c])) < 0x1p-15);
    }
}

/* The densest of pieces: depth stops growing. Of phi few bits are left, and light is
   within 2^-8. */
static void depth_does_not_overflow(void **state)
{
    const qv_sample sample = sample_of(UINT32_MAX, 65535);
    const qv_medium medium = extinction_medium((ONE << 22) - 1);
    const qv_light back = gather(&sample, &medium, 1u << 13, 1);
    const qv_light front = gather(&sample, &medium, 1, 0);
    (void)state;

    assert_int_equal(back.transmittance, 0);
    assert_int_equal(front.transmittance, 0);
    assert_true(fabs(level_of(back.colour[0]) - 1) < 0x1p-8);
    assert_true(fabs(level_of(front.colour[0]) - 1) < 0x1p-8);
}

/* A sample of a thin medium, scaled up, is that sample. */
static void scales_change_nothing(void **state)
{
    const qv_medium medium = extinction_medium(ONE << 10);
    qv_sample plain = sample_of(0x10000, 65535), scaled = sample_of(0x10000, 65535);
    (void)state;

    scaled.scale = 12;
    scaled.opacity = fx_share_of(fx_share_bits(plain.opacity) << 12);
    for (unsigned c = 0; c < 3; c++)
        scaled.light[c] = fx_sum_of(fx_sum_bits(plain.light[c]) << 12);
    for (int back = 0; back < 2; back++) {
        const qv_light a = gather(&plain, &medium, 9, back), b = gather(&scaled, &medium, 9, back);
        assert_memory_equal(&a, &b, sizeof a);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_unit_distance_needs_no_correction),
        cmocka_unit_test(correction_is_that_of_real_numbers),
        cmocka_unit_test(the_factor_is_whole_near_full_opacity),
        cmocka_unit_test(full_opacity_stays_full),
        cmocka_unit_test(light_is_what_is_not_transmitted),
        cmocka_unit_test(steps_do_not_change_a_medium),
        cmocka_unit_test(both_orders_agree),
        cmocka_unit_test(depth_does_not_overflow),
        cmocka_unit_test(scales_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
