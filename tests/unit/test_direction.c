/*
 * Directions of FreeVoxels: their numbers, sets and lengths; and what a voxel's depth along a
 * stretch is.
 */
#include "direction.h"
#include "check.h"
#include "fx_log.h"
#include "random.h"
#include "thickness.h"

#include <math.h>

static void numbers_and_steps(void **state)
{
    unsigned expected = 0;
    (void)state;
    for (int z = -1; z <= 1; z++)
        for (int y = -1; y <= 1; y++)
            for (int x = -1; x <= 1; x++) {
                int8_t step[3];
                if (x == 0 && y == 0 && z == 0)
                    continue;
                assert_int_equal(qv_direction(x, y, z), expected);
                assert_int_equal(qv_direction(-x, -y, -z), 25 - expected);
                qv_direction_step(step, (uint8_t)expected);
                assert_true(step[0] == x && step[1] == y && step[2] == z);
                expected++;
            }
    assert_int_equal(expected, QV_DIRECTIONS);
    assert_int_equal(qv_direction(0, 0, 0), 255);
    for (int axis = 0; axis < 3; axis++)
        for (int far = -2; far <= 2; far += 4)
            assert_int_equal(
                qv_direction(axis == 0 ? far : 1, axis == 1 ? far : 1, axis == 2 ? far : 0), 255);
}

static void sets(void **state)
{
    (void)state;
    assert_int_equal(qv_directions_count(0), 0);
    assert_int_equal(qv_directions_count(QV_DIRECTIONS_ALL), QV_DIRECTIONS);
    assert_int_equal(qv_directions_count(0xFFFFFFFFu), QV_DIRECTIONS);
    assert_int_equal(qv_directions_count(QV_DIRECTIONS_FACES), 6);
    for (uint8_t d = 0; d < QV_DIRECTIONS; d++) {
        int8_t step[3];
        qv_direction_step(step, d);
        const int face = step[0] * step[0] + step[1] * step[1] + step[2] * step[2] == 1;
        assert_int_equal(QV_DIRECTIONS_FACES >> d & 1u, face);
        assert_int_equal(qv_direction_slot(QV_DIRECTIONS_ALL, d), d);
        assert_int_equal(qv_direction_slot((uint32_t)1 << d, d), 0);
        assert_true(qv_directions_known((uint32_t)1 << d));
    }
    assert_int_equal(qv_direction_slot(QV_DIRECTIONS_FACES, 21), 5);
    assert_false(qv_directions_known(0));
    assert_false(qv_directions_known(QV_DIRECTIONS_ALL + 1u));
}

static void lengths_of_vectors(void **state)
{
    uint32_t random = 21;
    (void)state;
    for (unsigned i = 0; i < 300000; i++) {
        uint32_t v[3];
        double square = 0;
        for (unsigned axis = 0; axis < 3; axis++) {
            const uint32_t shift = random_below(&random, 32);
            v[axis] = (random_next(&random) >> 1) >> shift;
            square += (double)v[axis] * v[axis];
        }
        const double exact = sqrt(square);
        assert_true(fabs(qv_length_of(v) - exact) <= .5 + exact * ldexp(1, -27));
    }
    const uint32_t none[3] = {0, 0, 0}, most[3] = {1u << 31, 1u << 31, 1u << 31};
    assert_int_equal(qv_length_of(none), 0);
    assert_true(fabs(qv_length_of(most) - sqrt(3) * ldexp(1, 31)) < 32);
}

static void lengths_of_steps(void **state)
{
    static const uint32_t spacings[][3] = {
        {0, 0, 0}, {65536, 98304, 131072}, {4096, 16777216, 65536}, {16777216, 16777216, 16777216}};
    (void)state;
    for (unsigned s = 0; s < sizeof spacings / sizeof *spacings; s++)
        for (uint8_t d = 0; d < QV_DIRECTIONS; d++) {
            int8_t step[3];
            double square = 0;
            qv_direction_step(step, d);
            for (unsigned axis = 0; axis < 3; axis++) {
                const double side = spacings[s][axis] == 0 ? 1 : spacings[s][axis] / 65536.;
                square += step[axis] * step[axis] * side * side;
            }
            const double length = ldexp(qv_direction_length(spacings[s], d), -23);
            assert_true(fabs(length - sqrt(square)) <=
                        ldexp(1, -24) + sqrt(square) * ldexp(1, -27));
        }
}

/* ---- Depth of a voxel ------------------------------------------------------- */

static double depth_of(const qv_volume *volume, uint32_t length, uint32_t weight)
{
    qv_thickness thickness;
    assert_int_equal(qv_thickness_of(&thickness, volume, length), QV_OK);
    return ldexp((double)qv_thickness_depth(&thickness, weight), -32);
}

static void depth_of_opacity(void **state)
{
    static const uint32_t units[] = {1, 65536, 100000, 0x7FFFFFFFu, 0xFFFFFFFFu};
    qv_volume volume = {.storage = QV_STORAGE_RGBA16};
    uint32_t random = 22;
    (void)state;
    for (unsigned i = 0; i < 20000; i++) {
        volume.unit_distance = units[i % (sizeof units / sizeof *units)];
        const double scale = exp2((double)random_below(&random, 230) / 10 - 11.5);
        const double length = floor(scale * volume.unit_distance * 128);
        if (length < 1 || length > UINT32_MAX)
            continue;
        const uint32_t weight = random_next(&random) >> (2 + random_below(&random, 24));
        const double exact = ldexp(weight, -24) * length / (volume.unit_distance * 128.);
        const double depth = depth_of(&volume, (uint32_t)length, weight);
        assert_true(depth <= exact * (1 + ldexp(1, -26)));
        assert_true(depth >= exact * (1 - ldexp(1, -26)) - ldexp(1, -32));
    }
    volume.unit_distance = 0;
    assert_true(depth_of(&volume, 12345, FX_OPAQUE) == 64);
    assert_true(depth_of(&volume, 0xFFFFFFFFu, 1u << 24) == 1);
}

static void depth_of_extinction(void **state)
{
    qv_volume volume = {.storage = QV_STORAGE_RGBT8, .unit_distance = 77};
    uint32_t random = 23;
    (void)state;
    for (unsigned i = 0; i < 20000; i++) {
        volume.extinction = 1u + (random_next(&random) >> random_below(&random, 32));
        const uint32_t length = 1u + (random_next(&random) >> random_below(&random, 32));
        const double full = ldexp((double)volume.extinction * length, -39);
        if (full >= 4096)
            continue;
        const uint32_t weight = random_below(&random, 65536);
        const double exact = full * weight / 65535, depth = depth_of(&volume, length, weight);
        assert_true(fabs(depth - exact) <= exact * ldexp(1, -26) + ldexp(1, -32));
    }
}

static void expect_refused(const qv_volume *volume, uint32_t length, qv_status expected)
{
    qv_thickness thickness = {7, 9};
    assert_int_equal(qv_thickness_of(&thickness, volume, length), expected);
    assert_true(thickness.factor == 7 && thickness.shift == 9);
}

static void lengths_out_of_range(void **state)
{
    qv_volume volume = {.storage = QV_STORAGE_INDEXED8, .unit_distance = 65536};
    const uint32_t unit = 65536u * 128;
    qv_thickness thickness;
    (void)state;
    assert_int_equal(qv_thickness_of(&thickness, &volume, unit >> 12), QV_OK);
    expect_refused(&volume, (unit >> 12) - 1u, QV_ERROR_UNIT);
    volume.unit_distance = 16;
    assert_int_equal(qv_thickness_of(&thickness, &volume, unit), QV_OK);
    expect_refused(&volume, unit + 1u, QV_ERROR_UNIT);
    volume.storage = QV_STORAGE_INDEXED8_T16;
    expect_refused(&volume, unit, QV_ERROR_EXTINCTION);
    volume.extinction = 4096u * 65536u - 1u;
    assert_int_equal(qv_thickness_of(&thickness, &volume, unit), QV_OK);
    volume.extinction++;
    expect_refused(&volume, unit, QV_ERROR_EXTINCTION);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_and_steps),    cmocka_unit_test(sets),
        cmocka_unit_test(lengths_of_vectors),   cmocka_unit_test(lengths_of_steps),
        cmocka_unit_test(depth_of_opacity),     cmocka_unit_test(depth_of_extinction),
        cmocka_unit_test(lengths_out_of_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
