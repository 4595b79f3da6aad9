/*
 * Temporal dither tables: the mean over a period, the turn between neighbours, table 3 of
 * Williams et al., weighted colours, and the places that pixels read.
 */
#include "check.h"
#include "qvol.h"
#include "random.h"

#include <math.h>
#include <string.h>

#define PERIOD_MOST 64

static uint8_t bytes[1024 * PERIOD_MOST];

/* Builds at `bytes`, in parts that end anywhere. */
static void build(const qv_dither *dither, const qv_transfer *transfer, uint8_t entry_bytes)
{
    const uint16_t ends[] = {1, 100, 255, 256};
    const uint32_t size = qv_dither_table_bytes(dither->period, entry_bytes);
    uint16_t first = 0;
    memset(bytes, 0xEE, sizeof bytes);
    for (unsigned i = 0; i < 4; i++) {
        assert_int_equal(
            qv_dither_table_build(bytes, size, entry_bytes, dither, transfer, first, ends[i]),
            QV_OK);
        first = ends[i];
    }
}

/* Transfer functions that hold opacities first, first + 1 ... of 16 bits, random colours. */
static void fill(qv_transfer *transfer, uint32_t first, uint32_t step)
{
    uint32_t seed = first + 1;
    for (uint32_t v = 0; v < 256; v++) {
        for (unsigned c = 0; c < 3; c++)
            transfer->rgba[v][c] = (uint16_t)random_next(&seed);
        transfer->rgba[v][3] = (uint16_t)(first + step * v);
    }
}

static void sizes(void **state)
{
    (void)state;
    assert_int_equal(qv_dither_table_bytes(2, 1), 512);
    assert_int_equal(qv_dither_table_bytes(64, 4), 65536);
    assert_int_equal(qv_dither_table_bytes(1, 1), 0);
    assert_int_equal(qv_dither_table_bytes(65, 1), 0);
    assert_int_equal(qv_dither_table_bytes(8, 2), 0);
    assert_int_equal(qv_dither_table_bytes(8, 0), 0);
}

/* The mean over a period is the opacity times the slope to 1 / (2 P), in levels; all entries are
   its floor or 1 more. */
static void check_means(const qv_dither *dither, const qv_transfer *transfer, double slope)
{
    const uint32_t period = dither->period;
    for (uint32_t v = 0; v < 256; v++) {
        const double wanted = fmin(255, slope * transfer->rgba[v][3] / 257.0);
        uint32_t sum = 0;
        for (uint32_t p = 0; p < period; p++) {
            const uint8_t opacity = bytes[256 * p + v];
            assert_true(opacity > wanted - 1.0001 && opacity < wanted + 1.0001);
            sum += opacity;
        }
        assert_true(fabs((double)sum / period - wanted) <= .5 / period + .0001);
    }
}

static void means(void **state)
{
    static const uint32_t slopes[] = {0, 49152, 65536, 100000, 1 << 20};
    (void)state;
    for (uint8_t period = 2; period <= PERIOD_MOST; period++) {
        const uint32_t slope = slopes[period % 5];
        const qv_dither dither = {.period = period, .slope = {slope, 7}};
        for (uint32_t step = 1; step <= 257; step += 32) {
            qv_transfer transfer;
            fill(&transfer, period, step);
            build(&dither, &transfer, 1);
            check_means(&dither, &transfer, slope == 0 ? 1 : slope / 65536.0);
        }
    }
}

/* While no more than half of a period's slices hit, no two equal neighbours do together. */
static void equal_neighbours_never_hit_together(void **state)
{
    (void)state;
    for (uint8_t period = 2; period <= PERIOD_MOST; period++)
        for (uint32_t hits = 0; 2 * hits <= period; hits++) {
            const qv_dither dither = {.period = period};
            qv_transfer transfer;
            fill(&transfer, (257 * hits + period / 2) / period, 0);
            build(&dither, &transfer, 1);
            for (uint32_t p = 0; p < period; p++)
                for (uint32_t v = 0; v < 255; v++)
                    assert_true(bytes[256 * p + v] + bytes[256 * p + v + 1] < 2);
        }
}

/* Table 3, period 8 and cutoff 3: its values 1 .. 4 are those of values 10 .. 13 here. */
static void table_3(void **state)
{
    static const uint8_t rows[][8] = {
        {0, 1, 0, 0, 0, 1, 0, 0}, /* opacity .25 */
        {1, 0, 0, 0, 1, 0, 0, 0},
        {0, 0, 0, 1, 0, 0, 0, 1},
        {28, 28, 28, 28, 28, 28, 28, 28},
    };
    const qv_dither dither = {.period = 8, .cutoff = 3};
    qv_transfer transfer;
    (void)state;
    fill(&transfer, 64, 0);
    transfer.rgba[13][3] = 28 * 257 - 100;
    build(&dither, &transfer, 1);
    for (unsigned i = 0; i < 4; i++)
        for (unsigned p = 0; p < 8; p++)
            assert_int_equal(bytes[256 * p + 10 + i], rows[i][p]);
}

static void cutoff(void **state)
{
    const qv_dither dither = {.period = 16, .slope = {32768, 0}, .cutoff = 3};
    qv_transfer transfer;
    (void)state;
    fill(&transfer, 3 * 257, 0);
    transfer.rgba[7][3] = 3 * 257 + 1;
    transfer.rgba[8][3] = 65535;
    build(&dither, &transfer, 1);
    for (uint32_t p = 0; p < 16; p++) {
        assert_in_range(bytes[256 * p + 6], 1, 2);
        assert_int_equal(bytes[256 * p + 7], 3);
        assert_int_equal(bytes[256 * p + 8], 255);
    }
}

/* The fourth byte is the entry of the smaller table. */
static void colours_are_weighted(void **state)
{
    static uint8_t alone[256 * PERIOD_MOST];
    const qv_dither dither = {.period = 37};
    (void)state;
    for (uint32_t step = 3; step <= 257; step += 127) {
        qv_transfer transfer;
        fill(&transfer, 0, step);
        build(&dither, &transfer, 1);
        memcpy(alone, bytes, sizeof alone);
        build(&dither, &transfer, 4);
        for (uint32_t entry = 0; entry < 256 * 37; entry++) {
            const uint16_t *rgba = transfer.rgba[entry % 256];
            const uint8_t *at = &bytes[4 * entry], opacity = alone[entry];
            assert_int_equal(at[3], opacity);
            for (unsigned c = 0; c < 3; c++)
                assert_true(fabs(at[c] - rgba[c] / 65535.0 * opacity) <= .5);
        }
    }
}

/* The values of a part and nothing else. */
static void parts_write_no_more(void **state)
{
    const qv_dither dither = {.period = 5};
    qv_transfer transfer;
    (void)state;
    fill(&transfer, 0, 257);
    memset(bytes, 0xEE, sizeof bytes);
    assert_int_equal(qv_dither_table_build(bytes, 5120, 4, &dither, &transfer, 30, 32), QV_OK);
    for (uint32_t i = 0; i < sizeof bytes; i++) {
        const uint32_t value = i / 4 % 256;
        assert_int_equal(i < 5120 && (value == 30 || value == 31), bytes[i] != 0xEE);
    }
}

static void refuse(void *to, size_t size, uint8_t entry_bytes, const qv_dither *dither,
                   const qv_transfer *transfer, uint16_t first, uint16_t end, qv_status expected)
{
    assert_int_equal(qv_dither_table_build(to, size, entry_bytes, dither, transfer, first, end),
                     expected);
    for (size_t i = 0; i < sizeof bytes; i++)
        assert_int_equal(bytes[i], 0xEE);
}

static void bad_tables_are_refused(void **state)
{
    const qv_dither good = {.period = 4, .slope = {1 << 20, 0}};
    qv_dither bad[3] = {good, good, good};
    qv_transfer transfer;
    (void)state;
    bad[0].period = 1;
    bad[1].period = 65;
    bad[2].slope[0]++;
    fill(&transfer, 0, 257);
    memset(bytes, 0xEE, sizeof bytes);
    refuse(NULL, 1024, 1, &good, &transfer, 0, 256, QV_ERROR_NULL);
    refuse(bytes, 1024, 1, NULL, &transfer, 0, 256, QV_ERROR_NULL);
    refuse(bytes, 1024, 1, &good, NULL, 0, 256, QV_ERROR_NULL);
    refuse(bytes, 4096, 3, &good, &transfer, 0, 256, QV_ERROR_SIZE);
    refuse(bytes, 1024, 1, &good, &transfer, 9, 9, QV_ERROR_SIZE);
    refuse(bytes, 1024, 1, &good, &transfer, 0, 257, QV_ERROR_SIZE);
    for (unsigned i = 0; i < 3; i++)
        refuse(bytes, sizeof bytes, 1, &bad[i], &transfer, 0, 256, QV_ERROR_DITHER);
    refuse(bytes, 1023, 1, &good, &transfer, 0, 256, QV_ERROR_BUFFER);
    refuse(bytes, 4095, 4, &good, &transfer, 0, 1, QV_ERROR_BUFFER);
}

/* ---- Places --------------------------------------------------------------- */

/* From slice to slice the next place, at both ends too. */
static void slices_take_places_in_turn(void **state)
{
    static const int32_t firsts[] = {-(1 << 22), -100, 0, (1 << 22) - 200};
    (void)state;
    for (uint8_t period = 2; period <= PERIOD_MOST; period++)
        for (unsigned i = 0; i < 4; i++)
            for (int32_t k = firsts[i]; k < firsts[i] + 199; k++) {
                const uint8_t place = qv_dither_table_place(period, k, 3, -5, 7);
                assert_int_equal(qv_dither_table_place(period, k - 1, 3, -5, 7),
                                 (place + 1) % period);
            }
    assert_int_equal(qv_dither_table_place(64, 1 << 22, 0, 0, 0), 0);
    assert_int_equal(qv_dither_table_place(1, 5, 0, 3, 0), 0);
    assert_int_equal(qv_dither_table_place(65, 5, 0, 3, 0), 0);
}

/* Over 64 x 64 pixels, or as many frames, each place as often as any other within a third. */
static void places_spread(void **state)
{
    (void)state;
    for (uint8_t period = 2; period <= PERIOD_MOST; period++) {
        uint32_t pixels[PERIOD_MOST] = {0}, frames[PERIOD_MOST] = {0};
        for (int32_t i = 0; i < 4096; i++) {
            pixels[qv_dither_table_place(period, 11, 5, i % 64 - 10, i / 64)]++;
            frames[qv_dither_table_place(period, 11, (uint32_t)i, 8, 9)]++;
        }
        for (uint32_t p = 0; p < period; p++) {
            assert_true(fabs(pixels[p] * period / 4096.0 - 1) < .34);
            assert_true(fabs(frames[p] * period / 4096.0 - 1) < .1);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sizes),
        cmocka_unit_test(means),
        cmocka_unit_test(equal_neighbours_never_hit_together),
        cmocka_unit_test(table_3),
        cmocka_unit_test(cutoff),
        cmocka_unit_test(colours_are_weighted),
        cmocka_unit_test(parts_write_no_more),
        cmocka_unit_test(bad_tables_are_refused),
        cmocka_unit_test(slices_take_places_in_turn),
        cmocka_unit_test(places_spread),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
