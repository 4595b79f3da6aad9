/*
 * Pixel formats against the double-precision reference: seeded scenes rendered
 * in every format, at absolute positions on either side of 0.
 */
#include "check.h"
#include "seeded.h"
#include "tally.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SCENES 40
#define EDGE   64 /* pixels of the buffer */

static const double least_equal = 0.99;

/* Pixels are compared as levels of up to four channels. */
typedef struct levels {
    uint32_t channel[4];
} levels;

typedef levels unpack(const uint8_t *pixels, size_t stride, uint32_t column, uint32_t row);
typedef levels expect(const ref_pixel *pixel, int32_t x, int32_t y);

/* ---- Bytes of a buffer to levels --------------------------------------------- */

static levels unpack_rgba8888(const uint8_t *pixels, size_t stride, uint32_t column, uint32_t row)
{
    const uint8_t *p = pixels + row * stride + 4 * (size_t)column;
    return (levels){{p[0], p[1], p[2], p[3]}};
}

static levels unpack_bgra8888(const uint8_t *pixels, size_t stride, uint32_t column, uint32_t row)
{
    const uint8_t *p = pixels + row * stride + 4 * (size_t)column;
    return (levels){{p[2], p[1], p[0], p[3]}};
}

static levels unpack_rgb888(const uint8_t *pixels, size_t stride, uint32_t column, uint32_t row)
{
    const uint8_t *p = pixels + row * stride + 3 * (size_t)column;
    return (levels){{p[0], p[1], p[2], 0}};
}

static levels split_rgb565(uint32_t word)
{
    return (levels){{word >> 11, word >> 5 & 63u, word & 31u, 0}};
}

static levels unpack_rgb565_le(const uint8_t *pixels, size_t stride, uint32_t column, uint32_t row)
{
    const uint8_t *p = pixels + row * stride + 2 * (size_t)column;
    return split_rgb565((uint32_t)p[0] | (uint32_t)p[1] << 8);
}

static levels unpack_rgb565_be(const uint8_t *pixels, size_t stride, uint32_t column, uint32_t row)
{
    const uint8_t *p = pixels + row * stride + 2 * (size_t)column;
    return split_rgb565((uint32_t)p[0] << 8 | (uint32_t)p[1]);
}

static levels unpack_l8(const uint8_t *pixels, size_t stride, uint32_t column, uint32_t row)
{
    return (levels){{pixels[row * stride + column], 0, 0, 0}};
}

static levels unpack_grey4(const uint8_t *pixels, size_t stride, uint32_t column, uint32_t row)
{
    const uint32_t byte = pixels[row * stride + column / 2];
    return (levels){{column % 2 == 0 ? byte >> 4 : byte & 15u, 0, 0, 0}};
}

static levels unpack_mono_horizontal(const uint8_t *pixels, size_t stride, uint32_t column,
                                     uint32_t row)
{
    return (levels){{pixels[row * stride + column / 8] >> (7 - column % 8) & 1u, 0, 0, 0}};
}

static levels unpack_mono_vertical(const uint8_t *pixels, size_t stride, uint32_t column,
                                   uint32_t row)
{
    return (levels){{pixels[row / 8 * stride + column] >> row % 8 & 1u, 0, 0, 0}};
}

/* ---- What the reference expects ------------------------------------------------ */

static levels expect_rgba(const ref_pixel *pixel, int32_t x, int32_t y)
{
    levels l;
    (void)x;
    (void)y;
    for (int channel = 0; channel < 4; channel++) {
        l.channel[channel] = ref_level(pixel->rgba[channel], 255);
    }
    return l;
}

static levels expect_rgb(const ref_pixel *pixel, int32_t x, int32_t y)
{
    levels l = expect_rgba(pixel, x, y);
    l.channel[3] = 0;
    return l;
}

static levels expect_rgb565(const ref_pixel *pixel, int32_t x, int32_t y)
{
    return (levels){{ref_dithered_level(pixel->rgba[0], 31, x, y),
                     ref_dithered_level(pixel->rgba[1], 63, x, y),
                     ref_dithered_level(pixel->rgba[2], 31, x, y), 0}};
}

static levels expect_l8(const ref_pixel *pixel, int32_t x, int32_t y)
{
    (void)x;
    (void)y;
    return (levels){{ref_level(ref_grey(pixel->rgba), 255), 0, 0, 0}};
}

static levels expect_grey4(const ref_pixel *pixel, int32_t x, int32_t y)
{
    return (levels){{ref_dithered_level(ref_grey(pixel->rgba), 15, x, y), 0, 0, 0}};
}

static levels expect_mono(const ref_pixel *pixel, int32_t x, int32_t y)
{
    return (levels){{ref_dithered_level(ref_grey(pixel->rgba), 1, x, y), 0, 0, 0}};
}

/* ---- Comparison ---------------------------------------------------------------- */

typedef struct format_case {
    const char *name;
    const qv_format *format;
    int channels;
    unpack *got;
    expect *expected;
} format_case;

static const format_case cases[] = {
    {"rgba8888", &qv_format_rgba8888, 4, unpack_rgba8888, expect_rgba},
    {"bgra8888", &qv_format_bgra8888, 4, unpack_bgra8888, expect_rgba},
    {"rgb888", &qv_format_rgb888, 3, unpack_rgb888, expect_rgb},
    {"rgb565_le", &qv_format_rgb565_le, 3, unpack_rgb565_le, expect_rgb565},
    {"rgb565_be", &qv_format_rgb565_be, 3, unpack_rgb565_be, expect_rgb565},
    {"l8", &qv_format_l8, 1, unpack_l8, expect_l8},
    {"grey4", &qv_format_grey4, 1, unpack_grey4, expect_grey4},
    {"mono_horizontal", &qv_format_mono_horizontal, 1, unpack_mono_horizontal, expect_mono},
    {"mono_vertical", &qv_format_mono_vertical, 1, unpack_mono_vertical, expect_mono},
};

#define CASES (sizeof cases / sizeof cases[0])

static void tally_levels(tally *into, const levels *got, const levels *expected, int channels)
{
    for (int channel = 0; channel < channels; channel++) {
        const int64_t off = (int64_t)got->channel[channel] - expected->channel[channel];
        const uint32_t distance = (uint32_t)llabs(off);
        into->channels++;
        into->equal += distance == 0;
        into->worst = distance > into->worst ? distance : into->worst;
    }
}

/* A frame whose pixel (0, 0) lies inside the rectangle, so that positions have either sign. */
static void compare_case(tally *into, const format_case *of, const qv_scene *scene,
                         const qv_rect *rect, ref_pixel (*expected)[EDGE])
{
    static uint8_t pixels[EDGE * EDGE * 4];
    const size_t stride = EDGE * 4;
    const qv_image image = {pixels, sizeof pixels, (ptrdiff_t)stride, of->format};
    qv_context context;
    memset(pixels, 0, sizeof pixels);
    assert_int_equal(qv_init(&context, scene), QV_OK);
    assert_int_equal(qv_render(&image, &context, rect), QV_OK);
    for (int32_t y = rect->top; y < rect->bottom; y++) {
        for (int32_t x = rect->left; x < rect->right; x++) {
            const uint32_t column = (uint32_t)(x - rect->left), row = (uint32_t)(y - rect->top);
            const ref_pixel *reference = &expected[row][column];
            if (reference->opacity > 0) {
                const levels got = of->got(pixels, stride, column, row);
                const levels want = of->expected(reference, x, y);
                tally_levels(into, &got, &want, of->channels);
            }
        }
    }
}

/* Moves the camera so that the picture's centre comes to about pixel (0, 0). */
static void centre(qv_scene *scene, const ref_view *view, qv_rect *rect)
{
    const int32_t dx = (int32_t)view->width / 2, dy = (int32_t)view->height / 2;
    qv_camera *camera = &scene->camera;
    qv_coord *start = view->field_of_view > 0 ? camera->along : camera->origin;
    for (int axis = 0; axis < 3; axis++) {
        start[axis] += dx * camera->across[axis] + dy * camera->down[axis];
    }
    rect->left = -dx;
    rect->top = -dy;
    rect->right = (int32_t)view->width - dx;
    rect->bottom = (int32_t)view->height - dy;
}

static void compare_scene(tally found[CASES], uint32_t seed)
{
    static ref_pixel expected[EDGE][EDGE];
    seeded_scene made;
    qv_rect rect;
    assert_int_equal(seeded_make(&made, seed, QV_STORAGE_RGBA16), QV_OK);
    made.scene.sampling = &qv_weighted_rgba16;
    centre(&made.scene, &made.view, &rect);
    for (int32_t y = rect.top; y < rect.bottom; y++) {
        for (int32_t x = rect.left; x < rect.right; x++) {
            ref_pixel *pixel = &expected[y - rect.top][x - rect.left];
            ref_render(pixel, &made.scene, REF_WEIGHTED, x, y);
        }
    }
    for (size_t i = 0; i < CASES; i++) {
        compare_case(&found[i], &cases[i], &made.scene, &rect, expected);
    }
    seeded_free(&made);
}

static void test_formats(void **state)
{
    tally found[CASES];
    bool agree = true;
    (void)state;
    memset(found, 0, sizeof found);
    for (uint32_t seed = 1; seed <= SCENES; seed++) {
        compare_scene(found, seed);
    }
    for (size_t i = 0; i < CASES; i++) {
        printf("# %s: %" PRIu64 " channels, worst %" PRIu32 " levels, %.4f %% equal\n",
               cases[i].name, found[i].channels, found[i].worst, 100 * tally_share(&found[i]));
        agree = agree && found[i].channels > 100 * SCENES && found[i].worst <= 1 &&
                tally_share(&found[i]) >= least_equal;
    }
    assert_true(agree);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_formats),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
