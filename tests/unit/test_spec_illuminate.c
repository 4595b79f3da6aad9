/*
 * The worked example S114 of tests/SPEC.md: voxels lit by lamps. The same inputs and results as
 * there, written out.
 */
#include "check.h"
#include "lighting.h"

#include <string.h>

enum { LAMPS = 3, INTERPOLATIONS = QV_BETWEEN_DEPTHS + 1 };

static const qv_lighting lighting = {.lamps = {{{-100, -200, 300}, {65535, 30000, 0}},
                                               {{3, 0, 3}, {9000, 20000, 50000}},
                                               {{7, 2, -1}, {1000, 60000, 3}}},
                                     .count = LAMPS,
                                     .ambient = {10000, 10000, 10000}};

static const uint8_t rgba8[4] = {200, 100, 50, 128};
static const uint16_t rgba16[4] = {60000, 30000, 1234, 5};

/* One voxel, of two storages. */
static qv_volume volume_of(uint8_t storage)
{
    const int wide = storage == QV_STORAGE_RGBA16;
    const qv_volume volume = {.voxels = wide ? (qv_address)rgba16 : rgba8,
                              .voxels_bytes = wide ? sizeof rgba16 : sizeof rgba8,
                              .size = {1, 1, 1},
                              .storage = storage,
                              .spacing = {65536, 81920, 131072},
                              .unit_distance = 65536};
    return volume;
}

static void fill_bytes(uint8_t bytes[QV_DIRECTIONS])
{
    for (unsigned d = 0; d < QV_DIRECTIONS; d++)
        bytes[d] = (uint8_t)(255 - 9 * d);
}

/* The voxel, lit by the first so many lamps. */
static void light_voxel(void *lit, size_t room, uint8_t storage, uint8_t interpolation,
                        unsigned lamps)
{
    static const qv_block voxel = {{0, 0, 0}, {1, 1, 1}};
    uint8_t bytes[QV_DIRECTIONS];
    qv_lighting some = lighting;
    const qv_volume volume = volume_of(storage);
    const qv_attenuation attenuation = {.records = bytes,
                                        .bytes = sizeof bytes,
                                        .directions = QV_DIRECTIONS_ALL,
                                        .size = {1, 1, 1}};
    fill_bytes(bytes);
    some.count = (uint8_t)lamps;
    assert_int_equal(qv_illuminate(lit, room, &volume, &attenuation, &some, interpolation, &voxel),
                     QV_OK);
}

static void S114_transmittances(void **state)
{
    static const uint32_t expected[INTERPOLATIONS][LAMPS] = {{0x69D50CD1, 0x6756D485, 0x8EEF36D3},
                                                             {0x6EE91D56, 0x633FA056, 0x865EE4DA},
                                                             {0x6986A1C6, 0x67422BBA, 0x8D87A6EE}};
    const qv_volume volume = volume_of(QV_STORAGE_RGBA8);
    uint8_t bytes[QV_DIRECTIONS];
    (void)state;
    fill_bytes(bytes);
    for (uint8_t i = 0; i < INTERPOLATIONS; i++) {
        qv_compass compass;
        qv_bearing lamps[QV_LAMPS_MAX];
        qv_compass_of(&compass, &volume, QV_DIRECTIONS_ALL, i);
        assert_int_equal(qv_lighting_bearings(lamps, &lighting, &compass, volume.spacing), QV_OK);
        for (unsigned lamp = 0; lamp < LAMPS; lamp++)
            assert_int_equal(qv_bearing_transmittance(&lamps[lamp], bytes, NULL),
                             expected[i][lamp]);
    }
}

static void S114_voxels_of_8_bits(void **state)
{
    static const uint8_t expected[INTERPOLATIONS][LAMPS][4] = {
        {{113, 34, 8, 128}, {124, 47, 23, 128}, {126, 98, 23, 128}},
        {{117, 35, 8, 128}, {128, 47, 22, 128}, {129, 95, 22, 128}},
        {{113, 34, 8, 128}, {124, 46, 23, 128}, {126, 97, 23, 128}}};
    (void)state;
    for (uint8_t i = 0; i < INTERPOLATIONS; i++)
        for (unsigned lamps = 1; lamps <= LAMPS; lamps++) {
            uint8_t lit[4];
            light_voxel(lit, sizeof lit, QV_STORAGE_RGBA8, i, lamps);
            assert_memory_equal(lit, expected[i][lamps - 1], sizeof lit);
        }
}

static void S114_voxels_of_16_bits(void **state)
{
    static const uint16_t expected[INTERPOLATIONS][LAMPS][4] = {
        {{33960, 10255, 188, 5}, {37286, 13951, 568, 5}, {37797, 29286, 568, 5}},
        {{35150, 10527, 188, 5}, {38345, 14077, 553, 5}, {38825, 28493, 553, 5}},
        {{33888, 10238, 188, 5}, {37211, 13931, 568, 5}, {37718, 29116, 568, 5}}};
    (void)state;
    for (uint8_t i = 0; i < INTERPOLATIONS; i++)
        for (unsigned lamps = 1; lamps <= LAMPS; lamps++) {
            uint16_t lit[4];
            light_voxel(lit, sizeof lit, QV_STORAGE_RGBA16, i, lamps);
            assert_memory_equal(lit, expected[i][lamps - 1], sizeof lit);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S114_transmittances),
        cmocka_unit_test(S114_voxels_of_8_bits),
        cmocka_unit_test(S114_voxels_of_16_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
