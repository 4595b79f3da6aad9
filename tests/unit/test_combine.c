/*
 * Frame buffers as a whole: cleared, put in front of each other and read out, against models;
 * and calls that are refused, none of which may write anything.
 */
#include "blend_model.h"
#include "check.h"
#include "pixels.h"
#include "random.h"
#include "slices_fixture.h"

static fixture f;

static const qv_dither dither = {
    .sequence = qv_sequence_golden, .technique = &qv_technique_rounded, .frame = 11, .period = 8};

/* The dither value of a pixel of the slice of a number, by that dither. */
static uint32_t dither_value(uint32_t number, int32_t x, int32_t y)
{
    return 0x9E3779B9u * (number + 11 + 11 * 1024) + 0xC13FA9A9u * (uint32_t)x +
           0x91E10DA6u * (uint32_t)y;
}

static qv_context context_of(const uint8_t background[4])
{
    fixture_make(&f, &qv_weighted_rgba8, 1);
    memcpy(f.scene.background, background, 4);
    return fixture_context(&f);
}

/* ---- Buffers of a few pixels --------------------------------------------------------- */

enum { WIDTH = 5, HEIGHT = 3, PIXELS = WIDTH * HEIGHT };

static const qv_rect rect = {-2, 7, -2 + WIDTH, 7 + HEIGHT};

/* Packed rows, and the states in them. */
typedef struct small {
    uint8_t pixels[PIXELS * 12], beside[PIXELS * 4];
    model_pixel states[PIXELS];
} small;

static qv_buffer buffer_of(small *s, const blend_model *of)
{
    const qv_buffer buffer = {.pixels = s->pixels,
                              .beside = of->beside == 0 ? NULL : s->beside,
                              .bytes = (size_t)of->bytes * PIXELS,
                              .beside_bytes = (size_t)of->beside * PIXELS,
                              .stride = (ptrdiff_t)of->bytes * WIDTH,
                              .beside_stride = (ptrdiff_t)of->beside * WIDTH,
                              .blend = of->blend};
    return buffer;
}

/* Any states within the opacity, of share / (2^32 - 1). */
static void draw_pixel(model_pixel *p, const blend_model *of, uint32_t share, uint32_t *seed)
{
    p->transmittance = 0xFFFFFF - (share >> 8);
    p->state[3] = of->channels == 4 ? model_full(of, 3) * share / 0xFFFFFFFFu : 0;
    for (unsigned c = 0; c < 3; c++) {
        uint64_t most = of->channels == 4 ? p->state[3] : model_full(of, c);
        if (of->rule == RULE_UNDER)
            most = model_share(p->transmittance, of->fraction);
        p->state[c] = most * random_next(seed) / 0xFFFFFFFFu;
    }
}

/* The first pixel is transparent, the second opaque. */
static void draw_states(small *s, const blend_model *of, uint32_t *seed)
{
    for (unsigned i = 0; i < PIXELS; i++) {
        draw_pixel(&s->states[i], of, i < 2 ? i * 0xFFFFFFFFu : random_next(seed), seed);
        model_write(of, s->pixels + i * of->bytes, s->beside + i * of->beside, &s->states[i]);
    }
}

/* Makes the last pixel's red full, which then passes the opacity, if that is kept. */
static void raise_colour(small *s, const blend_model *of)
{
    const unsigned last = PIXELS - 1;
    s->states[last].state[0] = model_full(of, 0);
    model_write(of, s->pixels + last * of->bytes, s->beside + last * of->beside, &s->states[last]);
}

static void expect_states(const small *s, const blend_model *of)
{
    small model;
    for (unsigned i = 0; i < PIXELS; i++)
        model_write(of, model.pixels + i * of->bytes, model.beside + i * of->beside, &s->states[i]);
    assert_memory_equal(s->pixels, model.pixels, (size_t)of->bytes * PIXELS);
    assert_memory_equal(s->beside, model.beside, (size_t)of->beside * PIXELS);
}

/* ---- Combinations ---------------------------------------------------------------------- */

static void combine(small *behind, const blend_model *of, small *front, const blend_model *front_of,
                    int32_t slice)
{
    const qv_buffer b = buffer_of(behind, of), in_front = buffer_of(front, front_of);
    if (of->rule == RULE_UNDER) {
        assert_int_equal(qv_combine(&b, &in_front, &dither, &rect, slice), QV_ERROR_BUFFER);
        expect_states(behind, of);
        return;
    }
    assert_int_equal(qv_combine(&b, &in_front, &dither, &rect, slice), QV_OK);
    for (int32_t i = 0; i < PIXELS; i++) {
        const qv_fragment shown = model_shown(front_of, &front->states[i]);
        const uint32_t u =
            dither_value(0x400000 - (uint32_t)slice, rect.left + i % WIDTH, rect.top + i / WIDTH);
        model_blend(of, &behind->states[i], &shown, u, (uint32_t)model_level(shown.opacity, 255));
    }
    expect_states(behind, of);
    expect_states(front, front_of); /* stays as it was */
}

/* Each blend in front of each. */
static void pictures_are_blended_as_slices(void **state)
{
    static small behind, front;
    uint32_t seed = 1;
    (void)state;

    for (unsigned i = 0; i < MODELS; i++)
        for (unsigned j = 0; j < MODELS; j++)
            for (int32_t turn = 0; turn < 4; turn++) {
                draw_states(&behind, &models[i], &seed);
                draw_states(&front, &models[j], &seed);
                combine(&behind, &models[i], &front, &models[j], turn * 1000 - 2000);
            }
}

/* What lets all through changes nothing, and what hides all becomes the picture. */
static void ends_of_combinations(void **state)
{
    static small behind, front;
    uint32_t seed = 2;
    (void)state;

    for (unsigned i = 0; i < MODELS; i++) {
        const blend_model *of = &models[i];
        if (of->channels != 4 || of->rule != RULE_DITHERED)
            continue;
        draw_states(&behind, of, &seed);
        draw_states(&front, of, &seed);
        const small before = behind;
        combine(&behind, of, &front, of, 0);
        assert_memory_equal(behind.pixels, before.pixels, of->bytes);
        for (unsigned c = 0; c < 4; c++)
            assert_int_equal(behind.states[1].state[c], front.states[1].state[c]);
    }
}

/* ---- Clearing ----------------------------------------------------------------------------- */

/* Every opacity, with colours between black and white. */
static void clears_show_the_background(void **state)
{
    static small s;
    static const uint8_t colours[] = {0, 1, 100, 254, 255};
    (void)state;

    for (unsigned i = 0; i < MODELS * 256; i++) {
        const blend_model *of = &models[i / 256];
        const uint32_t opacity = i % 256;
        const uint8_t background[4] = {255, colours[i % 5], colours[i % 3], (uint8_t)opacity};
        const qv_context context = context_of(background);
        qv_fragment expected = {{0, 0, 0}, opacity * 0x01010101u};
        for (unsigned c = 0; c < 3; c++) {
            const uint64_t p = background[c] * opacity;
            expected.light[c] = (uint32_t)(128 * (257 * p + model_round(p, 255)));
        }
        const qv_buffer b = buffer_of(&s, of);
        assert_int_equal(qv_clear(&b, &context, &rect), QV_OK);
        for (unsigned j = 0; j < PIXELS; j++)
            s.states[j] = model_clear(of, &expected);
        expect_states(&s, of);
        for (unsigned c = 0; c < 3 && of->channels == 4; c++)
            assert_true(s.states[0].state[c] <= s.states[0].state[3]);
    }
}

/* ---- Read-out ----------------------------------------------------------------------------- */

/* A format that keeps all of what it is given. */
static void store_pixel(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)line;
    memcpy(row + column * sizeof *pixel, pixel, sizeof *pixel);
}

static const qv_format whole_pixels = {store_pixel, 8 * sizeof(qv_pixel), 0};

static void expect_channels(const qv_pixel *is, const qv_fragment *shown, const uint64_t behind[4])
{
    const uint64_t through = 0xFFFFFFFFu - shown->opacity;
    uint64_t opacity = (model_hi(shown->opacity, (uint64_t)255 << 23) + 64) >> 7;
    opacity += model_hi(through, behind[3]) >> 1;
    assert_int_equal(is->channel[3], opacity);
    for (unsigned c = 0; c < 3; c++) {
        const uint64_t level =
            (((uint64_t)shown->light[c] + 64) >> 7) + (model_hi(through, behind[c]) >> 1);
        assert_int_equal(is->channel[c], model_least(level, opacity));
    }
}

static void read_outs_show_states(void **state)
{
    static const uint8_t background[4] = {200, 10, 255, 129};
    static const uint64_t none[4] = {0, 0, 0, 0};
    static small s;
    qv_pixel pixels[HEIGHT][WIDTH];
    uint64_t levels[4]; /* of the background, with 17 fraction bits */
    uint32_t seed = 3;
    const qv_context context = context_of(background);
    const qv_image image = {pixels, sizeof pixels, sizeof pixels[0], &whole_pixels};
    (void)state;

    for (unsigned c = 0; c < 4; c++) {
        const uint64_t p = (c == 3 ? 255u : background[c]) * background[3];
        levels[c] = 2 * (257 * p + model_round(p, 255));
    }
    for (unsigned i = 0; i < MODELS * 8; i++) {
        const blend_model *of = &models[i / 8];
        const qv_buffer b = buffer_of(&s, of);
        draw_states(&s, of, &seed);
        raise_colour(&s, of);
        assert_int_equal(qv_read_out(&image, &b, &context, &rect), QV_OK);
        expect_states(&s, of);
        for (int32_t j = 0; j < PIXELS; j++) {
            const qv_fragment shown = model_shown(of, &s.states[j]);
            const qv_pixel *is = &pixels[j / WIDTH][j % WIDTH];
            expect_channels(is, &shown, of->rule == RULE_UNDER ? levels : none);
            assert_int_equal(is->x, (uint32_t)(rect.left + j % WIDTH));
            assert_int_equal(is->y, (uint32_t)(rect.top + j / WIDTH));
        }
    }
}

/* Rows of bytes that eight lines share: each bit is set or cleared alone. */
static void read_outs_in_pages(void **state)
{
    static const uint8_t black[4] = {0, 0, 0, 255};
    const qv_context context = context_of(black);
    const qv_rect tall = {0, 0, 1, 11};
    uint8_t levels[11][3] = {{0}}, page[2] = {0xFF, 0xFF};
    const qv_buffer b = {
        .pixels = levels, .bytes = sizeof levels, .stride = 3, .blend = &qv_over_rgb888};
    const qv_image image = {page, sizeof page, 1, &qv_format_mono_vertical};
    (void)state;

    memset(levels[1], 255, 3);
    memset(levels[9], 255, 3);
    assert_int_equal(qv_read_out(&image, &b, &context, &tall), QV_OK);
    assert_int_equal(page[0], 0x02);
    assert_int_equal(page[1], 0xFA);
}

/* ---- Refused -------------------------------------------------------------------------------- */

static uint8_t memory[FRAME_BYTES], beside[FRAME_BYTES], picture[FRAME_BYTES];

/* What all calls are made with. */
typedef struct arguments {
    const qv_buffer *buffer;
    const qv_dither *dither;
    const qv_context *context;
    const qv_rect *rect;
    const qv_image *image;
    int32_t slice;
} arguments;

static void expect_untouched(void)
{
    assert_true(fixture_untouched(memory, sizeof memory));
    assert_true(fixture_untouched(beside, sizeof beside));
    assert_true(fixture_untouched(picture, sizeof picture));
}

/* All that take a buffer refuse it, on whichever side of a combination it stands. */
static void expect_buffer_refused(const arguments *with, qv_status status)
{
    uint8_t one[PIXELS * 4];
    const qv_buffer good = {
        .pixels = one, .bytes = sizeof one, .stride = 4 * WIDTH, .blend = &qv_over_rgba8888};
    assert_int_equal(qv_clear(with->buffer, with->context, with->rect), status);
    assert_int_equal(qv_slice(with->buffer, with->dither, with->context, with->rect, with->slice),
                     status);
    assert_int_equal(qv_read_out(with->image, with->buffer, with->context, with->rect), status);
    fixture_poison(one, sizeof one);
    assert_int_equal(qv_combine(with->buffer, &good, with->dither, with->rect, with->slice),
                     status);
    assert_int_equal(qv_combine(&good, with->buffer, with->dither, with->rect, with->slice),
                     status);
    assert_true(fixture_untouched(one, sizeof one));
    expect_untouched();
}

static qv_buffer good_buffer(void)
{
    const qv_buffer b = {.pixels = memory,
                         .beside = beside,
                         .bytes = 3 * PIXELS,
                         .beside_bytes = 3 * PIXELS,
                         .stride = 3 * WIDTH,
                         .beside_stride = 3 * WIDTH,
                         .blend = &qv_over_rgb888_residual8};
    fixture_poison(memory, sizeof memory);
    fixture_poison(beside, sizeof beside);
    fixture_poison(picture, sizeof picture);
    return b;
}

static const qv_image good_image = {picture, 4 * PIXELS, 4 * WIDTH, &qv_format_rgba8888};

static void null_pointers(void **state)
{
    static const uint8_t none[4] = {0, 0, 0, 0};
    const qv_context context = context_of(none);
    const qv_rect *no_rect = NULL;
    const qv_buffer good = good_buffer();
    int32_t first = 1, end = 2;
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        qv_buffer b = good;
        b.pixels = i == 0 ? NULL : b.pixels;
        b.beside = i == 1 ? NULL : b.beside;
        b.blend = i == 2 ? NULL : b.blend;
        const arguments with = {i == 3 ? NULL : &b, &dither, &context, &rect, &good_image, 0};
        expect_buffer_refused(&with, QV_ERROR_NULL);
    }
    const arguments without = {&good, &dither, &context, no_rect, &good_image, 0};
    expect_buffer_refused(&without, QV_ERROR_NULL);
    assert_int_equal(qv_clear(&good, NULL, &rect), QV_ERROR_NULL);
    assert_int_equal(qv_slice(&good, &dither, NULL, &rect, 0), QV_ERROR_NULL);
    assert_int_equal(qv_slice(&good, NULL, &context, &rect, 0), QV_ERROR_NULL);
    assert_int_equal(qv_read_out(&good_image, &good, NULL, &rect), QV_ERROR_NULL);
    assert_int_equal(qv_read_out(NULL, &good, &context, &rect), QV_ERROR_NULL);
    assert_int_equal(qv_combine(&good, &good, NULL, &rect, 0), QV_ERROR_NULL);
    assert_int_equal(qv_slice_range(NULL, &end, &context, &rect), QV_ERROR_NULL);
    assert_int_equal(qv_slice_range(&first, NULL, &context, &rect), QV_ERROR_NULL);
    assert_int_equal(qv_slice_range(&first, &end, NULL, &rect), QV_ERROR_NULL);
    assert_int_equal(qv_slice_range(&first, &end, &context, NULL), QV_ERROR_NULL);
    assert_true(first == 1 && end == 2);
    expect_untouched();
}

static void rectangles(void **state)
{
    static const qv_rect rects[] = {{0, 0, 0, 3},         {3, 0, 0, 3},      {0, 3, 3, 3},
                                    {0, 3, 3, 0},         {-32768, 0, 1, 1}, {0, -32768, 1, 1},
                                    {32766, 0, 32768, 1}, {0, 0, 1, 32768}};
    static const uint8_t none[4] = {0, 0, 0, 0};
    const qv_context context = context_of(none);
    const qv_buffer good = good_buffer();
    int32_t first = 1, end = 2;
    (void)state;

    for (unsigned i = 0; i < sizeof rects / sizeof rects[0]; i++) {
        const arguments with = {&good, &dither, &context, &rects[i], &good_image, 0};
        expect_buffer_refused(&with, QV_ERROR_RECT);
        assert_int_equal(qv_slice_range(&first, &end, &context, &rects[i]), QV_ERROR_RECT);
        assert_true(first == 1 && end == 2);
    }
    const qv_rect farthest = {-32767, 32766, -32766, 32767};
    assert_int_equal(qv_slice_range(&first, &end, &context, &farthest), QV_OK);
}

/* A byte too few, and rows that overlap, of either plane. */
static void buffers_too_small(void **state)
{
    static const uint8_t none[4] = {0, 0, 0, 0};
    const qv_context context = context_of(none);
    qv_image image = good_image;
    (void)state;

    for (unsigned i = 0; i < 6; i++) {
        qv_buffer b = good_buffer();
        const arguments with = {&b, &dither, &context, &rect, &good_image, 0};
        b.bytes -= i == 0;
        b.beside_bytes -= i == 1;
        b.stride = i == 2 ? 3 * WIDTH - 1 : i == 3 ? 1 - 3 * WIDTH : b.stride;
        b.beside_stride = i == 4 ? 3 * WIDTH - 1 : i == 5 ? 0 : b.beside_stride;
        expect_buffer_refused(&with, QV_ERROR_BUFFER);
    }
    const qv_buffer good = good_buffer();
    image.bytes--;
    assert_int_equal(qv_read_out(&image, &good, &context, &rect), QV_ERROR_BUFFER);
    expect_untouched();
}

/* Of blends that keep nothing beside the pixels. */
static void what_lies_beside_may_be_nowhere(void **state)
{
    static const uint8_t none[4] = {0, 0, 0, 0};
    static small s;
    const qv_context context = context_of(none);
    (void)state;

    for (unsigned i = 0; i < MODELS; i++)
        if (models[i].beside == 0) {
            const qv_buffer b = buffer_of(&s, &models[i]);
            assert_null(b.beside);
            assert_int_equal(qv_clear(&b, &context, &rect), QV_OK);
            assert_int_equal(qv_slice(&b, &dither, &context, &rect, 0), QV_OK);
        }
}

static void dithers_and_slices(void **state)
{
    static const uint8_t none[4] = {0, 0, 0, 0};
    const qv_context context = context_of(none);
    const qv_buffer good = good_buffer();
    qv_buffer hardware = good;
    qv_dither bad = dither;
    (void)state;

    assert_int_equal(qv_slice(&good, &dither, &context, &rect, 0x400000), QV_ERROR_SLICE);
    assert_int_equal(qv_slice(&good, &dither, &context, &rect, -0x400001), QV_ERROR_SLICE);
    assert_int_equal(qv_combine(&good, &good, &dither, &rect, 0x400000), QV_ERROR_SLICE);
    hardware.blend = &qv_hardware_rgb888;
    bad.period = 1;
    bad.technique = &qv_technique_ordered;
    assert_int_equal(qv_slice(&hardware, &bad, &context, &rect, 0), QV_ERROR_DITHER);
    bad.sequence = NULL;
    assert_int_equal(qv_slice(&good, &bad, &context, &rect, 0), QV_ERROR_DITHER);
    expect_untouched();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_are_blended_as_slices),
        cmocka_unit_test(ends_of_combinations),
        cmocka_unit_test(clears_show_the_background),
        cmocka_unit_test(read_outs_show_states),
        cmocka_unit_test(read_outs_in_pages),
        cmocka_unit_test(null_pointers),
        cmocka_unit_test(rectangles),
        cmocka_unit_test(buffers_too_small),
        cmocka_unit_test(what_lies_beside_may_be_nowhere),
        cmocka_unit_test(dithers_and_slices),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
