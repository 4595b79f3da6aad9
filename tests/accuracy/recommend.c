/*
 * The table of qv_recommend against the blends: measured again, no cell is exceeded. Cells of 64
 * slices are measured as make recommend does, so that they must be met; the others in part.
 */
#include "check.h"
#include "qvol.h"
#include "recommend/cells.h"

#include <stdio.h>
#include <string.h>

static qv_recommendation recommendation_of(unsigned state, const ref_slice_limits *limits)
{
    const uint32_t opacity = (uint32_t)(limits->least / 255 * UINT32_MAX + .5);
    qv_recommendation r;
    assert_int_equal(qv_recommend(&r, cell_states[state].bits, cell_states[state].residual_bits,
                                  (uint16_t)limits->count, opacity == 0 ? 1 : opacity),
                     QV_OK);
    return r;
}

/* What was measured of that which is recommended, in 1/100 level. */
static ref_worst measured_of(const qv_recommendation *r, const ref_worst worst[REF_ROUNDINGS])
{
    const int dithers = r->advice == QV_ADVICE_DITHER || r->advice == QV_ADVICE_RESIDUAL;
    const ref_worst *of = &worst[dithers ? REF_ROUNDING_BLOCKS : REF_ROUNDING_PLAIN];
    const ref_worst hundredths = {100 * of->fog, 100 * of->any};
    return hundredths;
}

/* `share`: of the table's figure, what is to be found again at least. */
static void check_cell(unsigned row, unsigned column, ref_worst worst[REF_STATES][REF_ROUNDINGS],
                       double share)
{
    const ref_slice_limits limits = cell_limits(row, column);
    for (unsigned state = 0; state < REF_STATES; state++) {
        const qv_recommendation r = recommendation_of(state, &limits);
        const ref_worst found = measured_of(&r, worst[state]);
        printf("# %-8s from %2g, %4u slices: fog %5.0f of %5u, any %5.0f of %5u\n",
               cell_states[state].name, limits.least, limits.count, found.fog, r.worst_fog,
               found.any, r.worst);
        assert_true(found.fog <= r.worst_fog + .01 && found.any <= r.worst + .01);
        assert_true(found.any >= share * r.worst);
    }
}

static void few_slices_in_full(void **state)
{
    static ref_worst higher[REF_STATES][REF_ROUNDINGS], worst[REF_STATES][REF_ROUNDINGS];
    const ref_effort dense = cell_effort(0);
    (void)state;
    for (unsigned row = CELL_ROWS; row-- > 0;) {
        const ref_slice_limits limits = cell_limits(row, 0);
        ref_blend_worst(worst, &limits, &dense);
        cell_raise(worst, higher);
        memcpy(higher, worst, sizeof worst);
        check_cell(row, 0, worst, .97);
    }
}

static void more_slices_in_part(void **state)
{
    static ref_worst worst[REF_STATES][REF_ROUNDINGS];
    static const ref_effort part[CELL_COLUMNS] = {{0, 0}, {20, 8}, {40, 8}, {200, 8}};
    (void)state;
    for (unsigned row = 0; row < CELL_ROWS; row++)
        for (unsigned column = 1; column < CELL_COLUMNS; column++) {
            const ref_slice_limits limits = cell_limits(row, column);
            ref_blend_worst(worst, &limits, &part[column]);
            check_cell(row, column, worst, .3);
        }
}

/* Strictly in 8 bits: no other sequence has a smaller worst case and is within 5.5 levels in a
   fog; in a fog alone, golden ratio is as good. */
static void blocks_are_the_best(void **state)
{
    static ref_worst worst[REF_STATES][REF_ROUNDINGS];
    static const ref_effort part = {10, 8};
    const ref_slice_limits limits = cell_limits(0, 2);
    (void)state;
    ref_blend_worst(worst, &limits, &part);
    const ref_worst *of = worst[REF_STATE_8];
    assert_true(of[REF_ROUNDING_BLOCKS].fog <= 5.5);
    assert_true(of[REF_ROUNDING_HASH].fog > 5.5);
    assert_true(of[REF_ROUNDING_GOLDEN].fog <= 5.5);
    assert_true(of[REF_ROUNDING_GOLDEN].any > of[REF_ROUNDING_BLOCKS].any);
    assert_true(of[REF_ROUNDING_PLAIN].any > of[REF_ROUNDING_BLOCKS].any);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(few_slices_in_full),
        cmocka_unit_test(more_slices_in_part),
        cmocka_unit_test(blocks_are_the_best),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
