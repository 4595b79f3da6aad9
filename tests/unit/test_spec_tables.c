/*
 * The worked examples S80 .. S83 of tests/SPEC.md: opacities of tables, and dither tables. The
 * same inputs and results as there, written out.
 */
#include "check.h"
#include "qvol.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

static void S80_number_of_slices(void **state)
{
    static const uint16_t opacities[6] = {0, 1, 1000, 30000, 65534, 65535};
    static const uint16_t numbers[3][2] = {{128, 600}, {600, 128}, {65535, 1}};
    static const uint16_t expected[3][6] = {{0, 0, 215, 8022, 59384, 65535},
                                            {0, 5, 4557, 61816, 65535, 65535},
                                            {0, 41426, 65535, 65535, 65535, 65535}};
    qv_transfer from = {{{0}}}, to;
    (void)state;
    for (unsigned i = 0; i < 6; i++)
        from.rgba[i][3] = opacities[i];
    for (unsigned n = 0; n < 3; n++) {
        assert_int_equal(qv_transfer_for_slices(&to, &from, numbers[n][0], numbers[n][1]), QV_OK);
        for (unsigned i = 0; i < 6; i++)
            assert_int_equal(to.rgba[i][3], expected[n][i]);
    }
}

static void S81_histogram(void **state)
{
    static const uint32_t histogram[256] = {5, 7, 1000, 8, 3, 12, UINT32_MAX, 2, 1, 6, 40, 50000};
    static const uint16_t with[14] = {15968, 13207, 3720, 12359, 12359, 64, 64,
                                      64,    37077, 8196, 64,    64,    64, 65535};
    static const uint16_t without[14] = {16, 13,    4,  12, 23, 10,    1,
                                         37, 65535, 14, 7,  2,  65535, 65535};
    qv_transfer table;
    (void)state;
    assert_int_equal(qv_transfer_from_histogram(&table, histogram, (uint32_t)100 << 16, 50000, 64),
                     QV_OK);
    for (unsigned v = 0; v < 256; v++)
        assert_int_equal(table.rgba[v][3], with[v < 13 ? v : 13]);
    assert_int_equal(qv_transfer_from_histogram(&table, histogram, 6553, 0, 64), QV_OK);
    for (unsigned v = 0; v < 256; v++)
        assert_int_equal(table.rgba[v][3], without[v < 13 ? v : 13]);
}

static void check_entry(const uint8_t *table, unsigned v, unsigned p, const uint8_t expected[4])
{
    assert_memory_equal(&table[4 * (256 * p + v)], expected, 4);
}

static void S82_entries(void **state)
{
    static const uint8_t fog[2][4] = {{1, 1, 0, 1}, {2, 1, 0, 2}};
    static const uint8_t full[3][4] = {{191, 117, 1, 191}, {192, 117, 1, 192}, {255, 156, 1, 255}};
    static uint8_t table[1024 * 5];
    qv_dither dither = {.period = 5, .slope = {49152, 0}};
    qv_transfer transfer = {{{0}}};
    (void)state;
    for (unsigned v = 0; v < 4; v++) {
        const uint16_t rgba[4] = {65535, 40000, 300, v == 3 ? 65535 : 400};
        for (unsigned c = 0; c < 4; c++)
            transfer.rgba[v][c] = rgba[c];
    }
    assert_int_equal(qv_dither_table_build(table, sizeof table, 4, &dither, &transfer, 0, 256),
                     QV_OK);
    for (unsigned p = 0; p < 5; p++) {
        for (unsigned v = 0; v < 3; v++)
            check_entry(table, v, p, fog[p + v == 4]);
        check_entry(table, 3, p, full[p == 1]);
    }
    dither.cutoff = 1;
    assert_int_equal(qv_dither_table_build(table, sizeof table, 4, &dither, &transfer, 0, 256),
                     QV_OK);
    for (unsigned p = 0; p < 5; p++) {
        for (unsigned v = 0; v < 3; v++)
            check_entry(table, v, p, fog[1]);
        check_entry(table, 3, p, full[2]);
    }
}

static void S83_places(void **state)
{
    static const struct {
        uint8_t period, place;
        int32_t slice;
        uint32_t frame;
        int32_t x, y;
    } examples[] = {{7, 2, 0, 0, 0, 0},
                    {7, 5, 3, 5, 11, -2},
                    {32, 11, -1000, 1, 640, 479},
                    {64, 43, 4194303, UINT32_MAX, -1, -1},
                    {2, 1, -5, 3, 1, 0}};
    (void)state;
    for (unsigned i = 0; i < COUNT(examples); i++)
        assert_int_equal(qv_dither_table_place(examples[i].period, examples[i].slice,
                                               examples[i].frame, examples[i].x, examples[i].y),
                         examples[i].place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S80_number_of_slices),
        cmocka_unit_test(S81_histogram),
        cmocka_unit_test(S82_entries),
        cmocka_unit_test(S83_places),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
