/*
 * Associated entries: every colour and opacity of 8 bits, those of 16 bits where rounding turns, and
 * what is refused.
 */
#include "check.h"
#include "qvol.h"

#include <string.h>

enum { LEVELS = 256, WIDE_FULL = 65535 };

static uint8_t narrow[LEVELS][4], result[LEVELS][4];
static uint16_t wide[LEVELS][4];

/* The nearest level to a product of two numbers of which `full` is 1; there are no ties. */
static unsigned nearest(uint64_t colour, uint64_t opacity, uint64_t full)
{
    return (unsigned)((2 * 255 * colour * opacity + full * full) / (2 * full * full));
}

static void every_entry_of_8_bits(void **state)
{
    const qv_entries all = {narrow[0], LEVELS, 0, 0, QV_STORAGE_RGBA8};
    (void)state;
    for (unsigned opacity = 0; opacity < LEVELS; opacity++) {
        for (unsigned i = 0; i < LEVELS; i++) {
            const uint8_t entry[4] = {(uint8_t)i, (uint8_t)(255 - i), (uint8_t)(i / 2),
                                      (uint8_t)opacity};
            memcpy(narrow[i], entry, sizeof entry);
        }
        assert_int_equal(qv_opacity_to_associated(result, sizeof result, &all), QV_OK);
        for (unsigned i = 0; i < LEVELS; i++) {
            for (unsigned c = 0; c < 3; c++)
                assert_int_equal(result[i][c], nearest(narrow[i][c], opacity, 255));
            assert_int_equal(result[i][3], opacity);
        }
    }
}

/* For each opacity looked at and each level: the colours on both sides of where it begins. */
static void entries_of_16_bits(void **state)
{
    const qv_entries all = {(qv_address)wide, LEVELS, 0, 0, QV_STORAGE_RGBA16};
    (void)state;
    for (unsigned opacity = 1; opacity <= WIDE_FULL; opacity += 31) {
        for (unsigned i = 0; i < LEVELS; i++) {
            uint64_t begins = ((2 * i - 1) * (uint64_t)WIDE_FULL * WIDE_FULL / 510) / opacity;
            uint16_t below = (uint16_t)(i == 0 || begins > WIDE_FULL ? WIDE_FULL : begins);
            const uint16_t entry[4] = {below, (uint16_t)(below < WIDE_FULL ? below + 1 : below),
                                       (uint16_t)(i * 257), (uint16_t)opacity};
            memcpy(wide[i], entry, sizeof entry);
        }
        assert_int_equal(qv_opacity_to_associated(result, sizeof result, &all), QV_OK);
        for (unsigned i = 0; i < LEVELS; i++) {
            for (unsigned c = 0; c < 3; c++) {
                assert_int_equal(result[i][c], nearest(wide[i][c], opacity, WIDE_FULL));
                assert_true(result[i][c] <= result[i][3]);
            }
            assert_int_equal(result[i][3], nearest(WIDE_FULL, opacity, WIDE_FULL));
        }
    }
}

static void the_source_may_be_overwritten(void **state)
{
    (void)state;
    for (unsigned i = 0; i < LEVELS; i++) {
        const uint16_t entry[4] = {(uint16_t)(i * 251), 40000, (uint16_t)(i * 7),
                                   (uint16_t)(i * 257)};
        memcpy(wide[i], entry, sizeof entry);
    }
    const qv_entries all = {(qv_address)wide, LEVELS, 0, 0, QV_STORAGE_RGBA16};
    assert_int_equal(qv_opacity_to_associated(result, sizeof result, &all), QV_OK);
    assert_int_equal(qv_opacity_to_associated(wide, sizeof result, &all), QV_OK);
    assert_memory_equal(wide, result, sizeof result);
}

static void refused(void **state)
{
    const qv_entries all = {narrow[0], LEVELS, 0, 0, QV_STORAGE_RGBA8};
    const qv_entries odd = {(qv_address)wide + 1, 1, 0, 0, QV_STORAGE_RGBA16};
    (void)state;
    memset(result, 0xA5, sizeof result);
    assert_int_equal(qv_opacity_to_associated(NULL, sizeof result, &all), QV_ERROR_NULL);
    assert_int_equal(qv_opacity_to_associated(result, sizeof result, NULL), QV_ERROR_NULL);
    assert_int_equal(qv_opacity_to_associated(result, sizeof result - 1, &all), QV_ERROR_BUFFER);
    assert_int_equal(qv_opacity_to_associated(result, sizeof result, &odd), QV_ERROR_STRIDE);
    for (unsigned storage = 0; storage <= QV_STORAGE_ASSOCIATED8 + 1; storage++) {
        qv_entries other = all;
        other.storage = (uint8_t)storage;
        if (storage != QV_STORAGE_RGBA8 && storage != QV_STORAGE_RGBA16)
            assert_int_equal(qv_opacity_to_associated(result, sizeof result, &other),
                             QV_ERROR_STORAGE);
    }
    for (unsigned i = 0; i < sizeof result; i++)
        assert_int_equal(((const uint8_t *)result)[i], 0xA5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_entry_of_8_bits),
        cmocka_unit_test(entries_of_16_bits),
        cmocka_unit_test(the_source_may_be_overwritten),
        cmocka_unit_test(refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
