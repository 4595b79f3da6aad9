/*
 * Transfer tables against linear interpolation in real numbers.
 */
#include "check.h"
#include "classify_reference.h"
#include "qvol.h"
#include "random.h"

#include <string.h>

static void expect_reference(const qv_transfer *table, const qv_control_point *points,
                             uint16_t count)
{
    double expected[4];

    for (unsigned i = 0; i < QV_PALETTE_ENTRIES; i++) {
        ref_transfer_entry(expected, points, count, i);
        for (unsigned c = 0; c < 4; c++)
            if (table->rgba[i][c] != ref_nearest(expected[c]))
                fail_msg("entry %u channel %u: %u, not %f", i, c, table->rgba[i][c], expected[c]);
    }
}

/* The build of a table that must succeed, with the colours of the points exact. */
static void expect_built(const qv_control_point *points, uint16_t count)
{
    qv_transfer table;

    memset(&table, 0x5A, sizeof table);
    assert_int_equal(qv_transfer_build(&table, points, count), QV_OK);
    expect_reference(&table, points, count);
    for (uint16_t i = 0; i < count; i++)
        assert_memory_equal(table.rgba[points[i].index], points[i].rgba, sizeof points[i].rgba);
}

/* Every pair of indices, with colours that rise, fall, stay, and take both ends. */
static void all_pairs_of_points(void **state)
{
    uint32_t seed = 1;
    (void)state;

    for (unsigned first = 0; first < 255; first++)
        for (unsigned second = first + 1; second < 256; second++) {
            qv_control_point points[2] = {{(uint8_t)first, {0, 65535, 0, 0}},
                                          {(uint8_t)second, {65535, 0, 0, 0}}};
            points[0].rgba[2] = points[1].rgba[2] = (uint16_t)random_next(&seed);
            points[0].rgba[3] = (uint16_t)random_next(&seed);
            points[1].rgba[3] = (uint16_t)random_next(&seed);
            expect_built(points, 2);
        }
}

/* Halves go up, whether the channel rises or falls. */
static void ties_go_upwards(void **state)
{
    const qv_control_point points[2] = {{10, {0, 1, 65534, 65535}}, {12, {1, 0, 65535, 65534}}};
    const uint16_t expected[4] = {1, 1, 65535, 65535};
    qv_transfer table;
    (void)state;

    assert_int_equal(qv_transfer_build(&table, points, 2), QV_OK);
    assert_memory_equal(table.rgba[11], expected, sizeof expected);
}

static void one_point_fills_the_table(void **state)
{
    const qv_control_point point = {77, {1, 2, 65535, 4}};
    (void)state;

    expect_built(&point, 1);
}

static void many_points(void **state)
{
    qv_control_point points[QV_PALETTE_ENTRIES];
    uint32_t seed = 7;
    (void)state;

    for (unsigned gap = 1; gap < 100; gap++) {
        uint16_t count = 0;
        for (unsigned i = random_below(&seed, gap); i < QV_PALETTE_ENTRIES;
             i += 1 + random_below(&seed, gap)) {
            points[count].index = (uint8_t)i;
            for (unsigned c = 0; c < 4; c++)
                points[count].rgba[c] = (uint16_t)random_next(&seed);
            count++;
        }
        if (count > 0)
            expect_built(points, count);
    }
}

static void expect_refused(const qv_control_point *points, uint16_t count, qv_status expected)
{
    qv_transfer table, before;

    memset(&table, 0xC3, sizeof table);
    memset(&before, 0xC3, sizeof before);
    assert_int_equal(qv_transfer_build(&table, points, count), expected);
    assert_memory_equal(&table, &before, sizeof table);
}

static void bad_points_are_refused(void **state)
{
    static qv_control_point points[QV_PALETTE_ENTRIES + 1];
    (void)state;

    for (unsigned i = 0; i < QV_PALETTE_ENTRIES; i++)
        points[i].index = (uint8_t)i;
    points[QV_PALETTE_ENTRIES].index = 255;
    expect_refused(NULL, 1, QV_ERROR_NULL);
    expect_refused(points, 0, QV_ERROR_TRANSFER);
    expect_refused(points, QV_PALETTE_ENTRIES + 1, QV_ERROR_TRANSFER);
    expect_refused(points, 65535, QV_ERROR_TRANSFER);
    points[4].index = 3;
    expect_refused(points, 5, QV_ERROR_TRANSFER);
    points[4].index = 2;
    expect_refused(points, 5, QV_ERROR_TRANSFER);
    expect_built(points, 4);
    assert_int_equal(qv_transfer_build(NULL, points, 4), QV_ERROR_NULL);
}

/* All 65536 levels, 1024 a table. */
static void palette_of_8_bits_rounds_every_level(void **state)
{
    qv_transfer table;
    uint8_t palette[QV_PALETTE_ENTRIES][4];
    (void)state;

    for (unsigned base = 0; base < 65536; base += 1024) {
        for (unsigned i = 0; i < 1024; i++)
            table.rgba[i / 4][i % 4] = (uint16_t)(base + i);
        qv_transfer_to_palette8(palette, &table);
        for (unsigned i = 0; i < 1024; i++)
            assert_int_equal(palette[i / 4][i % 4], (int)ref_nearest((base + i) / 257.0));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_pairs_of_points),
        cmocka_unit_test(ties_go_upwards),
        cmocka_unit_test(one_point_fills_the_table),
        cmocka_unit_test(many_points),
        cmocka_unit_test(bad_points_are_refused),
        cmocka_unit_test(palette_of_8_bits_rounds_every_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
