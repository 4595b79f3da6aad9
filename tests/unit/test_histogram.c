/*
 * Opacities from a histogram: equation 12 and its rules of peaks, against the mathematics
 * library.
 */
#include "check.h"
#include "qvol.h"
#include "random.h"

#include <math.h>
#include <string.h>

static void fill_random(void *bytes, size_t size, uint32_t seed)
{
    uint8_t *at = bytes;
    while (size-- > 0)
        *at++ = (uint8_t)random_next(&seed);
}

/* Equation 12 in 16 bits. */
static double exact_opacity(double count, double scale)
{
    return count <= 1 ? 65535 : fmin(65535, scale * 257 / log(count));
}

static uint32_t scale_of(double levels)
{
    return (uint32_t)(levels * 65536);
}

/* Counts of every size, 256 a table, without peaks. */
static void opacities_of_counts(void **state)
{
    static const double scales[] = {1e-4, .5, 1, 100, 255, 65535.9};
    (void)state;
    for (unsigned i = 0; i < sizeof scales / sizeof *scales; i++) {
        uint32_t histogram[256];
        double next = 0;
        while (next < 4294967295.0) {
            qv_transfer table;
            for (unsigned v = 0; v < 256; v++) {
                histogram[v] = (uint32_t)fmin(next, 4294967295.0);
                next += 1 + next / 300;
            }
            const uint32_t scale = scale_of(scales[i]);
            assert_int_equal(qv_transfer_from_histogram(&table, histogram, scale, 0, 9), QV_OK);
            for (unsigned v = 0; v < 256; v++)
                assert_true(fabs(table.rgba[v][3] - exact_opacity(histogram[v], scale / 65536.0)) <
                            .51);
        }
    }
}

/* As in figure 41: bin 2 is one peak and bin 11 another. */
static void peaks_are_straddled(void **state)
{
    static const uint32_t counts[16] = {100, 7000,  90001, 6000,  41,   50, 60, 70,
                                        80,  12345, 8000,  70000, 5000, 30, 20, 10};
    static const double expected[16] = {3550, 0,     0, 0, 3021, 50,   60, 70,
                                        80,   10173, 0, 0, 0,    2515, 20, 10};
    uint32_t histogram[256] = {0};
    qv_transfer table, before;
    (void)state;
    memcpy(histogram, counts, sizeof counts);
    fill_random(&table, sizeof table, 1);
    before = table;
    assert_int_equal(qv_transfer_from_histogram(&table, histogram, 100 << 16, 70000, 64), QV_OK);
    for (unsigned v = 0; v < 16; v++)
        if (expected[v] == 0)
            assert_int_equal(table.rgba[v][3], 64);
        else
            assert_true(fabs(table.rgba[v][3] - exact_opacity(expected[v], 100)) < .51);
    for (unsigned v = 16; v < 256; v++)
        assert_int_equal(table.rgba[v][3], 65535);
    for (unsigned v = 0; v < 256; v++)
        assert_memory_equal(table.rgba[v], before.rgba[v], 3 * sizeof before.rgba[v][0]);
}

/* Peaks at both ends; a bin between two peaks goes by three counts, the greatest there are. */
static void peaks_at_ends_and_close(void **state)
{
    uint32_t histogram[256];
    qv_transfer table;
    (void)state;
    for (unsigned v = 0; v < 256; v++)
        histogram[v] = 1000;
    histogram[0] = histogram[255] = histogram[100] = histogram[104] = UINT32_MAX;
    histogram[101] = histogram[102] = histogram[103] = UINT32_MAX - 1;
    assert_int_equal(qv_transfer_from_histogram(&table, histogram, 20 << 16, UINT32_MAX, 12345),
                     QV_OK);
    for (unsigned v = 0; v < 256; v++) {
        const int beside = v < 2 || v > 253 || (v >= 99 && v <= 105 && v != 102);
        const double count = v == 102 ? UINT32_MAX - 1 : 1000;
        if (beside)
            assert_int_equal(table.rgba[v][3], 12345);
        else
            assert_true(fabs(table.rgba[v][3] - exact_opacity(count, 20)) < .51);
    }
}

/* The mean of 1 and 2, which rounds up; and peaks of one count. */
static void means_of_small_counts(void **state)
{
    uint32_t histogram[256] = {0};
    qv_transfer table;
    (void)state;
    histogram[10] = 5;
    histogram[11] = 1;
    histogram[12] = 2;
    histogram[13] = 3;
    assert_int_equal(qv_transfer_from_histogram(&table, histogram, 1 << 16, 5, 3), QV_OK);
    assert_int_equal(table.rgba[8][3], 65535);
    assert_int_equal(table.rgba[11][3], 3);
    assert_true(fabs(table.rgba[12][3] - exact_opacity(2, 1)) < .51);
    assert_true(fabs(table.rgba[13][3] - exact_opacity(3, 1)) < .51);
    assert_int_equal(qv_transfer_from_histogram(&table, histogram, 1 << 16, 1, 3), QV_OK);
    assert_int_equal(table.rgba[10][3], 3);
}

static void null_histograms(void **state)
{
    const uint32_t histogram[256] = {0};
    qv_transfer table, before;
    (void)state;
    fill_random(&table, sizeof table, 1);
    before = table;
    assert_int_equal(qv_transfer_from_histogram(NULL, histogram, 1, 1, 1), QV_ERROR_NULL);
    assert_int_equal(qv_transfer_from_histogram(&table, NULL, 1, 1, 1), QV_ERROR_NULL);
    assert_memory_equal(&table, &before, sizeof table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(opacities_of_counts),     cmocka_unit_test(peaks_are_straddled),
        cmocka_unit_test(peaks_at_ends_and_close), cmocka_unit_test(means_of_small_counts),
        cmocka_unit_test(null_histograms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
