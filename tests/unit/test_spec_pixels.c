/*
 * The worked examples S25 .. S30 and S37 of tests/SPEC.md: from light to pixels, and
 * the checksums of the version. The same inputs and results as there, written out.
 */
#include "check.h"
#include "composite.h"
#include "golden.h"
#include "pixels.h"
#include "ray.h"

#include <string.h>

#define VOXEL INT64_C(0x100000000)

#define LENGTH(array) (sizeof(array) / sizeof *(array))

/* ---- End of a ray ------------------------------------------------------------- */

enum { VOXELS = 8 };

/* The scene of S25, over these voxels: its one pixel looks along z. */
static qv_scene column_scene(const uint8_t voxels[VOXELS][4])
{
    const qv_scene scene = {
        .sampling = &qv_weighted_rgba8,
        .volume = {.voxels = voxels[0],
                   .voxels_bytes = 4 * VOXELS,
                   .stride = {4, 4, 4},
                   .size = {1, 1, VOXELS},
                   .storage = QV_STORAGE_RGBA8},
        .camera = {.projection = &qv_projection_orthographic,
                   .step = 65536,
                   .origin = {VOXEL / 2, VOXEL / 2, VOXEL / 2},
                   .across = {VOXEL, 0, 0},
                   .down = {0, VOXEL, 0},
                   .along = {0, 0, VOXEL}},
    };
    return scene;
}

static void expect_end(uint8_t opacity, uint16_t termination, uint32_t samples, uint32_t terminated)
{
    static const qv_rect one_pixel = {0, 0, 1, 1};
    uint8_t voxels[VOXELS][4], pixel[4];
    for (unsigned i = 0; i < VOXELS; i++) {
        const uint8_t rgba[4] = {255, 0, 0, opacity};
        memcpy(voxels[i], rgba, sizeof rgba);
    }
    qv_scene scene = column_scene((const uint8_t(*)[4])voxels);
    scene.termination = termination;
    const qv_image image = {pixel, sizeof pixel, sizeof pixel, &qv_format_rgba8888};
    qv_progress progress = {0, 0, 0, 0, 0};
    qv_context context;
    assert_int_equal(qv_init(&context, &scene), QV_OK);
    assert_int_equal(qv_render_some(&image, &progress, &context, &one_pixel, 1), QV_OK);
    assert_int_equal(progress.samples, samples);
    assert_int_equal(progress.terminated, terminated);
}

static void S25_end_of_a_ray(void **state)
{
    (void)state;
    expect_end(128, 6554, 4, 1);
    expect_end(128, 0, 8, 0);
    expect_end(255, 0, 1, 1);
}

/* ---- Background and read-out -------------------------------------------------- */

/* A context of the scene of S25 with another background. */
static qv_context background_context(const uint8_t background[4])
{
    static const uint8_t voxels[VOXELS][4];
    qv_scene scene = column_scene(voxels);
    qv_context context;
    memcpy(scene.background, background, 4);
    assert_int_equal(qv_init(&context, &scene), QV_OK);
    return context;
}

static const uint8_t pink[4] = {200, 10, 90, 128};

static void S26_background(void **state)
{
    static const uint8_t white[4] = {255, 255, 255, 255};
    static const uint32_t pink_levels[4] = {13158600, 657930, 5921370, 16777216};
    const qv_context context[2] = {background_context(pink), background_context(white)};
    (void)state;
    for (unsigned c = 0; c < 4; c++) {
        assert_int_equal(context[0].background[c], pink_levels[c]);
        assert_int_equal(context[1].background[c], 33423360);
    }
}

/* A sampling mode and a format of the test's own: what a ray gathers is written out
   below, and the pixel's channels are stored as they are. */
static qv_light gathered;

static void gather(qv_light *light, qv_ray *ray, const qv_context *context)
{
    qv_ray_clip(ray, context);
    if (ray->samples != 0)
        *light = gathered;
}

static void store_channels(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)column;
    (void)line;
    memcpy(row, pixel->channel, sizeof pixel->channel);
}

static void expect_channels(const qv_sampling *sampling, const uint8_t background[4], int32_t x,
                            const uint32_t expected[4])
{
    static const qv_format channels = {store_channels, 128, 0};
    const qv_sampling mode = {sampling->prepare, gather, sampling->read_out, sampling->storage, 0};
    const qv_rect rect = {x, 0, x + 1, 1};
    uint32_t pixel[4];
    const qv_image image = {pixel, sizeof pixel, sizeof pixel, &channels};
    qv_context context = background_context(background);
    context.scene.sampling = &mode;
    assert_int_equal(qv_render(&image, &context, &rect), QV_OK);
    assert_memory_equal(pixel, expected, sizeof pixel);
}

static void S27_read_out(void **state)
{
    static const qv_light narrow = {{113358066, 1011272452, 183816331}, 801354235, 0, 0};
    static const qv_light wide = {{114296125, 1019299184, 185311727}, 801262030, 0, 0};
    static const qv_light full_narrow = {{2130739199, 2130739136, 0}, 0, 0, 0};
    static const qv_light full_wide = {{2147418112, 2147418049, 0}, 0, 0, 0};
    static const uint8_t none[4] = {0, 0, 0, 0};
    static const uint32_t on_pink[4] = {3344212, 8054305, 2546505, 13605845};
    static const uint32_t alone[4] = {889478, 7932410, 1442137, 10476273};
    static const uint32_t full[4] = {16711680, 16711679, 0, 16711680};
    static const uint32_t empty[4] = {6579300, 328965, 2960685, 8388608};
    (void)state;
    gathered = narrow;
    expect_channels(&qv_weighted_rgba8, pink, 0, on_pink);
    expect_channels(&qv_weighted_rgba8, pink, 9, empty); /* beside the box */
    gathered = full_narrow;
    expect_channels(&qv_weighted_rgba8, none, 0, full);
    gathered = wide;
    expect_channels(&qv_weighted_rgba16, none, 0, alone);
    gathered = full_wide;
    expect_channels(&qv_weighted_rgba16, none, 0, full);
}

/* ---- Pixel formats ------------------------------------------------------------ */

/* The dither threshold of a position: so many of the greys k/64, k = 1 .. 63, are
   white there in monochrome. */
static uint32_t find_threshold(int32_t x, int32_t y)
{
    uint32_t white = 0;
    for (uint32_t k = 1; k < 64; k++) {
        const uint32_t level = 255 * 65536 / 64 * k;
        const qv_pixel pixel = {{level, level, level, 255 * 65536}, (uint32_t)x, (uint32_t)y};
        uint8_t byte = 0;
        qv_format_mono_horizontal.store(&byte, 0, 0, &pixel);
        white += byte >> 7;
    }
    return white;
}

/* Red of RGB565 for a level at a position. */
static uint32_t red5(uint32_t level, uint32_t x, uint32_t y)
{
    const qv_pixel pixel = {{level, level, level, 255 * 65536}, x, y};
    uint8_t bytes[2];
    qv_format_rgb565_be.store(bytes, 0, 0, &pixel);
    return bytes[0] >> 3;
}

/* Green of RGB565 where the threshold is greatest. */
static uint32_t most_green6(uint32_t level)
{
    const qv_pixel pixel = {{level, level, level, 255 * 65536}, 0, 7};
    uint8_t bytes[2];
    qv_format_rgb565_be.store(bytes, 0, 0, &pixel);
    return (bytes[0] & 7u) << 3 | bytes[1] >> 5;
}

static void S28_dither(void **state)
{
    static const uint8_t table[8][8] = {
        {0, 32, 8, 40, 2, 34, 10, 42},  {48, 16, 56, 24, 50, 18, 58, 26},
        {12, 44, 4, 36, 14, 46, 6, 38}, {60, 28, 52, 20, 62, 30, 54, 22},
        {3, 35, 11, 43, 1, 33, 9, 41},  {51, 19, 59, 27, 49, 17, 57, 25},
        {15, 47, 7, 39, 13, 45, 5, 37}, {63, 31, 55, 23, 61, 29, 53, 21},
    };
    (void)state;
    for (int32_t y = 0; y < 8; y++)
        for (int32_t x = 0; x < 8; x++)
            assert_int_equal(find_threshold(x, y), table[y][x]);
    assert_int_equal(find_threshold(-3, 5), 17);
    assert_int_equal(red5(8388608, 0, 0), 15);
    assert_int_equal(red5(8388608, 1, 7), 16);
    assert_int_equal(red5(8388608, 0, 7), 16);
    assert_int_equal(red5(534874, 0, 0), 0);
    assert_int_equal(red5(534875, 0, 0), 1);
    assert_int_equal(most_green6(16711680), 63);
    assert_int_equal(most_green6(0), 0);
}

static void S29_formats(void **state)
{
    static const qv_pixel pixel = {{3000000, 9999999, 16000000, 16711680}, 11, 2};
    static const qv_pixel dark = {{32767, 32767, 32772, 16711680}, 0, 0};
    uint8_t grey;
    static const struct {
        const qv_format *format;
        uint8_t bytes[8];
    } examples[] = {
        {&qv_format_rgba8888, {0x11, 0x11, 0x11, 0x11, 0x2E, 0x99, 0xF4, 0xFF}},
        {&qv_format_bgra8888, {0x11, 0x11, 0x11, 0x11, 0xF4, 0x99, 0x2E, 0xFF}},
        {&qv_format_rgb888, {0x11, 0x11, 0x11, 0x2E, 0x99, 0xF4, 0x11, 0x11}},
        {&qv_format_rgb565_le, {0x11, 0x11, 0xDE, 0x34, 0x11, 0x11, 0x11, 0x11}},
        {&qv_format_rgb565_be, {0x11, 0x11, 0x34, 0xDE, 0x11, 0x11, 0x11, 0x11}},
        {&qv_format_l8, {0x11, 0x83, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11}},
        {&qv_format_grey4, {0x18, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11}},
        {&qv_format_mono_horizontal, {0x51, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11}},
        {&qv_format_mono_vertical, {0x11, 0x15, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11}},
    };
    (void)state;
    for (unsigned i = 0; i < LENGTH(examples); i++) {
        uint8_t bytes[8];
        memset(bytes, 0x11, sizeof bytes);
        examples[i].format->store(bytes, 1, 2, &pixel);
        assert_memory_equal(bytes, examples[i].bytes, sizeof bytes);
    }
    qv_format_l8.store(&grey, 0, 0, &dark);
    assert_int_equal(grey, 1);
}

/* ---- A picture ---------------------------------------------------------------- */

static void fill_cube(uint8_t voxels[2][2][2][4])
{
    for (unsigned k = 0; k < 2; k++)
        for (unsigned j = 0; j < 2; j++)
            for (unsigned i = 0; i < 2; i++) {
                const uint8_t rgba[4] = {(uint8_t)(255 * i), (uint8_t)(255 * j), (uint8_t)(255 * k),
                                         (uint8_t)(64 + 16 * i + 32 * j + 64 * k)};
                memcpy(voxels[k][j][i], rgba, sizeof rgba);
            }
}

/* Renders the frame of S30; a field of view of 0 is the orthographic one. */
static qv_progress render_cube(uint8_t *pixels, const qv_format *format, qv_angle field_of_view,
                               uint8_t background)
{
    static const qv_rect frame = {0, 0, 4, 4};
    uint8_t voxels[2][2][2][4];
    qv_view view = {.pitch = 32768, .step = 32768, .width = 4, .height = 4};
    qv_scene scene = {.sampling = &qv_weighted_rgba8,
                      .phase = 0x8000,
                      .termination = 64,
                      .background = {background, background, background, background},
                      .volume = {.voxels = voxels[0][0][0],
                                 .voxels_bytes = sizeof voxels,
                                 .stride = {4, 8, 16},
                                 .size = {2, 2, 2},
                                 .storage = QV_STORAGE_RGBA8}};
    const size_t row = qv_row_bytes(format, 4);
    const qv_image image = {pixels, 4 * row, (ptrdiff_t)row, format};
    qv_progress progress = {0, 0, 0, 0, 0};
    qv_context context;
    fill_cube(voxels);
    qv_rotation(view.rotation, 0x15555555, 0x0AAAAAAB, 0);
    const qv_status status =
        field_of_view == 0 ? qv_orthographic(&scene.camera, &scene.volume, &view)
                           : qv_perspective(&scene.camera, &scene.volume, &view, field_of_view);
    assert_int_equal(status, QV_OK);
    assert_int_equal(qv_init(&context, &scene), QV_OK);
    assert_int_equal(qv_render_some(&image, &progress, &context, &frame, 16), QV_OK);
    return progress;
}

static void S30_picture(void **state)
{
    static const uint8_t flat[64] = {
        0x11, 0x1A, 0xE4, 0xE4, 0x67, 0x3F, 0xF7, 0xF7, 0xD5, 0x6A, 0xFA, 0xFA, 0xF3,
        0x97, 0xF5, 0xF5, 0x19, 0x0F, 0xC9, 0xDA, 0x73, 0x3C, 0xDD, 0xF8, 0xED, 0x23,
        0xF1, 0xFB, 0xEF, 0x7E, 0xDB, 0xEF, 0x00, 0x33, 0x40, 0xB6, 0x6D, 0x41, 0x67,
        0xE8, 0xE0, 0x29, 0x8D, 0xF0, 0xD4, 0xB1, 0x4A, 0xD9, 0x05, 0x2B, 0x00, 0xA2,
        0x65, 0x31, 0x00, 0xC7, 0xB6, 0x50, 0x00, 0xD4, 0xC7, 0x9F, 0x00, 0xCB};
    static const uint8_t deep[32] = {0xBF, 0x39, 0x5F, 0xA1, 0xDF, 0xE1, 0x3F, 0xFA,
                                     0x1C, 0x4A, 0x5C, 0xA1, 0xFD, 0xE9, 0x5C, 0xFA,
                                     0xB4, 0x62, 0xF2, 0xA1, 0x52, 0xE2, 0xB4, 0xFA,
                                     0x4E, 0x8B, 0x8B, 0xAB, 0x8C, 0xF2, 0xCB, 0xFA};
    uint8_t pixels[64];
    (void)state;
    const qv_progress progress = render_cube(pixels, &qv_format_rgba8888, 0, 0);
    assert_memory_equal(pixels, flat, sizeof flat);
    assert_int_equal(progress.samples, 60);
    assert_int_equal(progress.skipped, 0);
    assert_int_equal(progress.terminated, 0);
    (void)render_cube(pixels, &qv_format_rgb565_le, 0x1C71C71C, 255);
    assert_memory_equal(pixels, deep, sizeof deep);
}

/* ---- The version -------------------------------------------------------------- */

static uint32_t sum_of_checksums(uint32_t count)
{
    uint32_t sum = 0;
    for (uint32_t i = 0; i < count; i++)
        sum += golden_checksums[i];
    return sum;
}

static void S37_golden_checksums(void **state)
{
    (void)state;
    assert_int_equal(LENGTH(golden_checksums), 304);
    assert_int_equal(sum_of_checksums(48), 0xF5D79CBAu);
    assert_int_equal(sum_of_checksums(192), 0xA8CE5637u);
    assert_int_equal(sum_of_checksums(252), 0xA8BD0057u);
    assert_int_equal(sum_of_checksums(288), 0xBD91B192u);
    assert_int_equal(sum_of_checksums(304), 0x66BA9A07u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(S25_end_of_a_ray),     cmocka_unit_test(S26_background),
        cmocka_unit_test(S27_read_out),         cmocka_unit_test(S28_dither),
        cmocka_unit_test(S29_formats),          cmocka_unit_test(S30_picture),
        cmocka_unit_test(S37_golden_checksums),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
