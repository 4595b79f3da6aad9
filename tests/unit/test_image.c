/*
 * Where pixels go: refused images, rectangles and progress, none of which may
 * write anything; and which bytes accepted ones reach.
 */
#include "check.h"
#include "scene_fixture.h"

enum {
    ROWS = 5,
    COLUMNS = 6,
    ROW_BYTES = COLUMNS * 4,
    BYTES = 1024 /* more than any image here takes */
};

static const qv_rect rect = {2, 3, 2 + COLUMNS, 3 + ROWS};
static uint8_t memory[BYTES];

/* A white volume that covers the frame. */
static qv_context white_context(void)
{
    static fixture f;
    fixture_make(&f, &qv_nearest_rgba8, 1);
    memset(f.voxels, 255, sizeof f.voxels);
    memset(f.scene.background, 255, sizeof f.scene.background);
    return fixture_context(&f);
}

static qv_image rgba_image(void)
{
    const qv_image image = {memory, ROWS * ROW_BYTES, ROW_BYTES, &qv_format_rgba8888};
    fixture_poison(memory, sizeof memory);
    return image;
}

/* Both calls refuse, and leave pixels and progress as they were. */
static void expect_refused(const qv_image *image, const qv_context *context, const qv_rect *area,
                           qv_status status)
{
    const qv_progress start = {0, 0, 0, 0, 0};
    qv_progress progress = start;
    assert_int_equal(qv_render(image, context, area), status);
    assert_int_equal(qv_render_some(image, &progress, context, area, 1000), status);
    assert_memory_equal(&progress, &start, sizeof progress);
    assert_true(fixture_untouched(memory, sizeof memory));
}

/* ---- Rows ---- */

static void bytes_of_a_row(void **state)
{
    static const struct {
        const qv_format *format;
        uint16_t width;
        size_t bytes;
    } cases[] = {{&qv_format_rgba8888, 1, 4},
                 {&qv_format_rgba8888, 65535, 262140},
                 {&qv_format_bgra8888, 3, 12},
                 {&qv_format_rgb888, 5, 15},
                 {&qv_format_rgb565_le, 7, 14},
                 {&qv_format_rgb565_be, 7, 14},
                 {&qv_format_l8, 9, 9},
                 {&qv_format_grey4, 0, 0},
                 {&qv_format_grey4, 1, 1},
                 {&qv_format_grey4, 2, 1},
                 {&qv_format_grey4, 3, 2},
                 {&qv_format_mono_horizontal, 1, 1},
                 {&qv_format_mono_horizontal, 8, 1},
                 {&qv_format_mono_horizontal, 9, 2},
                 {&qv_format_mono_horizontal, 65535, 8192},
                 {&qv_format_mono_vertical, 128, 128}};
    (void)state;

    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++)
        assert_int_equal(qv_row_bytes(cases[i].format, cases[i].width), cases[i].bytes);
}

/* ---- Null pointers ---- */

static void null_pointers(void **state)
{
    const qv_context context = white_context();
    const qv_image good = rgba_image();
    qv_image image = good;
    (void)state;

    expect_refused(NULL, &context, &rect, QV_ERROR_NULL);
    expect_refused(&image, NULL, &rect, QV_ERROR_NULL);
    expect_refused(&image, &context, NULL, QV_ERROR_NULL);
    assert_int_equal(qv_render_some(&image, NULL, &context, &rect, 1), QV_ERROR_NULL);
    image.pixels = NULL;
    expect_refused(&image, &context, &rect, QV_ERROR_NULL);
    image = good;
    image.format = NULL;
    expect_refused(&image, &context, &rect, QV_ERROR_NULL);
}

/* ---- Rectangles ---- */

static void rectangles_that_are_refused(void **state)
{
    static const qv_rect bad[] = {
        {0, 0, 0, 1},
        {0, 0, 1, 0},
        {5, 0, 4, 1},
        {0, 5, 1, 4},
        {-QV_PIXEL_MAX - 1, 0, 1, 1},
        {0, -QV_PIXEL_MAX - 1, 1, 1},
        {0, 0, QV_PIXEL_MAX + 1, 1},
        {0, 0, 1, QV_PIXEL_MAX + 1},
        {INT32_MIN, 0, INT32_MAX, 1},
        {0, INT32_MIN, 1, INT32_MAX},
        {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN},
    };
    const qv_context context = white_context();
    const qv_image image = rgba_image();
    (void)state;

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++)
        expect_refused(&image, &context, &bad[i], QV_ERROR_RECT);
}

/* The four corners of all that can be asked for, one pixel each. */
static void rectangles_at_the_limits(void **state)
{
    static const int32_t first[2] = {-QV_PIXEL_MAX, QV_PIXEL_MAX - 1};
    const qv_context context = white_context();
    qv_image image = rgba_image();
    (void)state;

    image.bytes = 4;
    for (unsigned i = 0; i < 4; i++) {
        const int32_t x = first[i % 2], y = first[i / 2];
        const qv_rect pixel = {x, y, x + 1, y + 1};
        assert_int_equal(qv_render(&image, &context, &pixel), QV_OK);
        assert_int_equal(memory[3], 255);
    }
    assert_true(fixture_untouched(memory + 4, sizeof memory - 4));
}

/* ---- Progress ---- */

static void progress_outside_of_the_rectangle(void **state)
{
    static const uint16_t bad[][2] = {{COLUMNS, 0}, {65535, 0},      {0, ROWS + 1},
                                      {0, 65535},   {COLUMNS, ROWS}, {COLUMNS, ROWS - 1}};
    const qv_context context = white_context();
    const qv_image image = rgba_image();
    (void)state;

    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const qv_progress start = {bad[i][0], bad[i][1], 7, 8, 9};
        qv_progress progress = start;
        assert_int_equal(qv_render_some(&image, &progress, &context, &rect, 9), QV_ERROR_RECT);
        assert_memory_equal(&progress, &start, sizeof progress);
    }
    assert_true(fixture_untouched(memory, sizeof memory));
}

static void nothing_is_left_to_do_at_the_end(void **state)
{
    const qv_context context = white_context();
    const qv_image image = rgba_image();
    qv_progress progress = {0, ROWS, 0, 0, 0};
    (void)state;

    assert_int_equal(qv_render_some(&image, &progress, &context, &rect, 9), QV_OK);
    assert_int_equal(qv_render_some(&image, &progress, &context, &rect, 0), QV_OK);
    assert_true(fixture_untouched(memory, sizeof memory));
}

static void no_pixels_asked_for_leaves_more_to_do(void **state)
{
    const qv_context context = white_context();
    const qv_image image = rgba_image();
    qv_progress progress = {0, 0, 0, 0, 0};
    (void)state;

    assert_int_equal(qv_render_some(&image, &progress, &context, &rect, 0), QV_MORE);
    assert_int_equal(progress.column, 0);
    assert_true(fixture_untouched(memory, sizeof memory));
}

/* ---- Buffers ---- */

static void buffers_one_byte_too_small(void **state)
{
    const qv_context context = white_context();
    qv_image image = rgba_image();
    (void)state;

    for (unsigned i = 0; i < 2; i++) { /* tight rows, and rows with a gap */
        image.stride = ROW_BYTES + 3 * (ptrdiff_t)i;
        image.bytes = (size_t)image.stride * (ROWS - 1) + ROW_BYTES - 1;
        expect_refused(&image, &context, &rect, QV_ERROR_BUFFER);
    }
    image.bytes = 0;
    expect_refused(&image, &context, &rect, QV_ERROR_BUFFER);
    image.bytes = ROW_BYTES - 1;
    expect_refused(&image, &context, &rect, QV_ERROR_BUFFER);
}

static void rows_that_overlap_or_overflow(void **state)
{
    static const ptrdiff_t bad[] = {0,  1,           ROW_BYTES - 1, 1 - ROW_BYTES,
                                    -1, PTRDIFF_MAX, PTRDIFF_MIN,   BYTES};
    const qv_context context = white_context();
    qv_image image = rgba_image();
    (void)state;

    image.bytes = BYTES;
    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        image.stride = bad[i];
        expect_refused(&image, &context, &rect, QV_ERROR_BUFFER);
    }
}

/* With one row there is no next one. */
static void a_single_row_needs_no_stride(void **state)
{
    static const ptrdiff_t any[] = {0, 1, -1, PTRDIFF_MAX, PTRDIFF_MIN};
    const qv_rect row = {0, 0, COLUMNS, 1};
    const qv_context context = white_context();
    (void)state;

    for (unsigned i = 0; i < sizeof any / sizeof any[0]; i++) {
        qv_image image = rgba_image();
        image.bytes = ROW_BYTES;
        image.stride = any[i];
        assert_int_equal(qv_render(&image, &context, &row), QV_OK);
        assert_int_equal(memory[ROW_BYTES - 1], 255);
        assert_true(fixture_untouched(memory + ROW_BYTES, sizeof memory - ROW_BYTES));
    }
}

/* Eight rows of pixels share one of bytes: the ninth needs another. */
static void vertical_mono_needs_a_row_for_eight(void **state)
{
    const qv_context context = white_context();
    qv_rect area = {0, 0, COLUMNS, 8};
    qv_image image = rgba_image();
    (void)state;

    image.format = &qv_format_mono_vertical;
    image.stride = 0;
    image.bytes = COLUMNS;
    assert_int_equal(qv_render(&image, &context, &area), QV_OK);
    assert_int_equal(memory[COLUMNS - 1], 255);
    assert_true(fixture_untouched(memory + COLUMNS, sizeof memory - COLUMNS));
    area.bottom = 9;
    image = rgba_image();
    image.format = &qv_format_mono_vertical;
    image.stride = COLUMNS;
    image.bytes = 2 * COLUMNS - 1;
    expect_refused(&image, &context, &area, QV_ERROR_BUFFER);
    image.bytes++;
    assert_int_equal(qv_render(&image, &context, &area), QV_OK);
}

/* ---- What is written ---- */

/* Exactly the pixels of the rectangle, in rows of any distance and direction. */
static void only_the_rows_are_written(void **state)
{
    static const ptrdiff_t strides[4] = {ROW_BYTES, ROW_BYTES + 5, -ROW_BYTES, -ROW_BYTES - 5};
    const qv_context context = white_context();
    (void)state;

    for (unsigned i = 0; i < 4; i++) {
        const ptrdiff_t stride = strides[i], gap = stride < 0 ? -stride : stride;
        uint8_t *const lowest = memory + 100;
        qv_image image = rgba_image();
        image.pixels = stride < 0 ? lowest + gap * (ROWS - 1) : lowest;
        image.stride = stride;
        image.bytes = (size_t)gap * (ROWS - 1) + ROW_BYTES;
        assert_int_equal(qv_render(&image, &context, &rect), QV_OK);
        for (ptrdiff_t at = -100; at < BYTES - 100; at++) {
            const int inside = at >= 0 && at / gap < ROWS && at % gap < ROW_BYTES;
            assert_int_equal(lowest[at], inside ? 255 : FIXTURE_POISON);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bytes_of_a_row),
        cmocka_unit_test(null_pointers),
        cmocka_unit_test(rectangles_that_are_refused),
        cmocka_unit_test(rectangles_at_the_limits),
        cmocka_unit_test(progress_outside_of_the_rectangle),
        cmocka_unit_test(nothing_is_left_to_do_at_the_end),
        cmocka_unit_test(no_pixels_asked_for_leaves_more_to_do),
        cmocka_unit_test(buffers_one_byte_too_small),
        cmocka_unit_test(rows_that_overlap_or_overflow),
        cmocka_unit_test(a_single_row_needs_no_stride),
        cmocka_unit_test(vertical_mono_needs_a_row_for_eight),
        cmocka_unit_test(only_the_rows_are_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
