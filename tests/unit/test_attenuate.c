/*
 * Light between voxels and the outside, against sums of depths in real numbers: every direction,
 * storage and order.
 */
#include "attenuation_fixture.h"

#include <stdio.h>

/* A byte is half a step off by its own rounding, depths of such short lines add little. */
#define MOST_OFF 0.501

static lit l;

static double depth_at(const void *user, const uint16_t at[3])
{
    const lit *of = user;
    const uint16_t *size = of->from.volume.size;
    return of->depths[at[0] + (size_t)size[0] * (at[1] + (size_t)size[1] * at[2])];
}

/* The sums of blocks, less those of the reference. */
static double farthest_block(const lit *of)
{
    const uint16_t *size = of->from.volume.size;
    double sums[SOURCE_VOXELS] = {0}, farthest = 0;
    const size_t width = (size[0] + 1u) / 2, height = (size[1] + 1u) / 2;
    const size_t blocks = width * height * ((size[2] + 1u) / 2);
    uint16_t at[3];
    for (at[2] = 0; at[2] < size[2]; at[2]++)
        for (at[1] = 0; at[1] < size[1]; at[1]++)
            for (at[0] = 0; at[0] < size[0]; at[0]++)
                sums[at[0] / 2 + width * (at[1] / 2 + height * (at[2] / 2u))] +=
                    fmin(depth_at(of, at), 64);
    for (size_t i = 0; i < blocks; i++)
        farthest = fmax(farthest, fabs(of->blocks[i] / 4194304.0 - sums[i]));
    return farthest;
}

static void compare_direction(unsigned direction)
{
    ref_outer_depths(l.depths, &l.from.volume, (int)direction);
    memset(l.blocks, UNTOUCHED, sizeof l.blocks);
    assert_int_equal(lit_attenuate(&l, (uint8_t)direction), QV_OK);
    expect_at_most(farthest_byte(&l.attenuation, direction, depth_at, &l), MOST_OFF, "byte");
    /* Each depth of a voxel is rounded to 2^-22; those of opacities are 2^-20 of themselves off
       where they count. */
    expect_at_most(farthest_block(&l), 0.002, "block");
}

static void every_direction_of_every_storage(void **state)
{
    uint32_t seed = 41;
    (void)state;

    for (unsigned i = 0; i < SOURCE_STORAGES; i++)
        for (unsigned round = 0; round < 24; round++) {
            const uint16_t record =
                (uint16_t)(round % 3 == 0 ? 0 : QV_DIRECTIONS + random_below(&seed, 6));
            lit_volume(&l, source_storages[i], round % FILLINGS, &seed);
            lit_records(&l, l.from.volume.size, QV_DIRECTIONS_ALL, record, orders[round % 4]);
            for (unsigned direction = 0; direction < QV_DIRECTIONS; direction++)
                compare_direction(direction);
        }
}

/* The recurrence of the reference is the sum that it stands for. */
static void the_reference_adds_up(void **state)
{
    uint32_t seed = 3;
    (void)state;

    lit_volume(&l, QV_STORAGE_RGBA16, DENSE, &seed);
    for (int direction = 0; direction < 26; direction++) {
        const uint16_t *size = l.from.volume.size;
        int32_t at[3];
        ref_outer_depths(l.depths, &l.from.volume, direction);
        for (at[2] = 0; at[2] < size[2]; at[2]++)
            for (at[1] = 0; at[1] < size[1]; at[1]++)
                for (at[0] = 0; at[0] < size[0]; at[0]++) {
                    const uint16_t voxel[3] = {(uint16_t)at[0], (uint16_t)at[1], (uint16_t)at[2]};
                    const double sum = ref_outer_depth(&l.from.volume, direction, at);
                    assert_true(fabs(sum - depth_at(&l, voxel)) < 1e-9);
                }
    }
}

/* ---- What is written, and what is not ---- */

/* Every byte but the direction's own keeps what it was. */
static void only_the_direction_is_written(void **state)
{
    static unsigned char before[sizeof l.memory];
    uint32_t seed = 77;
    (void)state;

    for (unsigned round = 0; round < 60; round++) {
        const uint32_t directions = (random_next(&seed) & QV_DIRECTIONS_ALL) | 1u << (round % 26);
        const unsigned slot = slot_of(directions, round % 26);
        lit_volume(&l, QV_STORAGE_RGBA8, DENSE, &seed);
        lit_records(&l, l.from.volume.size, directions, RECORD_MOST, orders[round % 4]);
        const size_t voxels =
            (size_t)l.from.volume.size[0] * l.from.volume.size[1] * l.from.volume.size[2];
        memcpy(before, l.memory, sizeof before);
        assert_int_equal(lit_attenuate(&l, (uint8_t)(round % 26)), QV_OK);
        for (size_t i = 0; i < sizeof l.memory; i++)
            if (i % RECORD_MOST != slot || i / RECORD_MOST >= voxels)
                assert_int_equal(l.memory[i], before[i]);
    }
}

/* Voxels and their bytes side by side, either first, as a file may keep them. */
static void voxels_may_lie_between_records(void **state)
{
    enum { STRIDE = 30, SIZE = 5 };
    static unsigned char records[STRIDE * SIZE * SIZE * SIZE], before[sizeof records];
    static const uint16_t size[3] = {SIZE, SIZE, SIZE};
    uint32_t seed = 13;
    (void)state;

    for (unsigned voxel_first = 0; voxel_first < 2; voxel_first++) {
        unsigned char *voxels = voxel_first ? records : records + 26;
        unsigned char *bytes = voxel_first ? records + 4 : records;
        source_make(&l.from, QV_STORAGE_RGBA8, size, SPARSE, &seed);
        memset(records, UNTOUCHED, sizeof records);
        for (unsigned i = 0; i < SIZE * SIZE * SIZE; i++)
            memcpy(voxels + STRIDE * i, (unsigned char *)l.from.voxels + 4 * i, 4);
        memcpy(before, records, sizeof before);
        lit_records(&l, size, QV_DIRECTIONS_ALL, STRIDE, NULL);
        l.from.volume.voxels = voxels;
        l.from.volume.voxels_bytes = sizeof records - 26;
        for (unsigned axis = 0; axis < 3; axis++)
            l.from.volume.stride[axis] = (int32_t)(STRIDE * pow(SIZE, axis));
        for (uint8_t d = 0; d < QV_DIRECTIONS; d++) {
            ref_outer_depths(l.depths, &l.from.volume, d);
            assert_int_equal(qv_attenuate(bytes, sizeof records - 4, NULL, &l.attenuation,
                                          &l.from.volume, &qv_domain_extinction, d),
                             QV_OK);
            l.attenuation.records = bytes;
            expect_at_most(farthest_byte(&l.attenuation, d, depth_at, &l), MOST_OFF, "byte");
        }
        for (unsigned i = 0; i < SIZE * SIZE * SIZE; i++)
            assert_memory_equal(voxels + STRIDE * i, before + (voxels - records) + STRIDE * i, 4);
    }
}

static void blocks_are_optional(void **state)
{
    static unsigned char with[sizeof l.memory];
    uint32_t seed = 5;
    (void)state;

    lit_volume(&l, QV_STORAGE_INDEXED8_T16, NOISE, &seed);
    lit_records(&l, l.from.volume.size, QV_DIRECTIONS_ALL, 0, NULL);
    assert_int_equal(lit_attenuate(&l, 7), QV_OK);
    memcpy(with, l.memory, sizeof with);
    memset(l.memory, UNTOUCHED, sizeof l.memory);
    assert_int_equal(qv_attenuate(l.memory, sizeof l.memory, NULL, &l.attenuation, &l.from.volume,
                                  &qv_domain_stored, 7),
                     QV_OK);
    assert_memory_equal(l.memory, with, sizeof with);
}

/* ---- Closed forms ---- */

/* A cube of one opacity, with every direction. */
static void make_cube(uint16_t side, uint16_t opacity, uint32_t unit_distance)
{
    const uint16_t size[3] = {side, side, side};
    source_shape(&l.from, QV_STORAGE_RGBA16, size);
    for (unsigned i = 0; i < SOURCE_VOXELS; i++)
        l.from.voxels[4 * i + 3] = opacity;
    l.from.volume.unit_distance = unit_distance;
    lit_records(&l, size, QV_DIRECTIONS_ALL, 0, NULL);
}

/* Voxels from one to the outside of the cube. */
static int voxels_outside(const uint16_t at[3], const int step[3], int side)
{
    int least = side;
    for (unsigned axis = 0; axis < 3; axis++) {
        const int left = step[axis] > 0 ? side - 1 - at[axis] : at[axis];
        if (step[axis] != 0 && left < least)
            least = left;
    }
    return least;
}

/* 255 * 2^-(depth of a step * voxels), where the depth is 1 a world unit. */
static void expect_cube(unsigned direction, int side, double depth)
{
    int step[3];
    uint16_t at[3];
    ref_direction_step(step, (int)direction);
    for (at[2] = 0; at[2] < side; at[2]++)
        for (at[1] = 0; at[1] < side; at[1]++)
            for (at[0] = 0; at[0] < side; at[0]++) {
                const double exact = 255 * exp2(-depth * voxels_outside(at, step, side));
                assert_true(fabs(qv_attenuation_at(&l.attenuation, at)[direction] - exact) <= 0.51);
            }
}

/* Opacity 1/2 (2^15 of 65535 is a little more) is a depth of 1, and so a step of sqrt 2 or sqrt 3
   has that depth where there is a unit distance. */
static void a_uniform_cube_is_a_power_of_its_opacity(void **state)
{
    (void)state;

    for (unsigned direction = 0; direction < QV_DIRECTIONS; direction++) {
        int step[3];
        ref_direction_step(step, (int)direction);
        const double length = sqrt(step[0] * step[0] + step[1] * step[1] + step[2] * step[2]);
        make_cube(10, 32768, 0);
        assert_int_equal(lit_attenuate(&l, (uint8_t)direction), QV_OK);
        expect_cube(direction, 10, 1);
        make_cube(10, 32768, QV_ONE_Q16);
        assert_int_equal(lit_attenuate(&l, (uint8_t)direction), QV_OK);
        expect_cube(direction, 10, length);
    }
}

/* Light comes through no voxel behind an opaque one, and 0 stays 0. */
static void nothing_passes_an_opaque_voxel(void **state)
{
    static const uint16_t size[3] = {1, 9, 1};
    const uint8_t up = qv_direction(0, 1, 0), down = qv_direction(0, -1, 0);
    (void)state;

    source_shape(&l.from, QV_STORAGE_RGBA16, size);
    memset(l.from.voxels, 0, sizeof l.from.voxels);
    l.from.voxels[4 * 4 + 3] = 65535;
    l.from.voxels[4 * 6 + 3] = 32768;
    lit_records(&l, size, 1u << up | 1u << down, 0, NULL);
    assert_int_equal(lit_attenuate(&l, up), QV_OK);
    assert_int_equal(lit_attenuate(&l, down), QV_OK);
    for (unsigned y = 0; y < 9; y++) {
        assert_int_equal(l.memory[2 * y], y <= 4 ? 255 : 0);
        assert_int_equal(l.memory[2 * y + 1], y < 4 ? 0 : y < 6 ? 127 : 255);
    }
}

static void a_single_voxel_sees_all_light(void **state)
{
    static const uint16_t size[3] = {1, 1, 1};
    (void)state;

    source_shape(&l.from, QV_STORAGE_RGBA16, size);
    l.from.voxels[3] = 65535;
    lit_records(&l, size, QV_DIRECTIONS_ALL, 0, NULL);
    for (uint8_t direction = 0; direction < QV_DIRECTIONS; direction++) {
        assert_int_equal(lit_attenuate(&l, direction), QV_OK);
        assert_int_equal(l.memory[direction], 255);
        assert_int_equal(l.blocks[0], 0);
    }
}

/* Axes of the greatest length, with depths of more than 2^12 in their voxels. */
static void the_longest_lines(void **state)
{
    static unsigned char voxels[4 * QV_AXIS_MAX], bytes[QV_AXIS_MAX];
    static uint32_t blocks[QV_AXIS_MAX / 2];
    (void)state;

    for (unsigned i = 0; i < 6; i++) {
        static const int8_t steps[6][3] = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                           {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
        const uint8_t direction = qv_direction(steps[i][0], steps[i][1], steps[i][2]);
        qv_volume v;
        qv_attenuation a;
        memset(&v, 0, sizeof v);
        memset(&a, 0, sizeof a);
        memset(voxels, 255, sizeof voxels);
        v.voxels = voxels;
        v.voxels_bytes = sizeof voxels;
        v.storage = QV_STORAGE_RGBT8;
        v.extinction = 4095 * QV_ONE_Q16;
        v.stride[i % 3] = 4;
        a.directions = 1u << direction;
        for (unsigned axis = 0; axis < 3; axis++)
            v.size[axis] = a.size[axis] = axis == i % 3 ? QV_AXIS_MAX : 1;
        assert_int_equal(
            qv_attenuate(bytes, sizeof bytes, blocks, &a, &v, &qv_domain_stored, direction), QV_OK);
        for (unsigned at = 0; at < QV_AXIS_MAX; at++)
            assert_int_equal(bytes[at], at == (i < 3 ? QV_AXIS_MAX - 1 : 0) ? 255 : 0);
        for (unsigned at = 0; at < QV_AXIS_MAX / 2; at++)
            assert_int_equal(blocks[at],
                             at == (i < 3 ? QV_AXIS_MAX / 2 - 1 : 0) ? 64u << 22 : 128u << 22);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_direction_of_every_storage),
        cmocka_unit_test(the_reference_adds_up),
        cmocka_unit_test(only_the_direction_is_written),
        cmocka_unit_test(voxels_may_lie_between_records),
        cmocka_unit_test(blocks_are_optional),
        cmocka_unit_test(a_uniform_cube_is_a_power_of_its_opacity),
        cmocka_unit_test(nothing_passes_an_opaque_voxel),
        cmocka_unit_test(a_single_voxel_sees_all_light),
        cmocka_unit_test(the_longest_lines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
