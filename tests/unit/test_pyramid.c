/*
 * Levels of a pyramid: how many, how large, where they lie, and what is made in them.
 */
#include "check.h"
#include "downsample_fixture.h"
#include "pyramid.h"

/* ---- How many, how large ---- */

static void levels_of_a_size(void **state)
{
    static const struct {
        uint16_t size[3];
        uint8_t levels;
    } cases[] = {{{1, 1, 1}, 0},     {{2, 1, 1}, 1},     {{1, 1, 3}, 2},
                 {{4, 3, 2}, 2},     {{1, 5, 1}, 3},     {{256, 256, 124}, 8},
                 {{2048, 1, 1}, 11}, {{1, 2049, 1}, 12}, {{4095, 7, 4096}, 12}};
    (void)state;

    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++)
        assert_int_equal(qv_pyramid_levels(cases[i].size), cases[i].levels);
}

static void bytes_of_levels(void **state)
{
    static const uint16_t odd[3] = {5, 3, 1}, most[3] = {4096, 4096, 4096};
    uint64_t all = 0;
    (void)state;

    /* 3 * 2 * 1, 2 * 1 * 1 and 1 voxel */
    assert_int_equal(qv_pyramid_bytes(odd, QV_STORAGE_RGBA8, 0), 0);
    assert_int_equal(qv_pyramid_bytes(odd, QV_STORAGE_RGBA8, 1), 6 * 4);
    assert_int_equal(qv_pyramid_bytes(odd, QV_STORAGE_INDEXED8_T16, 2), 8 * 8);
    assert_int_equal(qv_pyramid_bytes(odd, QV_STORAGE_INDEXED8, 3), 9 * 4);
    for (unsigned level = 1; level <= 12; level++)
        all += (uint64_t)8 << (36 - 3 * level);
    assert_true(qv_pyramid_bytes(most, QV_STORAGE_RGBT16, 12) == all);
}

/* ---- Where they lie ---- */

static source s;
static unsigned char memory[SOURCE_VOXELS * 8 + 1];
static qv_pyramid pyramid;

static const uint16_t odd_size[3] = {9, 6, 5}; /* 5 x 3 x 3, 3 x 2 x 2, 2 x 1 x 1, 1 */

/* A pyramid of all levels of a volume of 9 x 6 x 5 voxels. */
static void make(uint8_t storage)
{
    source_shape(&s, storage, odd_size);
    s.volume.spacing[0] = 4096;
    s.volume.spacing[2] = 3 * QV_ONE_Q16;
    s.volume.unit_distance = QV_ONE_Q16 / 2;
    pyramid.voxels = memory;
    pyramid.levels = qv_pyramid_levels(odd_size);
    pyramid.bytes = qv_pyramid_bytes(odd_size, storage, pyramid.levels);
}

static void levels_follow_one_another(void **state)
{
    qv_volume level, before;
    (void)state;

    for (unsigned i = 0; i < SOURCE_STORAGES; i++) {
        make(source_storages[i]);
        const unsigned bytes = (unsigned)source_entry_bytes(source_storages[i]);
        assert_int_equal(pyramid.levels, 4);
        assert_int_equal(qv_pyramid_level(&before, &s.volume, &pyramid, 1), QV_OK);
        assert_true(before.voxels == memory);
        assert_int_equal(before.voxels_bytes, 5 * 3 * 3 * bytes);
        for (uint8_t number = 2; number <= 4; number++, before = level) {
            assert_int_equal(qv_pyramid_level(&level, &s.volume, &pyramid, number), QV_OK);
            assert_int_equal(qv_volume_check(&level), QV_OK);
            assert_true(level.voxels == before.voxels + before.voxels_bytes);
        }
        assert_true(before.voxels + before.voxels_bytes == memory + pyramid.bytes);
    }
}

static void a_level_is_a_volume(void **state)
{
    qv_volume level;
    (void)state;

    make(QV_STORAGE_INDEXED8_T16);
    assert_int_equal(qv_pyramid_level(&level, &s.volume, &pyramid, 2), QV_OK);
    assert_int_equal(level.storage, QV_STORAGE_RGBT16);
    assert_null(level.palette);
    assert_int_equal(level.palette_bytes, 0);
    assert_int_equal(level.size[0], 3);
    assert_int_equal(level.size[1], 2);
    assert_int_equal(level.size[2], 2);
    assert_int_equal(level.stride[0], 8);
    assert_int_equal(level.stride[1], 24);
    assert_int_equal(level.stride[2], 48);
    assert_int_equal(level.spacing[0], 4 * 4096);
    assert_int_equal(level.spacing[1], 4 * QV_ONE_Q16);
    assert_int_equal(level.spacing[2], 12 * QV_ONE_Q16);
    assert_int_equal(level.unit_distance, s.volume.unit_distance);
    assert_int_equal(level.extinction, s.volume.extinction);
}

static void level_0_is_the_volume(void **state)
{
    qv_volume level;
    (void)state;

    make(QV_STORAGE_INDEXED8);
    memset(&level, 0xA5, sizeof level);
    assert_int_equal(qv_pyramid_level(&level, &s.volume, NULL, 0), QV_OK);
    assert_memory_equal(&level, &s.volume, sizeof level);
    assert_int_equal(qv_pyramid_level(&s.volume, &s.volume, &pyramid, 1), QV_OK);
    assert_int_equal(s.volume.storage, QV_STORAGE_RGBA8);
}

/* Voxels of 256 units: those of level 7 are 2^15 wide, those of level 8 too wide. */
static void wide_voxels(void **state)
{
    static const uint16_t long_size[3] = {1, 300, 1};
    qv_volume level;
    (void)state;

    source_shape(&s, QV_STORAGE_RGBA8, long_size);
    s.volume.spacing[1] = 256 * QV_ONE_Q16;
    pyramid.voxels = memory;
    pyramid.levels = 9;
    pyramid.bytes = sizeof memory;
    assert_int_equal(qv_pyramid_level(&level, &s.volume, &pyramid, 7), QV_OK);
    assert_int_equal(level.spacing[1], 0x80000000u);
    assert_int_equal(qv_pyramid_level(&level, &s.volume, &pyramid, 8), QV_OK);
    assert_int_equal(level.spacing[1], 0xFFFFFFFFu);
    assert_int_equal(level.spacing[0], 256 * QV_ONE_Q16);
    assert_int_equal(qv_volume_check(&level), QV_ERROR_SPACING);
    assert_int_equal(qv_downsample(memory, 4, &level, &qv_filter_box2, &qv_domain_stored, 0, 1),
                     QV_OK);
}

/* ---- What is made in them ---- */

static void make_levels(const qv_domain *domain)
{
    for (uint8_t number = 1; number <= pyramid.levels; number++) {
        qv_volume finer, level;
        assert_int_equal(qv_pyramid_level(&finer, &s.volume, &pyramid, (uint8_t)(number - 1)),
                         QV_OK);
        assert_int_equal(qv_pyramid_level(&level, &s.volume, &pyramid, number), QV_OK);
        const size_t offset = (size_t)(level.voxels - memory);
        assert_int_equal(qv_downsample(&memory[offset], (size_t)level.voxels_bytes, &finer,
                                       &qv_filter_quad4, domain, 0, level.size[2]),
                         QV_OK);
    }
}

static void a_homogeneous_volume_is_so_on_every_level(void **state)
{
    static const uint16_t entries[][4] = {{65535, 1, 0x8080, 65535},
                                          {1, 65534, 12345, 1},
                                          {0, 40000, 7, 0x1234},
                                          {65535, 65535, 65535, 65534}};
    (void)state;

    for (unsigned i = 0; i < sizeof entries / sizeof entries[0]; i++) {
        make(QV_STORAGE_INDEXED8_16);
        memset(s.voxels, 3, sizeof s.voxels);
        memcpy(&s.palette[4 * 3], entries[i], sizeof entries[i]);
        memset(memory, 0, sizeof memory);
        make_levels(i % 2 == 0 ? &qv_domain_extinction : &qv_domain_stored);
        for (size_t at = 0; at < pyramid.bytes; at += 8)
            assert_memory_equal(&memory[at], entries[i], sizeof entries[i]);
        assert_int_equal(memory[pyramid.bytes], 0);
    }
}

/* ---- What is refused ---- */

static void expect_refused(uint8_t number, qv_status expected)
{
    qv_volume level, before;
    memset(&level, 0xA5, sizeof level);
    before = level;
    assert_int_equal(qv_pyramid_level(&level, &s.volume, &pyramid, number), expected);
    assert_memory_equal(&level, &before, sizeof level);
}

static void null_pointers_are_refused(void **state)
{
    qv_volume level;
    (void)state;

    make(QV_STORAGE_RGBA8);
    assert_int_equal(qv_pyramid_level(NULL, &s.volume, &pyramid, 0), QV_ERROR_NULL);
    assert_int_equal(qv_pyramid_level(&level, NULL, &pyramid, 0), QV_ERROR_NULL);
    assert_int_equal(qv_pyramid_level(&level, &s.volume, NULL, 1), QV_ERROR_LEVEL);
    pyramid.voxels = NULL;
    expect_refused(1, QV_ERROR_NULL);
}

static void bad_pyramids_are_refused(void **state)
{
    (void)state;

    make(QV_STORAGE_RGBA16);
    expect_refused(5, QV_ERROR_LEVEL);
    pyramid.levels = 5;
    expect_refused(1, QV_ERROR_LEVEL);
    pyramid.levels = 0;
    expect_refused(1, QV_ERROR_LEVEL);
    assert_int_equal(qv_pyramid_check(&s.volume, &pyramid), QV_ERROR_LEVEL);
    pyramid.levels = 2;
    expect_refused(3, QV_ERROR_LEVEL);
    make(QV_STORAGE_RGBA16);
    pyramid.bytes--;
    expect_refused(1, QV_ERROR_BUFFER);
    make(QV_STORAGE_RGBA16);
    pyramid.voxels++;
    expect_refused(1, QV_ERROR_STRIDE);
    make(QV_STORAGE_INDEXED8);
    pyramid.voxels++;
    assert_int_equal(qv_pyramid_level(&s.volume, &s.volume, &pyramid, 1), QV_OK);
}

static void bad_volumes_are_refused(void **state)
{
    (void)state;

    for (uint8_t number = 0; number < 2; number++) {
        make(QV_STORAGE_RGBA8);
        s.volume.storage = QV_STORAGE_ASSOCIATED8 + 1;
        expect_refused(number, QV_ERROR_STORAGE);
        make(QV_STORAGE_RGBA8);
        s.volume.spacing[1] = 1;
        expect_refused(number, QV_ERROR_SPACING);
    }
    make(QV_STORAGE_RGBA8);
    s.volume.storage = QV_STORAGE_ASSOCIATED8;
    expect_refused(1, QV_ERROR_STORAGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(levels_of_a_size),
        cmocka_unit_test(bytes_of_levels),
        cmocka_unit_test(levels_follow_one_another),
        cmocka_unit_test(a_level_is_a_volume),
        cmocka_unit_test(level_0_is_the_volume),
        cmocka_unit_test(wide_voxels),
        cmocka_unit_test(a_homogeneous_volume_is_so_on_every_level),
        cmocka_unit_test(null_pointers_are_refused),
        cmocka_unit_test(bad_pyramids_are_refused),
        cmocka_unit_test(bad_volumes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
