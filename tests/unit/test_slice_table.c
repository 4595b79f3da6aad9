/*
 * Slices through a dither table: each pixel blends the entry of the voxel that nearest sampling
 * sees, at the place that qv_dither_table_place tells.
 */
#include "scene_fixture.h"

#define PERIOD 13

static qv_transfer transfer;
static uint8_t entries[1024 * PERIOD];

static const qv_dither dither = {.frame = 7, .period = 5};

static qv_dither_table make_table(void)
{
    const qv_dither of_table = {.period = PERIOD};
    const qv_dither_table table = {entries, sizeof entries, PERIOD, 4};
    uint32_t seed = 5;
    for (unsigned i = 0; i < QV_PALETTE_ENTRIES * 4; i++) /* half of the opacities below 5 levels */
        transfer.rgba[i / 4][i % 4] = (uint16_t)(random_next(&seed) >> (i % 8 == 7 ? 22 : 16));
    assert_int_equal(
        qv_dither_table_build(entries, sizeof entries, 4, &of_table, &transfer, 0, 256), QV_OK);
    return table;
}

static qv_buffer buffer_of(fixture_pixels pixels, const qv_blend *blend)
{
    const qv_buffer buffer = {pixels, NULL, sizeof(fixture_pixels), 0, FIXTURE_WIDTH * 4, 0, blend};
    return buffer;
}

/* A view with any voxels, as indices. */
static void make_scene(fixture *f, qv_angle field_of_view)
{
    fixture_make(f, &qv_nearest_indexed8, 3);
    fixture_aim(f, field_of_view);
}

/* What nearest sampling sees of a slice, opaque where it is anything: the value is red. */
static void see_values(fixture_pixels seen, const fixture *f, int32_t slice)
{
    const qv_dither plain = {
        .sequence = qv_sequence_rounded, .technique = &qv_technique_rounded, .period = 2};
    const qv_buffer buffer = buffer_of(seen, &qv_hand_out_rgba8888);
    fixture opaque = *f;
    for (unsigned v = 0; v < 256; v++) {
        opaque.palette8[v][0] = (uint8_t)v;
        opaque.palette8[v][3] = 255;
    }
    opaque.scene.volume.palette = (qv_address)opaque.palette8;
    const qv_context context = fixture_context(&opaque);
    assert_int_equal(qv_slice(&buffer, &plain, &context, &fixture_frame, slice), QV_OK);
}

static const uint8_t *entry_at(const uint8_t seen[4], int32_t slice, int32_t x, int32_t y)
{
    static const uint8_t none[4] = {0, 0, 0, 0};
    const unsigned place = qv_dither_table_place(PERIOD, slice, dither.frame, x, y);
    return seen[3] == 0 ? none : &entries[4 * (256 * place + seen[0])];
}

static void expect_blended(uint8_t *pixel, const uint8_t entry[4], unsigned channels)
{
    for (unsigned c = 0; c < channels; c++)
        pixel[c] = (uint8_t)(entry[c] + (2 * pixel[c] * (255u - entry[3]) + 255) / 510);
}

/* All slices of a scene, and some beyond. */
static void check_scene(const fixture *f)
{
    fixture_pixels seen, handed, blended, expected;
    const qv_dither_table table = make_table();
    const qv_context context = fixture_context(f);
    const qv_buffer out = buffer_of(handed, &qv_hand_out_rgba8888);
    const qv_buffer over = buffer_of(blended, &qv_hardware_rgba8888);
    unsigned covered = 0;
    int32_t first, end;
    memset(blended, 40, sizeof blended);
    memset(expected, 40, sizeof expected);
    assert_int_equal(qv_slice_range(&first, &end, &context, &fixture_frame), QV_OK);
    for (int32_t k = first - 3; k < end + 3; k++) {
        see_values(seen, f, k);
        assert_int_equal(qv_slice_table(&out, &table, &dither, &context, &fixture_frame, k), QV_OK);
        assert_int_equal(qv_slice_table(&over, &table, &dither, &context, &fixture_frame, k),
                         QV_OK);
        for (int32_t y = 0; y < FIXTURE_HEIGHT; y++)
            for (int32_t x = 0; x < FIXTURE_WIDTH; x++) {
                const uint8_t *entry = entry_at(seen[y][x], k, x, y);
                assert_memory_equal(handed[y][x], entry, 4);
                expect_blended(expected[y][x], entry, 4);
                covered += seen[y][x][3] != 0;
            }
    }
    assert_memory_equal(blended, expected, sizeof expected);
    assert_true(covered > 300);
}

static void orthographic(void **state)
{
    fixture f;
    (void)state;
    make_scene(&f, 0);
    check_scene(&f);
}

static void perspective(void **state)
{
    fixture f;
    (void)state;
    make_scene(&f, QUARTER_TURN / 2);
    check_scene(&f);
}

/* Samples that lie on faces of the box and of voxels. */
static void along_an_axis(void **state)
{
    const qv_view view = fixture_view(0, 0, 0);
    fixture f;
    (void)state;
    make_scene(&f, 0);
    assert_int_equal(qv_orthographic(&f.scene.camera, &f.scene.volume, &view), QV_OK);
    check_scene(&f);
}

/* What lies behind an eye within the volume is not seen. */
static void from_within(void **state)
{
    fixture f;
    (void)state;
    make_scene(&f, QUARTER_TURN / 2);
    for (unsigned axis = 0; axis < 3; axis++)
        f.scene.camera.origin[axis] = (qv_coord)f.scene.volume.size[axis] << 31;
    check_scene(&f);
}

/* Three channels; a rectangle apart is a part of the frame. */
static void rgb_and_parts(void **state)
{
    static uint8_t whole[FIXTURE_HEIGHT][FIXTURE_WIDTH][3], parts[FIXTURE_HEIGHT][FIXTURE_WIDTH][3];
    const qv_rect rects[] = {
        {0, 0, 5, FIXTURE_HEIGHT}, {5, 0, FIXTURE_WIDTH, 4}, {5, 4, FIXTURE_WIDTH, FIXTURE_HEIGHT}};
    fixture_pixels seen;
    fixture f;
    (void)state;
    make_scene(&f, 0);
    const qv_dither_table table = make_table();
    const qv_context context = fixture_context(&f);
    qv_buffer buffer = {whole, NULL, sizeof whole, 0, sizeof whole[0], 0, &qv_hardware_rgb888};
    for (int32_t k = -3; k < 3; k++) {
        uint8_t expected[FIXTURE_HEIGHT][FIXTURE_WIDTH][3];
        memcpy(expected, whole, sizeof whole);
        see_values(seen, &f, k);
        for (int32_t i = 0; i < FIXTURE_HEIGHT * FIXTURE_WIDTH; i++) {
            const int32_t x = i % FIXTURE_WIDTH, y = i / FIXTURE_WIDTH;
            expect_blended(expected[y][x], entry_at(seen[y][x], k, x, y), 3);
        }
        buffer.pixels = whole;
        buffer.bytes = sizeof whole;
        assert_int_equal(qv_slice_table(&buffer, &table, &dither, &context, &fixture_frame, k),
                         QV_OK);
        assert_memory_equal(whole, expected, sizeof whole);
        for (unsigned i = 0; i < 3; i++) {
            buffer.pixels = parts[rects[i].top][rects[i].left];
            buffer.bytes = sizeof parts - (size_t)((uint8_t *)buffer.pixels - parts[0][0]);
            assert_int_equal(qv_slice_table(&buffer, &table, &dither, &context, &rects[i], k),
                             QV_OK);
        }
    }
    assert_memory_equal(whole, parts, sizeof whole);
}

/* `still`: every pixel reads the place of (0, 0). */
static void still_pixels_share_a_place(void **state)
{
    fixture_pixels seen, handed;
    fixture f;
    (void)state;
    make_scene(&f, 0);
    const qv_dither_table table = make_table();
    const qv_context context = fixture_context(&f);
    const qv_buffer out = buffer_of(handed, &qv_hand_out_rgba8888);
    const qv_dither still = {.frame = dither.frame, .still = 1};
    see_values(seen, &f, 1);
    assert_int_equal(qv_slice_table(&out, &table, &still, &context, &fixture_frame, 1), QV_OK);
    for (unsigned y = 0; y < FIXTURE_HEIGHT; y++)
        for (unsigned x = 0; x < FIXTURE_WIDTH; x++)
            assert_memory_equal(handed[y][x], entry_at(seen[y][x], 1, 0, 0), 4);
}

/* ---- Errors --------------------------------------------------------------- */

typedef struct arguments {
    qv_buffer buffer;
    qv_dither_table table;
    qv_context context;
    qv_rect rect;
    int32_t slice;
} arguments;

static void refuse(const arguments *a, qv_status expected)
{
    assert_int_equal(
        qv_slice_table(&a->buffer, &a->table, &dither, &a->context, &a->rect, a->slice), expected);
    assert_true(fixture_untouched(a->buffer.pixels, sizeof(fixture_pixels)));
}

static void nulls_are_refused(const arguments *a)
{
    const qv_buffer *buffer = &a->buffer;
    const qv_dither_table *table = &a->table;
    const qv_context *context = &a->context;
    assert_int_equal(qv_slice_table(NULL, table, &dither, context, &a->rect, 0), QV_ERROR_NULL);
    assert_int_equal(qv_slice_table(buffer, NULL, &dither, context, &a->rect, 0), QV_ERROR_NULL);
    assert_int_equal(qv_slice_table(buffer, table, NULL, context, &a->rect, 0), QV_ERROR_NULL);
    assert_int_equal(qv_slice_table(buffer, table, &dither, NULL, &a->rect, 0), QV_ERROR_NULL);
    assert_int_equal(qv_slice_table(buffer, table, &dither, context, NULL, 0), QV_ERROR_NULL);
    assert_true(fixture_untouched(buffer->pixels, sizeof(fixture_pixels)));
}

static void bad_calls_are_refused(void **state)
{
    static const qv_blend *const others[] = {&qv_over_rgba8888, &qv_hardware_rgb565,
                                             &qv_hardware_rgba12};
    static fixture_pixels pixels;
    fixture f;
    (void)state;
    make_scene(&f, 0);
    fixture_poison(pixels, sizeof pixels);
    const arguments good = {buffer_of(pixels, &qv_hardware_rgba8888), make_table(),
                            fixture_context(&f), fixture_frame, 0};
    arguments bad = good;
    nulls_are_refused(&good);
    bad.table.entries = NULL;
    refuse(&bad, QV_ERROR_NULL);
    bad = good, bad.rect.right = 0;
    refuse(&bad, QV_ERROR_RECT);
    bad = good, bad.buffer.bytes--;
    refuse(&bad, QV_ERROR_BUFFER);
    for (unsigned i = 0; i < sizeof others / sizeof *others; i++) {
        bad = good, bad.buffer.blend = others[i], bad.rect.right = 8;
        refuse(&bad, QV_ERROR_BUFFER);
    }
    bad = good, bad.table.entry_bytes = 1;
    refuse(&bad, QV_ERROR_SIZE);
    bad = good, bad.table.period = 65;
    refuse(&bad, QV_ERROR_SIZE);
    bad = good, bad.table.bytes--;
    refuse(&bad, QV_ERROR_SIZE);
    bad = good, bad.context.scene.volume.storage = QV_STORAGE_RGBA8;
    refuse(&bad, QV_ERROR_STORAGE);
    bad = good, bad.slice = 1 << 22;
    refuse(&bad, QV_ERROR_SLICE);
    bad = good, bad.slice = -(1 << 22) - 1;
    refuse(&bad, QV_ERROR_SLICE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(orthographic),          cmocka_unit_test(perspective),
        cmocka_unit_test(along_an_axis),         cmocka_unit_test(from_within),
        cmocka_unit_test(rgb_and_parts),         cmocka_unit_test(still_pixels_share_a_place),
        cmocka_unit_test(bad_calls_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
