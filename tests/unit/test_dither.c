/*
 * The dither of a slice in a pixel: sequences, places in the period, what techniques are told
 * of pixels, and dithers that are refused.
 */
#include "blend_model.h"
#include "check.h"
#include "random.h"
#include "scene_fixture.h"

static const uint32_t lattice_x = 0xC13FA9A9u, lattice_y = 0x91E10DA6u, golden = 0x9E3779B9u;

static const qv_technique *const techniques[] = {
    &qv_technique_rounded, &qv_technique_random,        &qv_technique_ordered,
    &qv_technique_bumped,  &qv_technique_bumped_random, &qv_technique_corrected};

enum { TECHNIQUES = sizeof techniques / sizeof techniques[0], FIRST_NUMBER = 0x400000 };

static qv_dither some_dither(void)
{
    const qv_dither dither = {.sequence = qv_sequence_blocks,
                              .technique = &qv_technique_ordered,
                              .slope = {0x8000, 0x30000},
                              .frame = 5,
                              .period = 7,
                              .cutoff = 9};
    return dither;
}

static qv_moment moment_of(const qv_dither *dither, const qv_blend *blend, int32_t slice)
{
    qv_moment moment;
    assert_int_equal(qv_moment_of(&moment, dither, blend, slice), QV_OK);
    return moment;
}

/* ---- Sequences ---------------------------------------------------------------- */

static uint32_t model_hash(uint32_t v)
{
    v ^= v >> 16;
    v *= 0x7FEB352Du;
    v ^= v >> 15;
    v *= 0x846CA68Bu;
    return v ^ v >> 16;
}

static void sequences(void **state)
{
    uint32_t seed = 1;
    (void)state;

    for (unsigned turn = 0; turn < 10000; turn++) {
        const uint32_t n = random_next(&seed) >> turn % 16, block = n / 8;
        assert_int_equal(qv_sequence_rounded(n), 0x80000000u);
        assert_int_equal(qv_sequence_golden(n), golden * n);
        assert_int_equal(qv_sequence_hash(n), model_hash(2 * n + 1));
        assert_int_equal(qv_sequence_blocks(n),
                         0x20000000u * (5 * n + model_hash(block)) +
                             (uint32_t)(golden * block + model_hash(block / 64)) / 8);
    }
}

/* ---- Moments -------------------------------------------------------------------- */

/* Slice 0 has the number 2^22. */
static void moments_of_slices(void **state)
{
    static const int32_t slices[] = {-0x3FFFFF, -1000, -1, 0, 1, 12345, 0x3FFFFF};
    (void)state;

    for (unsigned i = 0; i < sizeof slices / sizeof slices[0]; i++)
        for (unsigned period = 2; period <= 64; period++) {
            qv_dither dither = some_dither();
            dither.period = (uint8_t)period;
            const uint32_t number = (uint32_t)(FIRST_NUMBER - slices[i]);
            const uint32_t frames = 1024 * dither.frame;
            const qv_moment moment = moment_of(&dither, &qv_hardware_rgb888, slices[i]);
            assert_int_equal(moment.u, qv_sequence_blocks(number + frames) + golden * dither.frame);
            assert_int_equal(moment.phase, (number + dither.frame) % period);
            assert_int_equal(moment_of(&dither, &qv_under_rgb16, slices[i]).u,
                             qv_sequence_blocks((uint32_t)(FIRST_NUMBER + slices[i]) + frames) +
                                 golden * dither.frame);
            assert_true(moment.technique == dither.technique);
            assert_int_equal(moment.alpha.period.slices, period);
            assert_int_equal(moment.alpha.slope[0], 0x8000);
            assert_int_equal(moment.alpha.slope[1], 0x30000);
            assert_int_equal(moment.alpha.cutoff, 9);
        }
}

static void zero_is_the_default(void **state)
{
    qv_dither dither = some_dither();
    (void)state;

    dither.slope[0] = dither.slope[1] = 0;
    dither.cutoff = 0;
    const qv_moment moment = moment_of(&dither, &qv_hand_out_rgba8888, 3);
    assert_int_equal(moment.alpha.slope[0], QV_ONE_Q16);
    assert_int_equal(moment.alpha.slope[1], QV_ONE_Q16);
    assert_int_equal(moment.alpha.cutoff, 255);
}

static void shifts_of_pixels(void **state)
{
    uint32_t seed = 2;
    (void)state;

    for (unsigned turn = 0; turn < 20000; turn++) {
        qv_dither dither = some_dither();
        const int32_t x = (int32_t)random_below(&seed, 65534) - 32767;
        const int32_t y = (int32_t)random_below(&seed, 65534) - 32767;
        dither.period = (uint8_t)(2 + random_below(&seed, 63));
        dither.frame = random_next(&seed);
        dither.still = turn % 2 != 0;
        const qv_moment slice = moment_of(&dither, &qv_hardware_rgb888, (int32_t)turn - 10000);
        qv_moment pixel = slice;
        qv_moment_at(&pixel, slice.u + qv_dither_shift(slice.spread, x, y));
        uint32_t shift = 0;
        if (!dither.still)
            shift = lattice_x * (uint32_t)x + lattice_y * (uint32_t)y;
        assert_int_equal(pixel.u, slice.u + shift);
        assert_int_equal(pixel.phase,
                         (slice.phase + (shift >> 16) * dither.period / 65536) % dither.period);
    }
}

/* Without a technique there is no period to be shifted in. */
static void blends_of_states_have_no_phase(void **state)
{
    qv_dither dither = {.sequence = qv_sequence_golden};
    (void)state;

    for (unsigned i = 0; i < MODELS; i++)
        if (!models[i].blend->look) {
            const qv_moment slice = moment_of(&dither, models[i].blend, 100);
            qv_moment pixel = slice;
            assert_null(slice.technique);
            pixel.phase = 77;
            qv_moment_at(&pixel, slice.u + qv_dither_shift(slice.spread, 1, 0));
            assert_int_equal(pixel.phase, 77);
            const int32_t number = FIRST_NUMBER + (models[i].rule == RULE_UNDER ? 100 : -100);
            assert_int_equal(pixel.u, golden * (uint32_t)number + lattice_x);
        }
}

/* A slice's pixels meet every place of a period about equally often. */
static void pixels_spread_over_the_period(void **state)
{
    qv_dither dither = some_dither();
    unsigned count[7] = {0};
    (void)state;

    const qv_moment slice = moment_of(&dither, &qv_hardware_rgb888, 0);
    for (int32_t y = 0; y < 70; y++)
        for (int32_t x = 0; x < 70; x++) {
            qv_moment pixel = slice;
            qv_moment_at(&pixel, slice.u + qv_dither_shift(slice.spread, x, y));
            count[pixel.phase]++;
        }
    for (unsigned i = 0; i < 7; i++)
        assert_in_range(count[i], 690, 710);
}

/* ---- What techniques are told ----------------------------------------------------- */

/* The opacity and, by the blend, the pixel's value and the slice's colour. */
typedef struct question {
    uint32_t level, value, colour;
} question;

static question asked;

static uint32_t ask(const qv_moment *moment, uint32_t level, uint32_t value, uint32_t colour)
{
    asked = (question){level, value, colour};
    return moment->phase;
}

static question question_of(const qv_blend *blend, const qv_technique *technique,
                            const uint8_t *pixel, const qv_fragment *fragment)
{
    qv_moment moment = {.phase = 42, .technique = technique};
    qv_moment_opacity(&moment, blend, pixel, fragment);
    assert_int_equal(moment.opacity, 42);
    return asked;
}

static void expect_question(const question *q, uint32_t level, uint32_t value, uint32_t colour)
{
    assert_int_equal(q->level, level);
    assert_int_equal(q->value, value);
    assert_int_equal(q->colour, colour);
}

/* A slice of opacity 1/2 and the colours 200, 10, 201 over a pixel. */
static void techniques_are_told_of_the_pixel(void **state)
{
    static const qv_technique by_value = {ask, 1, 0}, alone = {ask, 0, 0};
    static const qv_fragment fragment = {{200u << 22, 10u << 22, 201u << 22}, 0x80000000u};
    static const uint8_t rgba[4] = {60, 70, 80, 90}, rgb565[2] = {0x29, 0x4B}; /* 9, 25, 9 */
    const uint32_t half = 255u << 15;
    question q;
    (void)state;

    q = question_of(&qv_hardware_rgb888, &by_value, rgba, &fragment);
    expect_question(&q, half, 80, 201);
    q = question_of(&qv_hardware_rgb565, &by_value, rgb565, &fragment);
    expect_question(&q, half, 9 << 3 | 9 >> 2, 201);
    q = question_of(&qv_hardware_rgba8888, &by_value, rgba, &fragment);
    expect_question(&q, half, 90, 255);
    q = question_of(&qv_hand_out_rgba8888, &by_value, rgba, &fragment);
    expect_question(&q, half, 0, 255);
    q = question_of(&qv_hardware_rgb888, &alone, rgba, &fragment);
    expect_question(&q, half, 0, 255);
}

/* Of equal colours the first counts, and of 565 the green one's 6 bits are widened too. */
static void the_largest_colour_counts(void **state)
{
    static const qv_technique by_value = {ask, 1, 0};
    static const uint8_t rgb[3] = {1, 2, 3}, rgb565[2] = {0x29, 0x4B};
    qv_fragment fragment = {{50u << 23, 50u << 23, 50u << 23}, 0xFFFFFFFFu};
    question q;
    (void)state;

    q = question_of(&qv_hardware_rgb888, &by_value, rgb, &fragment);
    expect_question(&q, 255u << 16, 1, 50);
    fragment.light[1] = 51u << 23;
    q = question_of(&qv_hardware_rgb888, &by_value, rgb, &fragment);
    expect_question(&q, 255u << 16, 2, 51);
    q = question_of(&qv_hardware_rgb565, &by_value, rgb565, &fragment);
    expect_question(&q, 255u << 16, 25 << 2 | 25 >> 4, 51);
    fragment = (qv_fragment){{0, 0, 0}, 0};
    q = question_of(&qv_hardware_rgb888, &by_value, rgb, &fragment);
    expect_question(&q, 0, 1, 0);
}

/* Each does what fx_alpha.h calls it. */
static void techniques_do_their_arithmetic(void **state)
{
    uint32_t seed = 3;
    (void)state;

    for (unsigned turn = 0; turn < 5000; turn++) {
        qv_dither dither = some_dither();
        dither.period = (uint8_t)(2 + random_below(&seed, 63));
        dither.cutoff = (uint8_t)random_next(&seed);
        const qv_moment m = moment_of(&dither, &qv_hardware_rgb888, (int32_t)turn);
        const uint32_t level = random_below(&seed, 255u * 65536u + 1);
        const uint32_t value = random_below(&seed, 256), colour = random_below(&seed, 256);
        const uint32_t way = value < colour ? colour - value : value - colour;
        const uint32_t expected[TECHNIQUES] = {
            (level + 32768) / 65536,
            fx_alpha_random(&m.alpha, level, m.u),
            fx_alpha_ordered(&m.alpha, level, m.phase),
            fx_alpha_bumped(&m.alpha, level, m.phase, 255 - way),
            fx_alpha_bumped_random(&m.alpha, level, m.u, 255 - way),
            fx_alpha_corrected(level, colour, value, m.u)};
        for (unsigned i = 0; i < TECHNIQUES; i++)
            assert_int_equal(techniques[i]->opacity(&m, level, value, colour), expected[i]);
    }
}

static void some_look_at_pixels(void **state)
{
    (void)state;
    for (unsigned i = 0; i < TECHNIQUES; i++)
        assert_int_equal(techniques[i]->by_value, i >= 3);
}

/* ---- Refused -------------------------------------------------------------------- */

static void expect_refused(const qv_dither *dither, const qv_blend *blend, int32_t slice,
                           qv_status status)
{
    qv_moment moment;
    fixture_poison(&moment, sizeof moment);
    assert_int_equal(qv_moment_of(&moment, dither, blend, slice), status);
    assert_true(fixture_untouched(&moment, sizeof moment));
}

static void refused_by_any_blend(const qv_dither *dither, qv_status status)
{
    for (unsigned i = 0; i < MODELS; i++)
        expect_refused(dither, models[i].blend, 0, status);
}

/* Refused where it is wanted, and not read elsewhere. */
static void refused_by_techniques(const qv_dither *dither)
{
    const int period_is_read = !dither->technique || dither->technique->by_period;
    for (unsigned i = 0; i < MODELS; i++)
        if (models[i].blend->look && period_is_read)
            expect_refused(dither, models[i].blend, 0, QV_ERROR_DITHER);
        else
            (void)moment_of(dither, models[i].blend, 0);
}

static void dithers_out_of_range(void **state)
{
    static const uint8_t periods[] = {0, 1, 65, 255};
    qv_dither dither = some_dither();
    (void)state;

    refused_by_any_blend(NULL, QV_ERROR_NULL);
    dither.sequence = NULL;
    refused_by_any_blend(&dither, QV_ERROR_DITHER);
    dither = some_dither();
    dither.technique = NULL;
    refused_by_techniques(&dither);
    for (unsigned i = 0; i < sizeof periods; i++) {
        dither = some_dither();
        dither.period = periods[i];
        refused_by_techniques(&dither);
        dither.technique = &qv_technique_corrected;
        refused_by_techniques(&dither);
    }
    for (unsigned i = 0; i < 2; i++) {
        dither = some_dither();
        dither.slope[i] = 0x100001;
        refused_by_techniques(&dither);
        dither.slope[i] = 0x100000;
        (void)moment_of(&dither, &qv_hardware_rgb888, 0);
    }
}

static void slices_out_of_range(void **state)
{
    static const int32_t slices[] = {INT32_MIN, -0x400001, 0x400000, INT32_MAX};
    const qv_dither dither = some_dither();
    (void)state;

    for (unsigned i = 0; i < sizeof slices / sizeof slices[0]; i++)
        for (unsigned blend = 0; blend < MODELS; blend++)
            expect_refused(&dither, models[blend].blend, slices[i], QV_ERROR_SLICE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sequences),
        cmocka_unit_test(moments_of_slices),
        cmocka_unit_test(zero_is_the_default),
        cmocka_unit_test(shifts_of_pixels),
        cmocka_unit_test(blends_of_states_have_no_phase),
        cmocka_unit_test(pixels_spread_over_the_period),
        cmocka_unit_test(techniques_are_told_of_the_pixel),
        cmocka_unit_test(the_largest_colour_counts),
        cmocka_unit_test(techniques_do_their_arithmetic),
        cmocka_unit_test(some_look_at_pixels),
        cmocka_unit_test(dithers_out_of_range),
        cmocka_unit_test(slices_out_of_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
