/*
 * Recommendations: which blend for which frame buffer, errors that never rise where they should
 * fall, and what is refused. The figures themselves are held by tests/accuracy/recommend.c.
 */
#include "check.h"
#include "qvol.h"

#include <string.h>

#define LEVEL 0x01010101u

static qv_recommendation recommend(uint8_t bits, uint8_t residual_bits, uint16_t slices,
                                   uint32_t opacity)
{
    qv_recommendation r;
    assert_int_equal(qv_recommend(&r, bits, residual_bits, slices, opacity), QV_OK);
    return r;
}

static void expect_advice(uint8_t bits, uint8_t residual_bits, uint32_t opacity, qv_advice advice)
{
    const qv_recommendation r = recommend(bits, residual_bits, 1000, opacity);
    const int dithers = advice == QV_ADVICE_DITHER || advice == QV_ADVICE_RESIDUAL;
    assert_int_equal(r.advice, advice);
    assert_true(r.sequence == (dithers ? qv_sequence_blocks : qv_sequence_rounded));
}

static void what_to_take(void **state)
{
    (void)state;
    expect_advice(5, 0, 1, QV_ADVICE_DITHER);
    expect_advice(6, 0, 16 * LEVEL, QV_ADVICE_DITHER);
    expect_advice(5, 0, 64 * LEVEL, QV_ADVICE_PLAIN);
    expect_advice(6, 0, UINT32_MAX, QV_ADVICE_PLAIN);
    expect_advice(8, 0, 1, QV_ADVICE_DITHER);
    expect_advice(8, 0, 64 * LEVEL, QV_ADVICE_DITHER);
    expect_advice(8, 4, 1, QV_ADVICE_RESIDUAL);
    expect_advice(8, 8, LEVEL, QV_ADVICE_RESIDUAL);
    expect_advice(12, 0, LEVEL, QV_ADVICE_DITHER);
    expect_advice(16, 0, LEVEL, QV_ADVICE_DITHER);
    expect_advice(24, 0, LEVEL, QV_ADVICE_ROUND);
}

static void expect_same(const qv_recommendation *a, const qv_recommendation *b)
{
    assert_int_equal(a->worst, b->worst);
    assert_int_equal(a->worst_fog, b->worst_fog);
}

/* 8 bits and a residual are as good as 12 or 16; other bits make no use of one. */
static void residuals(void **state)
{
    static const uint8_t others[] = {5, 6, 12, 16, 24};
    (void)state;
    for (uint32_t opacity = 1; opacity < UINT32_MAX / 3; opacity *= 3) {
        const qv_recommendation eight4 = recommend(8, 4, 500, opacity);
        const qv_recommendation eight8 = recommend(8, 8, 500, opacity);
        const qv_recommendation twelve = recommend(12, 0, 500, opacity);
        const qv_recommendation sixteen = recommend(16, 0, 500, opacity);
        expect_same(&eight4, &twelve);
        expect_same(&eight8, &sixteen);
    }
    for (unsigned i = 0; i < sizeof others; i++) {
        const qv_recommendation without = recommend(others[i], 0, 9, 9);
        const qv_recommendation with = recommend(others[i], 8, 9, 9);
        expect_same(&without, &with);
        assert_int_equal(without.advice, with.advice);
    }
}

/* More bits, fewer slices and higher opacities never do harm. */
static void errors_fall(void **state)
{
    static const uint8_t bits[] = {5, 6, 8, 12, 16, 24};
    (void)state;
    for (unsigned i = 0; i < sizeof bits; i++)
        for (uint16_t slices = 1; slices <= 4096; slices = (uint16_t)(2 * slices))
            for (uint32_t opacity = 1; opacity < UINT32_MAX / 4; opacity *= 2) {
                const qv_recommendation r = recommend(bits[i], 0, slices, opacity);
                const qv_recommendation fewer =
                    recommend(bits[i], 0, (uint16_t)(1 + slices / 2), opacity);
                const qv_recommendation higher = recommend(bits[i], 0, slices, 2 * opacity);
                assert_true(r.worst_fog <= r.worst && r.worst >= 50);
                assert_true(fewer.worst <= r.worst && fewer.worst_fog <= r.worst_fog);
                assert_true(higher.worst <= r.worst && higher.worst_fog <= r.worst_fog);
                if (i > 0)
                    assert_true(r.worst <= recommend(bits[i - 1], 0, slices, opacity).worst);
            }
}

/* The aims: 1000 slices of any content and opacity. */
static void what_is_reached(void **state)
{
    const qv_recommendation eight = recommend(8, 0, 1000, 1), sixteen = recommend(16, 0, 1000, 1),
                            most = recommend(24, 0, 1000, 1);
    (void)state;
    assert_true(eight.worst_fog <= 550 && eight.worst <= 4000);
    assert_true(sixteen.worst_fog <= 70 && sixteen.worst <= 75);
    assert_int_equal(most.worst, 51);
    assert_int_equal(most.worst_fog, 51);
}

/* Rows begin at 1, 4, 16 and 64 levels, columns end at 64, 256, 1024 and 4096 slices. */
static void limits_of_cells(void **state)
{
    static const uint32_t levels[] = {1, 4, 16, 64};
    (void)state;
    for (unsigned i = 0; i < sizeof levels / sizeof *levels; i++) {
        const uint32_t least = levels[i] * LEVEL;
        assert_true(recommend(12, 0, 64, least).worst < recommend(12, 0, 64, least - 1).worst);
    }
    for (uint16_t slices = 64; slices < 4096; slices = (uint16_t)(4 * slices))
        assert_true(recommend(12, 0, slices, 1).worst <
                    recommend(12, 0, (uint16_t)(slices + 1), 1).worst);
}

static void refuse(uint8_t bits, uint8_t residual_bits, uint16_t slices, uint32_t opacity,
                   qv_status expected)
{
    qv_recommendation r, before;
    memset(&r, 0x5A, sizeof r);
    memcpy(&before, &r, sizeof r);
    assert_int_equal(qv_recommend(&r, bits, residual_bits, slices, opacity), expected);
    assert_memory_equal(&r, &before, sizeof r);
}

static void bad_questions_are_refused(void **state)
{
    (void)state;
    assert_int_equal(qv_recommend(NULL, 8, 0, 1, 1), QV_ERROR_NULL);
    refuse(7, 0, 1, 1, QV_ERROR_SIZE);
    refuse(0, 0, 1, 1, QV_ERROR_SIZE);
    refuse(255, 0, 1, 1, QV_ERROR_SIZE);
    refuse(8, 2, 1, 1, QV_ERROR_SIZE);
    refuse(8, 16, 1, 1, QV_ERROR_SIZE);
    refuse(16, 1, 1, 1, QV_ERROR_SIZE);
    refuse(8, 0, 0, 1, QV_ERROR_SLICE);
    refuse(8, 0, 4097, 1, QV_ERROR_SLICE);
    refuse(8, 0, 65535, 1, QV_ERROR_SLICE);
    refuse(8, 0, 1, 0, QV_ERROR_SLICE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_to_take),    cmocka_unit_test(residuals),
        cmocka_unit_test(errors_fall),     cmocka_unit_test(what_is_reached),
        cmocka_unit_test(limits_of_cells), cmocka_unit_test(bad_questions_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
