/*
 * Rendering: the same bytes in whatever parts a frame is rendered, pictures whose
 * pixels are known, and what formats are given to store.
 */
#include "check.h"
#include "length_samplings.h"
#include "pixels.h"
#include "scene_fixture.h"
#include "stretch.h"

#include <stdlib.h>

static fixture f;

/* ---- Parts of a frame ---- */

enum {
    LEFT = -3,
    TOP = -5,
    SIDE = 24, /* columns and rows, beyond the frame on all sides */
    GAP = 3,   /* bytes between rows */
    BYTES = (SIDE * 4 + GAP) * SIDE
};

static const qv_rect whole = {LEFT, TOP, LEFT + SIDE, TOP + SIDE};

static const qv_format *const formats[] = {
    &qv_format_rgba8888,  &qv_format_bgra8888,        &qv_format_rgb888,
    &qv_format_rgb565_le, &qv_format_rgb565_be,       &qv_format_l8,
    &qv_format_grey4,     &qv_format_mono_horizontal, &qv_format_mono_vertical};
enum { FORMATS = sizeof formats / sizeof formats[0] };

/* A picture of the whole rectangle in memory, its rows from the top or from the
   bottom. */
typedef struct picture {
    uint8_t bytes[BYTES];
    const qv_format *format;
    ptrdiff_t stride;
    uint8_t *first;
} picture;

static void begin(picture *p, const qv_format *format, int from_bottom)
{
    const ptrdiff_t rows = SIDE >> format->line_shift;
    const ptrdiff_t stride = (ptrdiff_t)qv_row_bytes(format, SIDE) + GAP;
    fixture_poison(p->bytes, sizeof p->bytes);
    p->format = format;
    p->stride = from_bottom ? -stride : stride;
    p->first = from_bottom ? p->bytes + stride * (rows - 1) : p->bytes;
}

/* The place of a part whose first row and column start a byte. */
static qv_image place(const picture *p, const qv_rect *part)
{
    const qv_format *format = p->format;
    const int32_t column = part->left - LEFT, line = part->top - TOP;
    const uint16_t width = (uint16_t)(part->right - part->left);
    const ptrdiff_t rows = (part->bottom - part->top - 1) >> format->line_shift;
    const qv_image image = {
        p->first + (line >> format->line_shift) * p->stride + column * format->bits / 8,
        (size_t)(rows * labs((long)p->stride)) + qv_row_bytes(format, width), p->stride, format};
    return image;
}

/* Renders the picture in parts of a size, as far as they fit. */
static void render_parts(picture *p, int32_t width, int32_t height)
{
    const qv_context context = fixture_context(&f);
    for (int32_t y = 0; y < SIDE; y += height)
        for (int32_t x = 0; x < SIDE; x += width) {
            qv_rect part = {LEFT + x, TOP + y, LEFT + x + width, TOP + y + height};
            part.right = part.right > whole.right ? whole.right : part.right;
            part.bottom = part.bottom > whole.bottom ? whole.bottom : part.bottom;
            const qv_image image = place(p, &part);
            assert_int_equal(qv_render(&image, &context, &part), QV_OK);
        }
}

/* Both cameras, so that every part of a format meets a picture of its own. */
static void make_picture_scene(unsigned i)
{
    fixture_make(&f, &qv_weighted_rgba8, 3 + i);
    fixture_aim(&f, i % 2 != 0 ? QUARTER_TURN : 0);
    f.scene.background[0] = f.scene.background[3] = 100;
}

/* Whole frame, strips, columns, tiles, and for whole bytes rows and pixels. */
static void parts_give_the_bytes_of_the_whole(void **state)
{
    static const int32_t sizes[][2] = {{SIDE, 8}, {8, SIDE}, {8, 8}, {16, 16},
                                       {SIDE, 1}, {1, 1},    {5, 7}, {1, SIDE}};
    static picture expected, parts;
    (void)state;

    for (unsigned i = 0; i < FORMATS; i++) {
        const unsigned count = formats[i]->bits % 8 == 0 && formats[i]->line_shift == 0 ? 8 : 4;
        make_picture_scene(i);
        for (int from_bottom = 0; from_bottom < 2; from_bottom++) {
            begin(&expected, formats[i], from_bottom);
            render_parts(&expected, SIDE, SIDE);
            for (unsigned s = 0; s < count; s++) {
                begin(&parts, formats[i], from_bottom);
                render_parts(&parts, sizes[s][0], sizes[s][1]);
                assert_memory_equal(parts.bytes, expected.bytes, BYTES);
            }
        }
    }
}

/* Modes that weigh by length, in turn, with thresholds that end rays. */
static void parts_by_length(void **state)
{
    static const int32_t sizes[][2] = {{SIDE, 8}, {8, SIDE}, {5, 7}};
    static picture expected, parts;
    (void)state;

    for (unsigned i = 0; i < 3 * LENGTH_SAMPLINGS; i++) {
        const length_sampling *of = &length_samplings[i % LENGTH_SAMPLINGS];
        const qv_sampling *const modes[3] = {of->front, of->back, of->levels};
        fixture_make(&f, modes[i / LENGTH_SAMPLINGS], i + 1);
        fixture_add_pyramid(&f);
        fixture_aim(&f, i % 2 != 0 ? QUARTER_TURN : 0);
        f.scene.level = (uint16_t)(i * 7);
        f.scene.level_distance = i % 2 * 4;
        f.scene.termination = 10000;
        begin(&expected, &qv_format_rgba8888, 0);
        render_parts(&expected, SIDE, SIDE);
        for (unsigned s = 0; s < 3; s++) {
            begin(&parts, &qv_format_rgba8888, 0);
            render_parts(&parts, sizes[s][0], sizes[s][1]);
            assert_memory_equal(parts.bytes, expected.bytes, BYTES);
        }
    }
}

/* Row by row from the bottom is the picture from the top upside down. */
static void rows_may_run_upwards(void **state)
{
    static picture down, up;
    (void)state;

    for (unsigned i = 0; i < FORMATS; i++) {
        const size_t row = qv_row_bytes(formats[i], SIDE);
        make_picture_scene(i);
        begin(&down, formats[i], 0);
        begin(&up, formats[i], 1);
        render_parts(&down, SIDE, SIDE);
        render_parts(&up, SIDE, SIDE);
        for (ptrdiff_t y = 0; y < SIDE >> formats[i]->line_shift; y++)
            assert_memory_equal(down.first + y * down.stride, up.first + y * up.stride, row);
    }
}

/* In pieces of any number of pixels; each call takes as many as it may, and the
   statistics grow to those of the whole. */
static void pieces_give_the_bytes_of_the_whole(void **state)
{
    static const uint32_t sizes[] = {1, 7, SIDE - 1, SIDE, SIDE + 1, 100, SIDE * SIDE, UINT32_MAX};
    static picture expected, pieces;
    qv_progress all = {0, 0, 0, 0, 0};
    (void)state;

    for (unsigned i = 0; i < FORMATS; i++)
        for (unsigned s = 0; s < sizeof sizes / sizeof sizes[0]; s++) {
            qv_progress progress = {0, 0, 0, 0, 0};
            uint32_t left = SIDE * SIDE;
            make_picture_scene(i);
            const qv_context context = fixture_context(&f);
            begin(&expected, formats[i], 0);
            begin(&pieces, formats[i], 0);
            render_parts(&expected, SIDE, SIDE);
            const qv_image image = place(&pieces, &whole);
            for (; left > sizes[s]; left -= sizes[s]) {
                assert_int_equal(qv_render_some(&image, &progress, &context, &whole, sizes[s]),
                                 QV_MORE);
                assert_int_equal((SIDE - progress.line) * SIDE - progress.column, left - sizes[s]);
            }
            assert_int_equal(qv_render_some(&image, &progress, &context, &whole, sizes[s]), QV_OK);
            assert_memory_equal(pieces.bytes, expected.bytes, BYTES);
            all = s == 0 ? progress : all;
            assert_memory_equal(&progress, &all, sizeof progress);
        }
}

/* ---- Pictures that are known ---- */

static void expect_pixels(const uint8_t rgba[4], int within_box)
{
    static fixture_pixels pixels;
    const qv_context context = fixture_context(&f);
    uint32_t compared = 0;
    fixture_render(pixels, &f);
    for (int32_t y = 0; y < FIXTURE_HEIGHT; y++)
        for (int32_t x = 0; x < FIXTURE_WIDTH; x++) {
            qv_ray ray;
            context.scene.camera.projection->ray(&ray, &context, x, y);
            qv_ray_clip(&ray, &context);
            if ((ray.samples != 0) != within_box)
                continue;
            compared++;
            assert_memory_equal(pixels[y][x], rgba, 4);
        }
    assert_true(compared > 20);
}

/* One voxel's bytes, as the storage of the mode holds them, everywhere. */
static void make_uniform(const qv_sampling *sampling, const uint8_t rgba[4])
{
    static const uint8_t background[4] = {10, 20, 30, 255};
    fixture_make(&f, sampling, 1);
    for (unsigned i = 0; i < FIXTURE_VOXELS * 4; i++) {
        if (fixture_with_opacity(sampling->storage) == QV_STORAGE_RGBA8)
            ((uint8_t *)f.voxels)[i] = rgba[i % 4];
        else
            f.voxels[i] = (uint16_t)(rgba[i % 4] * 257);
    }
    memcpy(f.scene.background, background, 4);
}

static const qv_sampling *const plain_modes[] = {&qv_nearest_rgba8,
                                                 &qv_separate_rgba8,
                                                 &qv_weighted_rgba8,
                                                 &qv_nearest_rgba16,
                                                 &qv_separate_rgba16,
                                                 &qv_weighted_rgba16,
                                                 &qv_nearest_rgba8_back_to_front,
                                                 &qv_separate_rgba16_back_to_front,
                                                 &qv_weighted_rgba8_back_to_front,
                                                 &qv_weighted_rgba16_back_to_front};
enum { PLAIN_MODES = sizeof plain_modes / sizeof plain_modes[0] };

/* Nothing of the background is left, and the colour is the stored one. */
static void opaque_is_exactly_opaque(void **state)
{
    static const uint8_t colours[3][4] = {{255, 255, 255, 255}, {0, 0, 0, 255}, {200, 100, 1, 255}};
    static const uint8_t background[4] = {10, 20, 30, 255};
    (void)state;

    for (unsigned i = 0; i < PLAIN_MODES; i++)
        for (unsigned c = 0; c < 3; c++) {
            make_uniform(plain_modes[i], colours[c]);
            expect_pixels(colours[c], 1);
            expect_pixels(background, 0);
        }
}

/* Full opacity or extinction of a depth of 64 for a 64th of a step: of ways that are as
   long, nothing of the background is left. */
static void opaque_by_length(void **state)
{
    static const uint8_t colour[4] = {255, 100, 0, 255};
    static fixture_pixels pixels;
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++) {
        const length_sampling *of = &length_samplings[i];
        uint32_t compared = 0;
        if (i % STORAGES >= 2)
            continue;
        make_uniform(i % 3 == 0 ? of->back : of->front, colour);
        f.scene.volume.unit_distance = f.scene.camera.step / 64;
        f.scene.volume.extinction = 8192 * QV_ONE_Q16;
        const qv_context context = fixture_context(&f);
        fixture_render(pixels, &f);
        for (int32_t y = 0; y < FIXTURE_HEIGHT; y++)
            for (int32_t x = 0; x < FIXTURE_WIDTH; x++) {
                qv_ray ray;
                context.scene.camera.projection->ray(&ray, &context, x, y);
                qv_path_clip(&ray, &context);
                if (ray.leave - ray.enter < QV_STEP / 64)
                    continue;
                compared++;
                assert_memory_equal(pixels[y][x], colour, 4);
            }
        assert_true(compared > 20);
    }
}

static void transparent_by_length(void **state)
{
    static const uint8_t bright[4] = {255, 255, 255, 0};
    static const uint8_t background[4] = {10, 20, 30, 255};
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++)
        if (i % STORAGES < 2) {
            make_uniform(i % 3 == 0 ? length_samplings[i].back : length_samplings[i].front, bright);
            expect_pixels(background, 1);
            make_uniform(length_samplings[i].levels, bright);
            fixture_add_pyramid(&f);
            f.scene.level = 300;
            expect_pixels(background, 1);
        }
}

static void transparent_is_the_background(void **state)
{
    static const uint8_t bright[4] = {255, 255, 255, 0}, nothing[4] = {0, 0, 0, 0};
    static const uint8_t background[4] = {10, 20, 30, 255};
    (void)state;

    for (unsigned i = 0; i < PLAIN_MODES; i++) {
        make_uniform(plain_modes[i], bright);
        expect_pixels(background, 1);
        memset(f.scene.background, 0, 4);
        expect_pixels(nothing, 1);
    }
}

/* ---- What formats are given ---- */

static qv_rect expected_place;
static uint32_t stored, bound;

/* A format that stores nothing but checks: where pixels lie in the rectangle and
   in the frame, and that no colour is above the opacity. */
static void spy(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)row;
    assert_int_equal(pixel->x, (uint32_t)expected_place.left + column);
    assert_int_equal(pixel->y, (uint32_t)expected_place.top + line);
    for (unsigned c = 0; c < 3; c++) {
        assert_true(pixel->channel[c] <= pixel->channel[3]);
        bound += pixel->channel[c] == pixel->channel[3];
    }
    assert_true(pixel->channel[3] <= 255u * 65536u);
    stored++;
}

/* White of any opacity, where roundings of light and transmittance meet. */
static void colours_stay_below_their_opacity(void **state)
{
    static const qv_format format = {spy, 0, 0};
    uint8_t nothing[1];
    const qv_image image = {nothing, 1, 0, &format};
    (void)state;

    expected_place = whole;
    stored = bound = 0;
    for (uint8_t opacity = 1; opacity < 100; opacity++) {
        const uint8_t white[4] = {255, 255, 255, opacity};
        make_uniform(plain_modes[opacity % PLAIN_MODES], white);
        memset(f.scene.background, opacity % 2 != 0 ? 255 : 0, 4);
        const qv_context context = fixture_context(&f);
        assert_int_equal(qv_render(&image, &context, &whole), QV_OK);
    }
    assert_int_equal(stored, 99 * SIDE * SIDE);
    assert_in_range(bound, 1, stored * 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_give_the_bytes_of_the_whole),
        cmocka_unit_test(parts_by_length),
        cmocka_unit_test(rows_may_run_upwards),
        cmocka_unit_test(pieces_give_the_bytes_of_the_whole),
        cmocka_unit_test(opaque_is_exactly_opaque),
        cmocka_unit_test(transparent_is_the_background),
        cmocka_unit_test(opaque_by_length),
        cmocka_unit_test(transparent_by_length),
        cmocka_unit_test(colours_stay_below_their_opacity),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
