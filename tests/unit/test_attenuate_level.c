/*
 * Coarser levels of attenuation, against means over the voxels' depths in real numbers.
 */
#include "attenuation_fixture.h"

#include <stdio.h>

#define MOST_OFF 0.501

static lit fine, coarse;

static void size_of_level(uint16_t size[3], unsigned level)
{
    for (unsigned axis = 0; axis < 3; axis++) {
        const unsigned width = 1u << level;
        size[axis] = (uint16_t)((fine.from.volume.size[axis] + width - 1) / width);
    }
}

/* Makes a level of what `fine` holds. */
static qv_status make_level(uint8_t level, uint8_t direction)
{
    return qv_attenuate_level(coarse.memory, (size_t)coarse.attenuation.bytes, &coarse.attenuation,
                              fine.blocks, fine.from.volume.size, level, direction);
}

typedef struct of_level {
    int level;
} of_level;

static double mean_at(const void *user, const uint16_t at[3])
{
    const of_level *of = user;
    const int32_t block[3] = {at[0], at[1], at[2]};
    return ref_mean_depth(fine.depths, fine.from.volume.size, of->level, block);
}

static void compare_levels(unsigned direction, uint32_t *seed)
{
    ref_outer_depths(fine.depths, &fine.from.volume, (int)direction);
    assert_int_equal(lit_attenuate(&fine, (uint8_t)direction), QV_OK);
    for (uint8_t level = 1; level <= qv_pyramid_levels(fine.from.volume.size); level++) {
        const of_level of = {level};
        const uint16_t record = (uint16_t)(QV_DIRECTIONS + random_below(seed, 6));
        uint16_t size[3];
        size_of_level(size, level);
        lit_records(&coarse, size, QV_DIRECTIONS_ALL, record, orders[random_below(seed, 4)]);
        assert_int_equal(make_level(level, (uint8_t)direction), QV_OK);
        expect_at_most(farthest_byte(&coarse.attenuation, direction, mean_at, &of), MOST_OFF,
                       "level");
    }
}

static void levels_are_means_of_depths(void **state)
{
    uint32_t seed = 29;
    (void)state;

    for (unsigned i = 0; i < SOURCE_STORAGES; i++)
        for (unsigned round = 0; round < 12; round++) {
            lit_volume(&fine, source_storages[i], round % FILLINGS, &seed);
            lit_records(&fine, fine.from.volume.size, QV_DIRECTIONS_ALL, 0, NULL);
            for (unsigned direction = 0; direction < QV_DIRECTIONS; direction++)
                compare_levels(direction, &seed);
        }
}

/* Of one direction, only its bytes; nothing behind the last. */
static void only_the_direction_is_written(void **state)
{
    static const uint16_t size[3] = {3, 4, 5};
    uint32_t seed = 8;
    (void)state;

    source_make(&fine.from, QV_STORAGE_RGBA16, size, DENSE, &seed);
    lit_records(&fine, size, QV_DIRECTIONS_ALL, 0, NULL);
    assert_int_equal(lit_attenuate(&fine, 10), QV_OK);
    for (uint8_t level = 1; level <= 3; level++) {
        uint16_t level_size[3];
        size_of_level(level_size, level);
        lit_records(&coarse, level_size, QV_DIRECTIONS_FACES, 9, NULL);
        assert_int_equal(make_level(level, 10), QV_OK);
        const size_t voxels = (size_t)level_size[0] * level_size[1] * level_size[2];
        for (size_t i = 0; i < sizeof coarse.memory; i++)
            if (i % 9 != 1 || i / 9 >= voxels)
                assert_int_equal(coarse.memory[i], UNTOUCHED);
    }
}

/* Eight voxels of which one lies behind something opaque: an eighth of a depth of 64. */
static void behind_opaque_counts_64(void **state)
{
    static const uint16_t size[3] = {2, 2, 4}, one[3] = {1, 1, 2};
    const uint8_t up = qv_direction(0, 0, 1);
    (void)state;

    source_shape(&fine.from, QV_STORAGE_RGBA8, size);
    unsigned char *voxels = (unsigned char *)fine.from.voxels;
    memset(voxels, 0, sizeof fine.from.voxels);
    voxels[4 * 4 + 3] = 255; /* (0, 0, 1), behind which is (0, 0, 0) */
    lit_records(&fine, size, 1u << up, 0, NULL);
    assert_int_equal(lit_attenuate(&fine, up), QV_OK);
    assert_int_equal(fine.memory[0], 0);
    assert_int_equal(fine.blocks[0], 64u << 22);
    assert_int_equal(fine.blocks[1], 0);
    lit_records(&coarse, one, 1u << up, 0, NULL);
    assert_int_equal(make_level(1, up), QV_OK);
    assert_int_equal(coarse.memory[0], 1); /* 255 * 2^-8 */
    assert_int_equal(coarse.memory[1], 255);
}

/* Depth 1 everywhere on the longest axis. */
static void the_last_of_twelve_levels(void **state)
{
    static const uint16_t size[3] = {QV_AXIS_MAX, 1, 1}, one[3] = {1, 1, 1};
    static uint32_t blocks[QV_AXIS_MAX / 2];
    (void)state;

    lit_records(&coarse, one, 1, 0, NULL);
    for (unsigned i = 0; i < QV_AXIS_MAX / 2; i++)
        blocks[i] = 2u << 22; /* of two voxels, a depth of 1 each */
    assert_int_equal(qv_attenuate_level(coarse.memory, 1, &coarse.attenuation, blocks, size, 12, 0),
                     QV_OK);
    assert_int_equal(coarse.memory[0], 128);
}

/* ---- What is refused ---- */

static void make_good(void)
{
    static const uint16_t size[3] = {5, 4, 3}, half[3] = {3, 2, 2};
    uint32_t seed = 31;
    source_make(&fine.from, QV_STORAGE_RGBA16, size, DENSE, &seed);
    lit_records(&fine, size, QV_DIRECTIONS_FACES, 0, NULL);
    assert_int_equal(lit_attenuate(&fine, 4), QV_OK);
    lit_records(&coarse, half, QV_DIRECTIONS_FACES, 0, NULL);
}

static void expect_refused(uint8_t level, uint8_t direction, qv_status expected)
{
    static unsigned char before[sizeof coarse.memory];
    memcpy(before, coarse.memory, sizeof before);
    assert_int_equal(make_level(level, direction), expected);
    assert_memory_equal(coarse.memory, before, sizeof before);
}

static void null_pointers_are_refused(void **state)
{
    qv_attenuation *a = &coarse.attenuation;
    const uint16_t *size = fine.from.volume.size;
    const size_t bytes = sizeof coarse.memory;
    (void)state;

    make_good();
    assert_int_equal(qv_attenuate_level(NULL, bytes, a, fine.blocks, size, 1, 4), QV_ERROR_NULL);
    assert_int_equal(qv_attenuate_level(coarse.memory, bytes, NULL, fine.blocks, size, 1, 4),
                     QV_ERROR_NULL);
    assert_int_equal(qv_attenuate_level(coarse.memory, bytes, a, NULL, size, 1, 4), QV_ERROR_NULL);
    assert_int_equal(qv_attenuate_level(coarse.memory, bytes, a, fine.blocks, NULL, 1, 4),
                     QV_ERROR_NULL);
}

static void wrong_levels_are_refused(void **state)
{
    (void)state;

    make_good();
    assert_int_equal(make_level(1, 4), QV_OK);
    expect_refused(0, 4, QV_ERROR_LEVEL);
    expect_refused(4, 4, QV_ERROR_LEVEL);
    expect_refused(255, 4, QV_ERROR_LEVEL);
    expect_refused(2, 4, QV_ERROR_SIZE);
    fine.from.volume.size[1] = 0;
    expect_refused(1, 4, QV_ERROR_SIZE);
    fine.from.volume.size[1] = QV_AXIS_MAX + 1;
    expect_refused(1, 4, QV_ERROR_SIZE);
}

static void wrong_records_are_refused(void **state)
{
    (void)state;

    make_good();
    expect_refused(1, 3, QV_ERROR_DIRECTION);
    expect_refused(1, 26, QV_ERROR_DIRECTION);
    coarse.attenuation.directions = 0;
    expect_refused(1, 4, QV_ERROR_DIRECTION);
    for (unsigned axis = 0; axis < 3; axis++) {
        make_good();
        coarse.attenuation.size[axis]++;
        coarse.attenuation.bytes = sizeof coarse.memory;
        expect_refused(1, 4, QV_ERROR_SIZE);
    }
    make_good();
    coarse.attenuation.record = 5;
    expect_refused(1, 4, QV_ERROR_ATTENUATION);
    make_good();
    coarse.attenuation.bytes--;
    expect_refused(1, 4, QV_ERROR_ATTENUATION);
}

static void overlaps_are_refused(void **state)
{
    const size_t bytes = 72; /* 12 voxels, as many sums */
    const uint16_t *size = fine.from.volume.size;
    (void)state;

    make_good();
    uint32_t *sums = fine.blocks + 100;
    unsigned char *first = (unsigned char *)sums;
    assert_int_equal(coarse.attenuation.bytes, bytes);
    assert_int_equal(
        qv_attenuate_level(first - bytes + 1, bytes, &coarse.attenuation, sums, size, 1, 4),
        QV_ERROR_OVERLAP);
    assert_int_equal(qv_attenuate_level(first + 47, bytes, &coarse.attenuation, sums, size, 1, 4),
                     QV_ERROR_OVERLAP);
    assert_int_equal(
        qv_attenuate_level(first - bytes, bytes, &coarse.attenuation, sums, size, 1, 4), QV_OK);
    assert_int_equal(qv_attenuate_level(first + 48, bytes, &coarse.attenuation, sums, size, 1, 4),
                     QV_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(levels_are_means_of_depths),
        cmocka_unit_test(only_the_direction_is_written),
        cmocka_unit_test(behind_opaque_counts_64),
        cmocka_unit_test(the_last_of_twelve_levels),
        cmocka_unit_test(null_pointers_are_refused),
        cmocka_unit_test(wrong_levels_are_refused),
        cmocka_unit_test(wrong_records_are_refused),
        cmocka_unit_test(overlaps_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
