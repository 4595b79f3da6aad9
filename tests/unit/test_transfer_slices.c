/*
 * Equation 3 for the opacities of a table, against the mathematics library.
 */
#include "check.h"
#include "qvol.h"
#include "random.h"

#include <math.h>

static void fill_random(void *bytes, size_t size, uint32_t seed)
{
    uint8_t *at = bytes;
    while (size-- > 0)
        *at++ = (uint8_t)random_next(&seed);
}

static void opacities_for_slices(void **state)
{
    (void)state;
    assert_int_equal(qv_opacity_for_slices(0x12345678, 128, 600), 0x3FF40C8);
    assert_int_equal(qv_opacity_for_slices(0, 1, 1000), 0);
    assert_int_equal(qv_opacity_for_slices(0xFFFFFFFFu, 1, 1000), 0xFFFFFFFFu);
    assert_int_equal(qv_opacity_for_slices(77777, 0, 2), qv_opacity_for_slices(77777, 1, 2));
    assert_int_equal(qv_opacity_for_slices(77777, 2, 0), qv_opacity_for_slices(77777, 2, 1));
}

/* Every opacity of 16 bits, within the bound of the declaration. */
static void check_table_for_slices(uint16_t slices, uint16_t wanted)
{
    const double ratio = (double)slices / wanted, bound = .5 + (ratio + 1) / 4096;
    for (uint32_t base = 0; base < 65536; base += QV_PALETTE_ENTRIES) {
        qv_transfer from, to;
        fill_random(&from, sizeof from, base + 1);
        for (uint32_t v = 0; v < QV_PALETTE_ENTRIES; v++)
            from.rgba[v][3] = (uint16_t)(base + v);
        assert_int_equal(qv_transfer_for_slices(&to, &from, slices, wanted), QV_OK);
        for (uint32_t v = 0; v < QV_PALETTE_ENTRIES; v++) {
            const double exact = -65535 * expm1(ratio * log1p((base + v) / -65535.0));
            assert_true(fabs(to.rgba[v][3] - exact) <= bound);
            assert_memory_equal(to.rgba[v], from.rgba[v], 3 * sizeof from.rgba[v][0]);
        }
    }
}

static void tables_for_slices(void **state)
{
    static const uint16_t numbers[][2] = {{128, 275}, {128, 600}, {128, 128}, {1, 65535},
                                          {600, 128}, {1000, 10}, {65535, 1}};
    (void)state;
    for (unsigned i = 0; i < sizeof numbers / sizeof *numbers; i++)
        check_table_for_slices(numbers[i][0], numbers[i][1]);
}

static void a_table_may_replace_itself(void **state)
{
    qv_transfer from, to;
    (void)state;
    fill_random(&from, sizeof from, 5);
    assert_int_equal(qv_transfer_for_slices(&to, &from, 7, 3), QV_OK);
    assert_int_equal(qv_transfer_for_slices(&from, &from, 7, 3), QV_OK);
    assert_memory_equal(&from, &to, sizeof to);
}

static void bad_numbers_of_slices(void **state)
{
    qv_transfer from, to, before;
    (void)state;
    fill_random(&from, sizeof from, 5);
    fill_random(&to, sizeof to, 6);
    before = to;
    assert_int_equal(qv_transfer_for_slices(NULL, &from, 1, 2), QV_ERROR_NULL);
    assert_int_equal(qv_transfer_for_slices(&to, NULL, 1, 2), QV_ERROR_NULL);
    assert_int_equal(qv_transfer_for_slices(&to, &from, 0, 2), QV_ERROR_SLICE);
    assert_int_equal(qv_transfer_for_slices(&to, &from, 1, 0), QV_ERROR_SLICE);
    assert_memory_equal(&to, &before, sizeof to);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(opacities_for_slices),
        cmocka_unit_test(tables_for_slices),
        cmocka_unit_test(a_table_may_replace_itself),
        cmocka_unit_test(bad_numbers_of_slices),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
