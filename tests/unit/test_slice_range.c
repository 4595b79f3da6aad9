/*
 * The slices that a rectangle sees: brute force over all others, and what slices outside of the
 * range do to a frame buffer.
 */
#include "blend_model.h"
#include "check.h"
#include "length_samplings.h"
#include "slices_fixture.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

enum { AROUND = 12 }; /* slices beyond each end */

static fixture f;

static const qv_dither rounded = {
    .sequence = qv_sequence_rounded, .technique = &qv_technique_rounded, .period = 2};

static const uint16_t phases[] = {0, 1, 0x5555, 0x8000, 0xFFFF};
static const uint32_t steps[] = {QV_ONE_Q16 / 3, QV_ONE_Q16, 3 * QV_ONE_Q16};

static const qv_sampling *const samplings[] = {
    &qv_nearest_rgba8, &qv_weighted_rgba8_back_to_front, &qv_corrected_rgba8,
    &qv_extinction_rgba8_back_to_front, &qv_bspline_weighted_rgba8_levels};

/* A half-transparent box that fills its volume, and many ways to look at it: from within as well. */
static qv_context look(const qv_sampling *sampling, unsigned turn)
{
    static const qv_angle fields[] = {0, QUARTER_TURN, 0, QUARTER_TURN / 3};
    fixture_make(&f, sampling, 1);
    memset(f.voxels, 100, sizeof f.voxels);
    fixture_add_pyramid(&f);
    qv_view view = fixture_view(turn * 0x11111111u, turn / 3 * 0x2AAAAAABu, turn * 0x07654321u);
    view.step = steps[turn % COUNT(steps)];
    const qv_angle field = fields[turn % COUNT(fields)];
    assert_int_equal(field == 0 ? qv_orthographic(&f.scene.camera, &f.scene.volume, &view)
                                : qv_perspective(&f.scene.camera, &f.scene.volume, &view, field),
                     QV_OK);
    f.scene.phase = phases[turn % COUNT(phases)];
    if (sampling->by_length)
        f.scene.volume.unit_distance = QV_ONE_Q16;
    if (turn % 8 == 5)
        for (unsigned axis = 0; axis < 3; axis++)
            f.scene.camera.origin[axis] = f.scene.volume.size[axis] * VOXEL / 3;
    return fixture_context(&f);
}

/* The pixels that see something of a slice. */
static unsigned seen(const qv_context *context, int32_t slice)
{
    static notes of;
    unsigned count = 0;
    take_notes(of, context, slice);
    for (unsigned y = 0; y < FIXTURE_HEIGHT; y++)
        for (unsigned x = 0; x < FIXTURE_WIDTH; x++)
            count += of[y][x].count;
    return count;
}

/* Nothing is seen beyond the range, and at most two more slices within it at each end. */
static void ranges_cover_what_is_seen(void **state)
{
    (void)state;
    for (unsigned turn = 0; turn < 80; turn++) {
        const qv_context context = look(samplings[turn % COUNT(samplings)], turn);
        int32_t first = 1, end = 1, nearest = INT32_MAX, farthest = INT32_MIN;
        assert_int_equal(qv_slice_range(&first, &end, &context, &fixture_frame), QV_OK);
        assert_true(first < end);
        for (int32_t slice = first - AROUND; slice < end + AROUND; slice++)
            if (seen(&context, slice) != 0) {
                nearest = slice < nearest ? slice : nearest;
                farthest = slice > farthest ? slice : farthest;
            }
        assert_in_range(nearest - first, 0, 2);
        assert_in_range(end - 1 - farthest, 0, 2);
    }
}

/* Nor far away, up to the ends of what can be asked for. */
static void nothing_is_seen_far_away(void **state)
{
    static const int32_t far_away[] = {-0x3FFFFF, -0x200000, -1000, 1000, 0x3FFFFF};
    (void)state;

    for (unsigned turn = 0; turn < 20; turn++) {
        const qv_context context = look(samplings[turn % COUNT(samplings)], turn);
        for (unsigned i = 0; i < COUNT(far_away); i++)
            assert_int_equal(seen(&context, far_away[i]), 0);
    }
}

/* The range of a rectangle joins those of its pixels. */
static void ranges_may_be_joined(void **state)
{
    (void)state;
    for (unsigned turn = 0; turn < 20; turn++) {
        const qv_context context = look(samplings[turn % COUNT(samplings)], turn);
        int32_t first, end, joined_first = INT32_MAX, joined_end = INT32_MIN;
        assert_int_equal(qv_slice_range(&first, &end, &context, &fixture_frame), QV_OK);
        for (int32_t y = 0; y < FIXTURE_HEIGHT; y++)
            for (int32_t x = 0; x < FIXTURE_WIDTH; x++) {
                const qv_rect pixel = {x, y, x + 1, y + 1};
                int32_t one_first, one_end;
                assert_int_equal(qv_slice_range(&one_first, &one_end, &context, &pixel), QV_OK);
                if (one_first == one_end)
                    continue;
                joined_first = one_first < joined_first ? one_first : joined_first;
                joined_end = one_end > joined_end ? one_end : joined_end;
            }
        assert_int_equal(joined_first, first);
        assert_int_equal(joined_end, end);
    }
}

/* Beside the volume, behind the eye, and where a pixel has no ray. */
static void ranges_may_be_empty(void **state)
{
    const qv_rect beside = {20000, -20000, 20003, -19990};
    int32_t first = 5, end = 6;
    qv_context context = look(&qv_weighted_rgba8, 0);
    (void)state;

    assert_int_equal(qv_slice_range(&first, &end, &context, &beside), QV_OK);
    assert_int_equal(first, end);
    context = look(&qv_weighted_rgba8, 1);
    for (unsigned axis = 0; axis < 3; axis++)
        context.scene.camera.along[axis] = -context.scene.camera.along[axis];
    first = 5;
    assert_int_equal(qv_slice_range(&first, &end, &context, &fixture_frame), QV_OK);
    assert_int_equal(first, end);
    memset(context.scene.camera.along, 0, sizeof context.scene.camera.along);
    const qv_rect centre = {0, 0, 1, 1};
    first = 5;
    assert_int_equal(qv_slice_range(&first, &end, &context, &centre), QV_OK);
    assert_int_equal(first, end);
    for (int32_t slice = 0; slice < 100; slice++) {
        note n;
        const qv_buffer b = {.pixels = &n, .bytes = sizeof n, .blend = &probe};
        assert_int_equal(qv_clear(&b, &context, &centre), QV_OK);
        assert_int_equal(qv_slice(&b, &rounded, &context, &centre, slice), QV_OK);
        assert_int_equal(n.count, 0);
    }
}

/* ---- What slices outside do --------------------------------------------------------- */

static void slices_outside_change_nothing(void **state)
{
    static frame before, after;
    (void)state;

    for (unsigned i = 0; i < MODELS - 1; i++) {
        const qv_context context = look(samplings[i % COUNT(samplings)], i);
        int32_t first, end;
        assert_int_equal(qv_slice_range(&first, &end, &context, &fixture_frame), QV_OK);
        frame_make(&before, models[i].blend, 0);
        frame_render(&before, &rounded, &context, &fixture_frame);
        after = before;
        const qv_buffer b = frame_part(&after, &fixture_frame);
        for (int32_t slice = end; slice < end + 3; slice++)
            assert_int_equal(qv_slice(&b, &rounded, &context, &fixture_frame, slice), QV_OK);
        for (int32_t slice = first - 3; slice < first; slice++)
            assert_int_equal(qv_slice(&b, &rounded, &context, &fixture_frame, slice), QV_OK);
        assert_memory_equal(after.pixels, before.pixels, sizeof before.pixels);
        assert_memory_equal(after.beside, before.beside, sizeof before.beside);
    }
}

/* A slice that is handed out replaces what the memory held: by nothing where there is none. */
static void slices_outside_are_handed_out_as_nothing(void **state)
{
    uint8_t pixels[FIXTURE_HEIGHT][FIXTURE_WIDTH][4];
    const qv_context context = look(&qv_weighted_rgba8, 4);
    const qv_buffer b = {.pixels = pixels,
                         .bytes = sizeof pixels,
                         .stride = sizeof pixels[0],
                         .blend = &qv_hand_out_rgba8888};
    unsigned opaque = 0;
    (void)state;

    fixture_poison(pixels, sizeof pixels);
    assert_int_equal(qv_slice(&b, &rounded, &context, &fixture_frame, 0), QV_OK);
    for (unsigned y = 0; y < FIXTURE_HEIGHT; y++)
        for (unsigned x = 0; x < FIXTURE_WIDTH; x++) {
            assert_true(pixels[y][x][3] == 0 || pixels[y][x][3] == 100);
            opaque += pixels[y][x][3] != 0;
        }
    assert_true(opaque > 20);
    assert_int_equal(qv_slice(&b, &rounded, &context, &fixture_frame, 1000), QV_OK);
    for (unsigned y = 0; y < FIXTURE_HEIGHT; y++)
        for (unsigned x = 0; x < FIXTURE_WIDTH; x++)
            for (unsigned c = 0; c < 4; c++)
                assert_int_equal(pixels[y][x][c], 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranges_cover_what_is_seen),
        cmocka_unit_test(nothing_is_seen_far_away),
        cmocka_unit_test(ranges_may_be_joined),
        cmocka_unit_test(ranges_may_be_empty),
        cmocka_unit_test(slices_outside_change_nothing),
        cmocka_unit_test(slices_outside_are_handed_out_as_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
