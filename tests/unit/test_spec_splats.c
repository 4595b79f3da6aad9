/*
 * The worked examples S110 .. S113 of tests/SPEC.md: lengths, bearings, footprints and splats. The
 * same inputs and results as there, written out.
 */
#include "bearing.h"
#include "check.h"
#include "direction.h"
#include "fx_scaled.h"
#include "kernel.h"
#include "splat.h"

#include <string.h>

static void expect_scaled(fx_scaled a, uint32_t mantissa, int exponent)
{
    assert_int_equal(a.mantissa, mantissa);
    assert_int_equal(a.exponent, exponent);
}

static void S110_lengths_and_scaled_numbers(void **state)
{
    static const uint32_t v[3][3] = {
        {3, 4, 0}, {1u << 23, 1u << 23, 1u << 23}, {1u << 31, 1u << 31, 1u << 31}};
    const fx_scaled a = {0xC0000000u, -31}, b = {0xF0000000u, -22}, c = {0xF0000000u, -30};
    (void)state;
    assert_int_equal(qv_length_of(v[0]), 5);
    assert_int_equal(qv_length_of(v[1]), 14529495);
    assert_int_equal(qv_length_of(v[2]), 3719550786u);
    expect_scaled(fx_scaled_of(5, 7), 0xA0000000u, -22);
    expect_scaled(fx_scaled_times(fx_scaled_of(5, 7), a), 0xF0000000u, -22);
    expect_scaled(fx_scaled_over(fx_scaled_of(1, 0), a), 0xAAAAA8B0u, -32);
    assert_int_equal(fx_scaled_fixed(b, 3, 0xFFFFFFFFu), 7680);
    assert_int_equal(fx_scaled_fixed(c, 3, 0xFFFFFFFFu), 30);
}

/* ---- Bearings --------------------------------------------------------------- */

static uint8_t bytes[QV_DIRECTIONS];

static qv_volume volume_of_examples(void)
{
    const qv_volume volume = {.size = {5, 6, 7},
                              .storage = QV_STORAGE_RGBA8,
                              .spacing = {65536, 81920, 131072},
                              .unit_distance = 65536};
    for (unsigned d = 0; d < QV_DIRECTIONS; d++)
        bytes[d] = (uint8_t)(255u - 9u * d);
    return volume;
}

typedef struct example {
    int32_t v[3];
    uint32_t length;
    uint8_t slot[3];
    uint32_t share[3], scale[3];
    uint32_t clear, inside;
} example;

static void expect_bearing(const example *e, uint8_t interpolation)
{
    const qv_volume volume = volume_of_examples();
    uint8_t of_eye[QV_DIRECTIONS];
    qv_compass compass;
    qv_bearing bearing;
    uint32_t length;
    memset(of_eye, 240, sizeof of_eye);
    qv_compass_of(&compass, &volume, QV_DIRECTIONS_ALL, interpolation);
    assert_int_equal(qv_bearing_of(&bearing, &length, &compass, e->v), QV_OK);
    assert_int_equal(length, e->length);
    for (unsigned i = 0; i < 3; i++) {
        assert_int_equal(bearing.share[i], e->share[i]);
        if (e->share[i] == 0)
            continue;
        assert_int_equal(bearing.scale[i], e->scale[i]);
        assert_int_equal(bearing.slot[i], e->slot[i]);
    }
    assert_int_equal(qv_bearing_transmittance(&bearing, bytes, NULL), e->clear);
    assert_int_equal(qv_bearing_transmittance(&bearing, bytes, of_eye), e->inside);
}

static void S111_sides(void **state)
{
    static const uint32_t side[3] = {838291790, 1047864738, 1676583581};
    static const uint32_t inverse[8] = {0,      1343088, 1074470, 839020,
                                        671544, 600647,  569468,  524287};
    const qv_volume volume = volume_of_examples();
    qv_compass compass;
    (void)state;
    qv_compass_of(&compass, &volume, QV_DIRECTIONS_ALL, QV_BETWEEN_LIGHT);
    assert_memory_equal(compass.side, side, sizeof side);
    for (unsigned axes = 1; axes < 8; axes++)
        assert_int_equal(compass.inverse[axes], inverse[axes]);
}

#define OBLIQUE                                                                                    \
    {                                                                                              \
        0x40000000, -0x30000000, 0x12345678                                                        \
    }
#define EDGE                                                                                       \
    {                                                                                              \
        -0x20000000, -0x60000000, 0x60000000                                                       \
    }
#define ONE                                                                                        \
    {1u << 30, 0, 0},                                                                              \
    {                                                                                              \
        1u << 19, 0, 0                                                                             \
    }

static void S111_bearings(void **state)
{
    static const example light[] = {{OBLIQUE,
                                     1244104883,
                                     {13, 11, 19},
                                     {268436137, 499886050, 305419637},
                                     {778093, 486070, 303735},
                                     0x8B91B7D7u,
                                     0x93F8488Au},
                                    {EDGE,
                                     1996755980,
                                     {0, 18, 17},
                                     {0, 715827946, 357913878},
                                     {0, 529498, 487488},
                                     0x6205EA94u,
                                     0x680B1EB8u}};
    static const example depths[] = {{OBLIQUE,
                                      1244104883,
                                      {13, 11, 19},
                                      {268436137, 499886050, 305419637},
                                      {194523, 226292, 86395},
                                      0x8950B960u,
                                      0x919C15C6u},
                                     {EDGE,
                                      1996755980,
                                      {0, 18, 17},
                                      {0, 715827946, 357913878},
                                      {0, 352998, 162495},
                                      0x61B74074u,
                                      0x67B7B040u}};
    static const example nearest[] = {
        {OBLIQUE,
         1244104883,
         {11, 0, 0},
         {1u << 30, 0, 0},
         {486070, 0, 0},
         0xA252CEEEu,
         0xABB54BE4u},
        {EDGE, 1996755980, {18, 0, 0}, {1u << 30, 0, 0}, {529498, 0, 0}, 0x5C6EFD06u, 0x6245138Cu}};
    static const example along_z = {{0, 0, 0x7FFFFFFF}, 1676583581, {21, 0, 0}, ONE,
                                    0x42424242u,        0x46666662u};
    (void)state;
    for (unsigned i = 0; i < 2; i++) {
        expect_bearing(&light[i], QV_BETWEEN_LIGHT);
        expect_bearing(&depths[i], QV_BETWEEN_DEPTHS);
        expect_bearing(&nearest[i], QV_NEAREST);
    }
    for (uint8_t way = QV_BETWEEN_LIGHT; way <= QV_BETWEEN_DEPTHS; way++)
        expect_bearing(&along_z, way);
}

/* ---- Footprints ------------------------------------------------------------- */

static void expect_weights(const qv_kernel *kernel, const uint16_t *expected, int32_t first,
                           int32_t end)
{
    qv_footprint footprint;
    int32_t from, to;
    qv_footprint_of(&footprint, kernel, 176185, 100000);
    qv_footprint_range(&from, &to, &footprint, -100, 100);
    assert_true(from == first && to == end);
    for (int32_t pixel = first; pixel < end; pixel++)
        assert_int_equal(qv_footprint_weight(&footprint, pixel), expected[pixel - first]);
}

static void S112_footprints(void **state)
{
    static const uint16_t linear[] = {1224, 17985, 25313, 5478};
    static const uint16_t quadratic[] = {3, 3123, 17276, 22037, 7306, 255};
    (void)state;
    expect_weights(&qv_kernel_linear, linear, 1, 5);
    expect_weights(&qv_kernel_quadratic, quadratic, 0, 6);
}

/* ---- Splats ----------------------------------------------------------------- */

enum { WIDTH = 16, HEIGHT = 12 };

static void scene_of_examples(qv_splat_scene *scene, const qv_splatting *splatting, qv_angle field)
{
    static const qv_lamp lamp = {{-100, -200, 300}, {65535, 30000, 0}};
    memset(scene, 0, sizeof *scene);
    scene->splatting = splatting;
    scene->kernel = &qv_kernel_linear;
    scene->domain = &qv_domain_extinction;
    scene->directions = QV_DIRECTIONS_ALL;
    scene->field_of_view = field;
    scene->volume = volume_of_examples();
    scene->view.pitch = 40000;
    scene->view.width = WIDTH;
    scene->view.height = HEIGHT;
    qv_rotation(scene->view.rotation, 0x10000000, 0x08000000, 0x01000000);
    scene->lighting.lamps[0] = lamp;
    scene->lighting.count = 1;
    for (unsigned c = 0; c < 3; c++)
        scene->lighting.ambient[c] = 10000;
    memcpy(scene->background, "\x40\x80\xC0\xFF", 4);
}

/* One voxel of the example; a pixel's sums and its levels. */
static void expect_pixel(const qv_splatting *splatting, qv_angle field, unsigned line,
                         const uint32_t sums[4], const uint8_t levels[4])
{
    static uint32_t memory[WIDTH * HEIGHT * QV_SUM_CHANNELS];
    static uint8_t pixels[WIDTH * HEIGHT * 4];
    const uint8_t entry[4] = {200, 100, 50, 128};
    const qv_freevoxel voxel = {entry, bytes, {1, 2, 3}, 0};
    const qv_sums target = {memory, sizeof memory / sizeof *memory, {0, 0, WIDTH, HEIGHT}};
    const qv_image image = {pixels, sizeof pixels, 4 * WIDTH, &qv_format_rgba8888};
    qv_splat_scene scene;
    qv_splats splats;
    scene_of_examples(&scene, splatting, field);
    assert_int_equal(qv_splat_init(&splats, &scene), QV_OK);
    assert_int_equal(qv_sums_clear(&target, &splats), QV_OK);
    assert_int_equal(qv_splat(&target, &splats, &voxel), QV_OK);
    assert_int_equal(qv_sums_read_out(&image, &target, &splats), QV_OK);
    assert_memory_equal(memory + QV_SUM_CHANNELS * (line * WIDTH + 6), sums, 4 * sizeof *sums);
    assert_memory_equal(pixels + 4 * (line * WIDTH + 6), levels, 4);
}

static void expect_sight(qv_angle field, const int64_t place[2], const uint32_t numbers[4],
                         const uint32_t scale[3])
{
    static const uint8_t slot[3] = {10, 11, 19};
    const uint16_t position[3] = {1, 2, 3};
    qv_splat_scene scene;
    qv_splats splats;
    qv_sight sight;
    scene_of_examples(&scene, &qv_splatting_added, field);
    assert_int_equal(qv_splat_init(&splats, &scene), QV_OK);
    expect_scaled(qv_splats_number(&splats, QV_WIDTH), 0xDA295076u, -31);
    expect_scaled(qv_splats_number(&splats, QV_HEIGHT), 0xCF30EF31u, -30);
    assert_true(splats.factor == 2750644864u && splats.shift == 22);
    assert_true(splats.across[0] == 3256079562 && splats.across[1] == 1663098708 &&
                splats.across[2] == -169375289);
    assert_true(qv_sight_of(&sight, &splats, position, 0));
    assert_true(sight.x == place[0] && sight.y == place[1]);
    assert_true(sight.width == numbers[0] && sight.height == numbers[1]);
    assert_true(sight.gain == numbers[2] && sight.length == numbers[3]);
    assert_memory_equal(sight.viewer.slot, slot, sizeof slot);
    assert_memory_equal(sight.viewer.scale, scale, 3 * sizeof *scale);
    if (field != 0)
        assert_true(splats.eye[0] == 672360 && splats.eye[1] == -1298578 &&
                    splats.eye[2] == 174740);
}

static void S113_splats(void **state)
{
    static const int64_t places[2][2] = {{366775, 367591}, {365007, 367692}};
    static const uint32_t numbers[2][4] = {{111698, 212163, 942974070, 1156420917},
                                           {113281, 215170, 908074862, 1205332831}};
    static const uint32_t scales[2][3] = {{578602, 451812, 282328}, {603075, 470922, 294270}};
    static const uint32_t added[2][4] = {{1670533, 504439, 112602, 3763049},
                                         {1610098, 486189, 108528, 3626913}};
    static const uint32_t over[2][4] = {{4953302, 6941379, 9738814, 16711680},
                                        {4942096, 6962746, 9780805, 16711680}};
    static const uint8_t levels[2][2][4] = {{{75, 107, 150, 255}, {76, 106, 149, 255}},
                                            {{75, 108, 152, 255}, {75, 106, 149, 255}}};
    static const qv_angle fields[2] = {0, 0x15555555};
    (void)state;
    for (unsigned i = 0; i < 2; i++) {
        expect_sight(fields[i], places[i], numbers[i], scales[i]);
        expect_pixel(&qv_splatting_added, fields[i], 6, added[i], levels[i][0]);
        expect_pixel(&qv_splatting_over, fields[i], 7, over[i], levels[i][1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S110_lengths_and_scaled_numbers),
        cmocka_unit_test(S111_sides),
        cmocka_unit_test(S111_bearings),
        cmocka_unit_test(S112_footprints),
        cmocka_unit_test(S113_splats),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
