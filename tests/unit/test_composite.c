/*
 * Over and under: their identities, their rounding, and that both orders agree.
 */
#include "check.h"
#include "composite.h"
#include "random.h"

#include <math.h>
#include <string.h>

#define OPAQUE    0xFFFFFFFFu          /* opacity 1, Q0.32 */
#define COLOUR8   (65536u * 255 * 255) /* 1 in 8-bit storage */
#define COLOUR16  (65535u * 65535)     /* 1 in 16-bit storage */
#define CONVERTED (65535u << 15)       /* 1 of colours weighted by extinction */
#define ALL_LIGHT 0x80000000u          /* 1 of light, about half of either */

typedef void composite(qv_light *light, const uint32_t sample[3], uint32_t opacity);

/* What a march passes to it; called by address below. */
static void under(qv_light *light, const uint32_t sample[3], uint32_t opacity)
{
    qv_under(light, sample, opacity);
}

static void over(qv_light *light, const uint32_t sample[3], uint32_t opacity)
{
    qv_over(light, sample, opacity);
}

static composite *const operations[2] = {under, over};

static qv_light clear(void)
{
    const qv_light light = {{0, 0, 0}, QV_CLEAR, 0, 0};
    return light;
}

/* Light after some samples of any colour. */
static qv_light random_light(uint32_t *seed)
{
    qv_light light = clear();
    light.transmittance = random_next(seed) >> random_below(seed, 32) >> 1;
    for (unsigned c = 0; c < 3; c++)
        light.colour[c] = random_next(seed) % (ALL_LIGHT - light.transmittance);
    return light;
}

static double level(uint32_t colour, uint32_t read_out)
{
    return (double)fx_high_product(colour, read_out) / QV_LEVEL_ONE;
}

/* ---- Identities ---- */

static void transparent_samples_change_nothing(void **state)
{
    static const uint32_t nothing[3] = {0, 0, 0};
    uint32_t seed = 1;
    (void)state;

    for (unsigned i = 0; i < 100000; i++)
        for (unsigned o = 0; o < 2; o++) {
            const qv_light before = random_light(&seed);
            qv_light light = before;
            operations[o](&light, nothing, 0);
            assert_memory_equal(&light, &before, sizeof light);
        }
}

/* Nothing shines through, whatever the transmittance was. */
static void opaque_samples_leave_no_transmittance(void **state)
{
    static const uint32_t white[3] = {COLOUR8, COLOUR8, COLOUR8};
    uint32_t seed = 2;
    (void)state;

    for (unsigned i = 0; i < 100000; i++)
        for (unsigned o = 0; o < 2; o++) {
            qv_light light = i == 0 ? clear() : random_light(&seed);
            operations[o](&light, white, OPAQUE);
            assert_int_equal(light.transmittance, 0);
        }
}

static void an_opaque_sample_in_front_hides_all(void **state)
{
    static const uint32_t sample[3] = {COLOUR8, 2 * 12345, 0};
    static const uint32_t expected[3] = {COLOUR8 / 2, 12345, 0};
    uint32_t seed = 3;
    (void)state;

    for (unsigned i = 0; i < 100000; i++) {
        qv_light light = random_light(&seed);
        over(&light, sample, OPAQUE);
        assert_memory_equal(light.colour, expected, sizeof expected);
    }
}

static void behind_an_opaque_sample_nothing_is_seen(void **state)
{
    static const uint32_t sample[3] = {COLOUR8, COLOUR16, 0xFFFFFFFF};
    uint32_t seed = 4;
    (void)state;

    for (unsigned i = 0; i < 1000; i++) {
        qv_light light = random_light(&seed);
        light.transmittance = 0;
        const qv_light before = light;
        under(&light, sample, random_next(&seed));
        assert_memory_equal(&light, &before, sizeof light);
    }
}

/* The first sample counts in full: half its unit, to nearest. */
static void both_start_alike(void **state)
{
    uint32_t seed = 5;
    (void)state;

    for (unsigned i = 0; i < 100000; i++) {
        const uint32_t opacity = random_next(&seed);
        uint32_t sample[3];
        for (unsigned c = 0; c < 3; c++)
            sample[c] = random_next(&seed) % COLOUR16;
        qv_light front = clear(), back = clear();
        under(&front, sample, opacity);
        over(&back, sample, opacity);
        assert_memory_equal(&front, &back, sizeof front);
        assert_int_equal(front.colour[0], sample[0] / 2 + sample[0] % 2);
    }
}

/* ---- Rounding ---- */

/* One operation against real numbers: each product to nearest, so T and under
   are within half a unit, over within one (its own product and the halved sample). */
static void one_operation_rounds_to_nearest(void **state)
{
    uint32_t seed = 6;
    (void)state;

    for (unsigned i = 0; i < 300000; i++) {
        const qv_light before = random_light(&seed);
        const uint32_t opacity = random_next(&seed) >> random_below(&seed, 32);
        const uint32_t sample[3] = {random_next(&seed) % COLOUR16, random_next(&seed) >> 12, 1};
        const double alpha = ldexp(opacity, -32);
        const double remains = before.transmittance * (1 - alpha);
        qv_light front = before, back = before;
        under(&front, sample, opacity);
        over(&back, sample, opacity);
        assert_true(fabs(front.transmittance - remains) <= 0.5);
        assert_true(fabs(back.transmittance - remains) <= 0.5);
        for (unsigned c = 0; c < 3; c++) {
            const double behind = before.colour[c] + ldexp(sample[c], -32) * before.transmittance;
            const double before_it = before.colour[c] * (1 - alpha) + sample[c] / 2.0;
            assert_true(fabs(front.colour[c] - behind) <= 0.5);
            assert_true(fabs(back.colour[c] - before_it) <= 1);
        }
    }
}

/* ---- Both orders ---- */

enum { SAMPLES = 512 };

typedef struct shade {
    uint32_t colour[3], opacity;
} shade;

/* Associated colours of one storage: below the opacity, in its unit. */
static void random_shades(shade shades[SAMPLES], uint32_t *seed, uint32_t unit)
{
    const unsigned thin = random_below(seed, 12);
    for (unsigned i = 0; i < SAMPLES; i++) {
        const uint32_t opacity = random_next(seed) >> thin;
        shades[i].opacity = opacity;
        for (unsigned c = 0; c < 3; c++)
            shades[i].colour[c] =
                fx_high_product(fx_high_product(opacity, random_next(seed)), unit);
    }
}

static void under_and_over_agree(void **state)
{
    static shade shades[SAMPLES];
    uint32_t seed = 7;
    (void)state;

    for (unsigned round = 0; round < 2000; round++) {
        qv_light front = clear(), back = clear();
        random_shades(shades, &seed, round % 2 != 0 ? COLOUR8 : COLOUR16);
        for (unsigned i = 0; i < SAMPLES; i++)
            under(&front, shades[i].colour, shades[i].opacity);
        for (unsigned i = SAMPLES; i > 0; i--)
            over(&back, shades[i - 1].colour, shades[i - 1].opacity);
        for (unsigned c = 0; c < 3; c++) /* n * 2^-32 of 1 each, over twice that */
            assert_true(fabs((double)front.colour[c] - back.colour[c]) <= SAMPLES * 1.5);
        assert_true(fabs((double)front.transmittance - back.transmittance) <= SAMPLES);
        assert_true(front.colour[0] + (uint64_t)front.transmittance < ALL_LIGHT + SAMPLES);
    }
}

/* A thin fog of one colour: light and transmittance stay a whole. */
static void light_and_transmittance_sum_to_one(void **state)
{
    const uint32_t opacity = 16909320; /* 1/254 */
    const uint32_t fog[3] = {COLOUR16 / 254, 0, 0};
    qv_light light = clear();
    (void)state;

    for (unsigned i = 0; i < 4096; i++) {
        const double transmittance = ldexp(light.transmittance, -31);
        under(&light, fog, opacity);
        assert_true(fabs(level(light.colour[0], QV_READ_OUT_16) + ldexp(light.transmittance, -31) -
                         1) < 1e-5);
        assert_true(ldexp(light.transmittance, -31) < transmittance || transmittance < 1e-6);
    }
}

/* ---- Read-out ---- */

/* round(255 * 2^49 / unit): levels of 2^-16 from halves of a unit. */
static void read_out_factors(void **state)
{
    const uint64_t levels = (uint64_t)255 << 49;
    (void)state;

    assert_int_equal(QV_READ_OUT_8, (levels + COLOUR8 / 2) / COLOUR8);
    assert_int_equal(QV_READ_OUT_16, (levels + COLOUR16 / 2) / COLOUR16);
}

/* round(255 * 2^55 / unit): light of slices, as fx_light_of takes it. */
static void light_factors(void **state)
{
    const uint64_t light = (uint64_t)255 << 55;
    (void)state;

    assert_int_equal(QV_LIGHT_OF(QV_READ_OUT_8), (light + COLOUR8 / 2) / COLOUR8);
    assert_int_equal(QV_LIGHT_OF(QV_READ_OUT_16), (light + COLOUR16 / 2) / COLOUR16);
    assert_int_equal(QV_LIGHT_OF(QV_READ_OUT_CONVERTED), (light + CONVERTED / 2) / CONVERTED);
}

/* Full light of either storage is exactly the level 1, and none is 0. */
static void full_light_is_level_one(void **state)
{
    static const uint32_t white8[3] = {COLOUR8, 0, COLOUR8 / 255};
    static const uint32_t white16[3] = {COLOUR16, 0, COLOUR16 / 255};
    qv_light light8 = clear(), light16 = clear();
    (void)state;

    under(&light8, white8, OPAQUE);
    under(&light16, white16, OPAQUE);
    assert_int_equal(fx_high_product(light8.colour[0], QV_READ_OUT_8), QV_LEVEL_ONE);
    assert_int_equal(fx_high_product(light16.colour[0], QV_READ_OUT_16), QV_LEVEL_ONE);
    assert_int_equal(fx_high_product(light8.colour[1], QV_READ_OUT_8), 0);
    assert_int_equal(fx_high_product(light8.colour[2], QV_READ_OUT_8), QV_LEVEL_ONE / 255);
    assert_int_equal(fx_high_product(light16.colour[2], QV_READ_OUT_16), QV_LEVEL_ONE / 255);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(transparent_samples_change_nothing),
        cmocka_unit_test(opaque_samples_leave_no_transmittance),
        cmocka_unit_test(an_opaque_sample_in_front_hides_all),
        cmocka_unit_test(behind_an_opaque_sample_nothing_is_seen),
        cmocka_unit_test(both_start_alike),
        cmocka_unit_test(one_operation_rounds_to_nearest),
        cmocka_unit_test(under_and_over_agree),
        cmocka_unit_test(light_and_transmittance_sum_to_one),
        cmocka_unit_test(read_out_factors),
        cmocka_unit_test(light_factors),
        cmocka_unit_test(full_light_is_level_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
