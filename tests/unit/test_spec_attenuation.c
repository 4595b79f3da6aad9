/*
 * The worked examples S100 .. S105 of tests/SPEC.md: light between voxels and the outside, and
 * coarser levels of it. The same inputs and results as there, written out.
 */
#include "attenuation.h"
#include "check.h"
#include "direction.h"
#include "thickness.h"

#include <string.h>

static const uint32_t spacing[3] = {65536, 98304, 43691};

static void S100_steps(void **state)
{
    static const struct {
        uint8_t direction;
        int8_t step[3];
        uint32_t length;
    } examples[] = {{0, {-1, -1, -1}, 16123706}, {1, {0, -1, -1}, 13769719},
                    {4, {0, 0, -1}, 5592448},    {13, {1, 0, 0}, 8388608},
                    {14, {-1, 1, 0}, 15122778},  {25, {1, 1, 1}, 16123706}};
    (void)state;

    for (unsigned i = 0; i < sizeof examples / sizeof examples[0]; i++) {
        int8_t step[3];
        qv_direction_step(step, examples[i].direction);
        assert_memory_equal(step, examples[i].step, sizeof step);
        assert_int_equal(qv_direction_length(spacing, examples[i].direction), examples[i].length);
    }
}

static void S101_thickness(void **state)
{
    static const struct {
        uint8_t storage;
        uint32_t number, length, factor;
        uint8_t shift;
    } examples[] = {{QV_STORAGE_RGBA8, 0, 16123706, 2147483648u, 23},
                    {QV_STORAGE_RGBA8, 65536, 1u << 23, 2147483648u, 23},
                    {QV_STORAGE_RGBA8, 81920, 16123706, 3302134988u, 23},
                    {QV_STORAGE_RGBA8, 2147495993u, 1u << 31, 4294942608u, 31},
                    {QV_STORAGE_RGBA8, 16, 1u << 23, 2147483648u, 11},
                    {QV_STORAGE_RGBT8, 65536, 1u << 23, 2147516416u, 15},
                    {QV_STORAGE_RGBT8, 200000, 16123706, 3149209381u, 13},
                    {QV_STORAGE_RGBT8, 1, 1u << 19, 2147516416u, 35},
                    {QV_STORAGE_RGBT8, 268435455, 1u << 23, 2147516408u, 3}};
    (void)state;

    for (unsigned i = 0; i < sizeof examples / sizeof examples[0]; i++) {
        qv_thickness thickness;
        qv_volume v;
        memset(&v, 0, sizeof v);
        v.storage = examples[i].storage;
        v.unit_distance = v.extinction = examples[i].number;
        assert_int_equal(qv_thickness_of(&thickness, &v, examples[i].length), QV_OK);
        assert_int_equal(thickness.factor, examples[i].factor);
        assert_int_equal(thickness.shift, examples[i].shift);
    }
}

static void S102_byte_of_a_depth(void **state)
{
    (void)state;

    assert_int_equal(qv_attenuation_byte(0x400000), 255);
    assert_int_equal(qv_attenuation_byte(12345678), 254);
    assert_int_equal(qv_attenuation_byte(0x100000000), 128);
    assert_int_equal(qv_attenuation_byte(0x8FE8C86D2), 1);
    assert_int_equal(qv_attenuation_byte(0x8FE8C86D3), 0);
}

/* ---- A volume ---- */

static const struct {
    uint8_t direction;
    uint32_t unit_distance;
    uint8_t bytes[12]; /* S103 */
    uint32_t blocks[2];
    uint8_t level_1[2], level_2; /* S104 */
} examples[] = {{12,
                 0,
                 {255, 255, 204, 255, 237, 157, 255, 255, 127, 255, 253, 98},
                 {502088, 14244068},
                 {252, 142},
                 208},
                {12,
                 81920,
                 {255, 255, 213, 255, 240, 173, 255, 255, 146, 255, 253, 119},
                 {401670, 11395254},
                 {253, 159},
                 217},
                {13,
                 81920,
                 {0, 0, 255, 112, 156, 255, 46, 81, 255, 107, 227, 255},
                 {461783214, 0},
                 {0, 255},
                 0},
                {0,
                 81920,
                 {255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 181},
                 {0, 2076270},
                 {255, 234},
                 248},
                {20,
                 81920,
                 {255, 255, 131, 255, 253, 103, 255, 255, 255, 255, 255, 255},
                 {53601, 9516531},
                 {255, 172},
                 224},
                {4,
                 81920,
                 {255, 255, 255, 255, 255, 255, 255, 226, 0, 245, 205, 184},
                 {2288312, 145141977},
                 {243, 1},
                 33}};

#define EXAMPLES (sizeof examples / sizeof examples[0])

/* The bytes and sums of an example. */
static void attenuate(uint8_t bytes[12], uint32_t blocks[2], unsigned example)
{
    static const uint16_t opacities[12] = {0, 13107, 65535, 4660, 22136, 30000,
                                           1, 32768, 50000, 600,  40000, 9000};
    const uint8_t direction = examples[example].direction;
    const qv_attenuation records = {NULL, 0, NULL, 1u << direction, {3, 2, 2}, 0};
    uint16_t voxels[12][4];
    qv_volume v;
    memset(&v, 0, sizeof v);
    memset(voxels, 0, sizeof voxels);
    for (unsigned i = 0; i < 12; i++)
        voxels[i][3] = opacities[i];
    v.voxels = (qv_address)voxels;
    v.voxels_bytes = sizeof voxels;
    v.storage = QV_STORAGE_RGBA16;
    v.unit_distance = examples[example].unit_distance;
    v.stride[0] = 8;
    v.stride[1] = 24;
    v.stride[2] = 48;
    memcpy(v.size, records.size, sizeof v.size);
    memcpy(v.spacing, spacing, sizeof v.spacing);
    assert_int_equal(
        qv_attenuate(bytes, 12, blocks, &records, &v, &qv_domain_extinction, direction), QV_OK);
}

static void S103_bytes(void **state)
{
    (void)state;

    for (unsigned i = 0; i < EXAMPLES; i++) {
        uint8_t bytes[12];
        uint32_t blocks[2];
        attenuate(bytes, blocks, i);
        assert_memory_equal(bytes, examples[i].bytes, sizeof bytes);
    }
}

static void S104_levels(void **state)
{
    static const uint16_t size[3] = {3, 2, 2};
    (void)state;

    for (unsigned i = 0; i < EXAMPLES; i++) {
        const uint8_t direction = examples[i].direction;
        const qv_attenuation two = {NULL, 0, NULL, 1u << direction, {2, 1, 1}, 0};
        const qv_attenuation one = {NULL, 0, NULL, 1u << direction, {1, 1, 1}, 0};
        uint8_t bytes[12];
        uint32_t blocks[2];
        attenuate(bytes, blocks, i);
        assert_memory_equal(blocks, examples[i].blocks, sizeof blocks);
        assert_int_equal(qv_attenuate_level(bytes, 2, &two, blocks, size, 1, direction), QV_OK);
        assert_memory_equal(bytes, examples[i].level_1, 2);
        assert_int_equal(qv_attenuate_level(bytes, 1, &one, blocks, size, 2, direction), QV_OK);
        assert_int_equal(bytes[0], examples[i].level_2);
    }
}

static void S105_a_mean_is_rounded(void **state)
{
    static const uint16_t size[3] = {1, 2, 1};
    static const qv_attenuation one = {NULL, 0, NULL, 1, {1, 1, 1}, 0};
    (void)state;

    for (uint32_t i = 0; i < 2; i++) {
        const uint32_t block = 2970476 + i;
        uint8_t byte;
        assert_int_equal(qv_attenuate_level(&byte, 1, &one, &block, size, 1, 0), QV_OK);
        assert_int_equal(byte, 200 - i);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S100_steps),           cmocka_unit_test(S101_thickness),
        cmocka_unit_test(S102_byte_of_a_depth), cmocka_unit_test(S103_bytes),
        cmocka_unit_test(S104_levels),          cmocka_unit_test(S105_a_mean_is_rounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
