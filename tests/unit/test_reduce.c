/*
 * Reduction by whole factors against means in real numbers.
 */
#include "check.h"
#include "classify_reference.h"
#include "qvol.h"
#include "random.h"

#include <string.h>

#define VALUES 4096

/* Scalars that fill `memory` from its start, x fastest. */
static qv_scalars packed(void *memory, uint8_t type, uint16_t x, uint16_t y, uint16_t z)
{
    const int32_t bytes = type == QV_SCALAR_U8 ? 1 : 2;
    qv_scalars s;

    memset(&s, 0, sizeof s);
    s.values = (qv_address)memory;
    s.type = type;
    s.size[0] = x;
    s.size[1] = y;
    s.size[2] = z;
    s.stride[0] = bytes;
    s.stride[1] = bytes * x;
    s.stride[2] = bytes * x * y;
    s.values_bytes = (uint64_t)x * y * z * (uint64_t)bytes;
    return s;
}

static void fill(uint16_t *values, uint32_t *seed)
{
    for (unsigned i = 0; i < VALUES; i++)
        values[i] = (uint16_t)random_next(seed);
}

/* Packed scalars that a reduction by these factors writes. */
static qv_scalars reduced(void *memory, const qv_scalars *s, const uint8_t factor[3])
{
    return packed(memory, s->type, (uint16_t)((s->size[0] + factor[0] - 1) / factor[0]),
                  (uint16_t)((s->size[1] + factor[1] - 1) / factor[1]),
                  (uint16_t)((s->size[2] + factor[2] - 1) / factor[2]));
}

static void expect_means(const qv_scalars *source, const qv_scalars *result,
                         const uint8_t factor[3])
{
    for (int z = 0; z < result->size[2]; z++)
        for (int y = 0; y < result->size[1]; y++)
            for (int x = 0; x < result->size[0]; x++) {
                double expected = ref_nearest(ref_mean(source, factor, x, y, z));
                double actual = ref_scalar(result, x, y, z);
                if (actual != expected)
                    fail_msg("(%d, %d, %d): %f, not %f", x, y, z, actual, expected);
            }
}

static void expect_reduced(const qv_scalars *source, const uint8_t factor[3])
{
    static uint16_t memory[VALUES + 1];
    qv_scalars result = reduced(memory, source, factor);
    size_t bytes = (size_t)result.values_bytes;
    unsigned char *after = (unsigned char *)memory + bytes;

    memset(memory, 0xA5, sizeof memory);
    assert_int_equal(qv_reduce(memory, bytes, source, factor, 0, result.size[2]), QV_OK);
    expect_means(source, &result, factor);
    assert_int_equal(*after, 0xA5);
}

/* Sizes 1 .. 9 by factors 1 .. 5 and 64, in all types. */
static void means_of_small_volumes(void **state)
{
    static const uint8_t types[3] = {QV_SCALAR_U8, QV_SCALAR_U16, QV_SCALAR_S16};
    static uint16_t values[VALUES];
    uint32_t seed = 3;
    (void)state;

    for (unsigned round = 0; round < 3000; round++) {
        uint16_t size[3];
        uint8_t factor[3];
        for (unsigned a = 0; a < 3; a++) {
            size[a] = (uint16_t)(1 + random_below(&seed, 9));
            factor[a] = (uint8_t)(1 + random_below(&seed, 6));
            factor[a] = factor[a] == 6 ? 64 : factor[a];
        }
        if (round % 64 == 0)
            fill(values, &seed);
        qv_scalars s = packed(values, types[round % 3], size[0], size[1], size[2]);
        expect_reduced(&s, factor);
    }
}

static void ties_go_upwards(void **state)
{
    static int16_t values[4] = {-3, -2, 2, 3};
    int16_t result[2];
    const uint8_t factor[3] = {2, 1, 1};
    qv_scalars s = packed(values, QV_SCALAR_S16, 4, 1, 1);
    (void)state;

    assert_int_equal(qv_reduce(result, sizeof result, &s, factor, 0, 1), QV_OK);
    assert_int_equal(result[0], -2); /* -2.5 */
    assert_int_equal(result[1], 3);  /* 2.5 */
}

/* The sum of 64^3 values of 65535 needs 34 bits. */
static void largest_box_of_greatest_values(void **state)
{
    static uint16_t values[64 * 64 * 64];
    const uint8_t factor[3] = {64, 64, 64};
    qv_scalars s = packed(values, QV_SCALAR_U16, 64, 64, 64);
    uint16_t result;
    (void)state;

    memset(values, 0xFF, sizeof values);
    assert_int_equal(qv_reduce(&result, sizeof result, &s, factor, 0, 1), QV_OK);
    assert_int_equal(result, 65535);
    for (unsigned i = 0; i < 64 * 64 * 32; i++)
        values[i] = 0;
    assert_int_equal(qv_reduce(&result, sizeof result, &s, factor, 0, 1), QV_OK);
    assert_int_equal(result, 32768); /* 32767.5 */
    values[64 * 64 * 64 - 1]--;
    assert_int_equal(qv_reduce(&result, sizeof result, &s, factor, 0, 1), QV_OK);
    assert_int_equal(result, 32767);
    s.type = QV_SCALAR_S16;
    for (unsigned i = 0; i < 64 * 64 * 64; i++)
        values[i] = 0x8000;
    assert_int_equal(qv_reduce(&result, sizeof result, &s, factor, 0, 1), QV_OK);
    assert_int_equal(result, 0x8000);
}

static void strips_equal_the_whole(void **state)
{
    static uint16_t values[VALUES];
    uint16_t whole[4 * 3 * 5], strips[4 * 3 * 5];
    const uint8_t factor[3] = {3, 2, 2};
    const unsigned slice = 4 * 3;
    qv_scalars s = packed(values, QV_SCALAR_U16, 11, 5, 9);
    uint32_t seed = 11;
    (void)state;

    fill(values, &seed);
    assert_int_equal(qv_reduce(whole, sizeof whole, &s, factor, 0, 5), QV_OK);
    for (uint16_t z = 0; z < 5; z++)
        assert_int_equal(qv_reduce(&strips[z * slice], slice * 2, &s, factor, z, (uint16_t)(z + 1)),
                         QV_OK);
    assert_memory_equal(whole, strips, sizeof whole);
}

/* The same values read backwards, with gaps, and with z fastest. */
static void strides_of_any_sign_and_order(void **state)
{
    static uint16_t values[VALUES];
    const uint8_t factor[3] = {2, 3, 2};
    qv_scalars s = packed(values, QV_SCALAR_S16, 7, 6, 5);
    uint32_t seed = 13;
    (void)state;

    fill(values, &seed);
    s.values = (qv_address)&values[7 * 6 * 5 - 1];
    for (unsigned a = 0; a < 3; a++)
        s.stride[a] = -s.stride[a];
    expect_reduced(&s, factor);

    s.values = (qv_address)&values[3 * 40];
    s.stride[0] = 100;
    s.stride[1] = 700;
    s.stride[2] = -20;
    s.values_bytes = sizeof values;
    expect_reduced(&s, factor);
}

static void axes_of_one_value_have_no_stride(void **state)
{
    uint16_t values[3] = {1, 2, 9};
    const uint8_t factor[3] = {3, 1, 1};
    uint16_t result = 0;
    qv_scalars s = packed(values, QV_SCALAR_U16, 3, 1, 1);
    (void)state;

    s.stride[1] = INT32_MIN;
    s.stride[2] = 1;
    assert_int_equal(qv_reduce(&result, sizeof result, &s, factor, 0, 1), QV_OK);
    assert_int_equal(result, 4);
}

static uint16_t untouched[64];

static void expect_refused(const qv_scalars *s, const uint8_t factor[3], uint16_t first_z,
                           uint16_t end_z, size_t bytes, qv_status expected)
{
    uint16_t before[64];

    memset(untouched, 0x3C, sizeof untouched);
    memset(before, 0x3C, sizeof before);
    assert_int_equal(qv_reduce(untouched, bytes, s, factor, first_z, end_z), expected);
    assert_memory_equal(untouched, before, sizeof before);
}

static void bad_arguments_are_refused(void **state)
{
    static uint16_t values[64];
    const uint8_t factor[3] = {1, 2, 1};
    const uint8_t bad_factors[6][3] = {{0, 1, 1},  {1, 0, 1},  {1, 1, 0},
                                       {65, 1, 1}, {1, 65, 1}, {1, 1, 255}};
    const qv_scalars good = packed(values, QV_SCALAR_U16, 4, 3, 4);
    const size_t bytes = 4 * 2 * 4 * 2;
    (void)state;

    assert_int_equal(qv_reduce(NULL, bytes, &good, factor, 0, 4), QV_ERROR_NULL);
    expect_refused(NULL, factor, 0, 4, bytes, QV_ERROR_NULL);
    expect_refused(&good, NULL, 0, 4, bytes, QV_ERROR_NULL);
    for (unsigned i = 0; i < 6; i++)
        expect_refused(&good, bad_factors[i], 0, 1, bytes, QV_ERROR_SIZE);
    expect_refused(&good, factor, 2, 2, bytes, QV_ERROR_SIZE);
    expect_refused(&good, factor, 3, 2, bytes, QV_ERROR_SIZE);
    expect_refused(&good, factor, 0, 5, bytes, QV_ERROR_SIZE);
    expect_refused(&good, factor, 0, 4, bytes - 1, QV_ERROR_BUFFER);
    expect_refused(&good, factor, 0, 4, 0, QV_ERROR_BUFFER);
    assert_int_equal(qv_reduce(untouched, bytes, &good, factor, 0, 4), QV_OK);
}

static void bad_scalars_are_refused(void **state)
{
    static uint16_t values[64];
    const uint8_t factor[3] = {1, 1, 1};
    const qv_scalars good = packed(values, QV_SCALAR_U16, 4, 3, 4);
    qv_scalars bad = good;
    (void)state;

    bad.values = NULL;
    expect_refused(&bad, factor, 0, 4, sizeof untouched, QV_ERROR_NULL);
    bad = good;
    bad.type = 0;
    expect_refused(&bad, factor, 0, 4, sizeof untouched, QV_ERROR_STORAGE);
    bad.type = QV_SCALAR_S16 + 1;
    expect_refused(&bad, factor, 0, 4, sizeof untouched, QV_ERROR_STORAGE);
    bad = good;
    bad.size[1] = 0;
    expect_refused(&bad, factor, 0, 4, sizeof untouched, QV_ERROR_SIZE);
    bad.size[1] = QV_AXIS_MAX + 1;
    expect_refused(&bad, factor, 0, 4, sizeof untouched, QV_ERROR_SIZE);
    bad = good;
    bad.stride[0] = 1;
    expect_refused(&bad, factor, 0, 4, sizeof untouched, QV_ERROR_STRIDE);
    bad = good;
    bad.stride[2] += 1;
    bad.values_bytes += 8;
    expect_refused(&bad, factor, 0, 4, sizeof untouched, QV_ERROR_STRIDE);
    bad = good;
    bad.values_bytes -= 1;
    expect_refused(&bad, factor, 0, 4, sizeof untouched, QV_ERROR_STRIDE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(means_of_small_volumes),
        cmocka_unit_test(ties_go_upwards),
        cmocka_unit_test(largest_box_of_greatest_values),
        cmocka_unit_test(strips_equal_the_whole),
        cmocka_unit_test(strides_of_any_sign_and_order),
        cmocka_unit_test(axes_of_one_value_have_no_stride),
        cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(bad_scalars_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
