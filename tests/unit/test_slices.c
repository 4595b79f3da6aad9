/*
 * Slices: what each shows of the volume, against the reference; that together they show the
 * picture; that parts of a frame have the bytes of the whole; and which of them a rectangle sees.
 */
#include "blend_model.h"
#include "check.h"
#include "length_samplings.h"
#include "reference.h"
#include "slices_fixture.h"

#include <math.h>

enum { MOST_SLICES = 256 };

#define COUNT(array) (sizeof(array) / sizeof *(array))

static fixture f;

static const qv_dither rounded = {.sequence = qv_sequence_rounded};

#define BOTH(name)                                                                                 \
    {                                                                                              \
        &name, &name##_back_to_front                                                               \
    }

/* Modes that know no lengths, in both orders. */
static const qv_sampling *const step_samplings[][2] = {
    BOTH(qv_nearest_rgba8),       BOTH(qv_nearest_rgba16),       BOTH(qv_nearest_indexed8),
    BOTH(qv_nearest_indexed8_16), BOTH(qv_separate_rgba8),       BOTH(qv_separate_rgba16),
    BOTH(qv_separate_indexed8),   BOTH(qv_separate_indexed8_16), BOTH(qv_weighted_rgba8),
    BOTH(qv_weighted_rgba16),     BOTH(qv_weighted_indexed8),    BOTH(qv_weighted_indexed8_16)};

enum { STEP_SAMPLINGS = COUNT(step_samplings) };

/* A scene of any mode; every other one with an eye, which is inside the volume in every fourth. */
static qv_context make_scene(const qv_sampling *sampling, uint32_t seed)
{
    static const uint16_t phases[] = {0, 0x5555, 0xFFFF};
    fixture_make(&f, sampling, seed);
    if (sampling->by_length) {
        f.scene.volume.unit_distance = QV_ONE_Q16;
        fixture_add_pyramid(&f);
    }
    fixture_aim(&f, seed % 2 != 0 ? QUARTER_TURN : 0);
    f.scene.phase = phases[seed % COUNT(phases)];
    if (seed % 4 == 3)
        for (unsigned axis = 0; axis < 3; axis++)
            f.scene.camera.origin[axis] = f.scene.volume.size[axis] * VOXEL / 3;
    return fixture_context(&f);
}

/* ---- What a slice shows, by the reference ----------------------------------------- */

/* Light and opacity of the slices of one pixel, from `first` on. */
typedef struct expectation {
    int32_t first;
    double slice[MOST_SLICES][4];
} expectation;

static void expect(expectation *e, double number, const double sample[4])
{
    const int32_t slice = (int32_t)number - e->first;
    assert_in_range(slice, 0, MOST_SLICES - 1);
    memcpy(e->slice[slice], sample, sizeof e->slice[slice]);
}

static void expect_samples(expectation *e, const qv_scene *scene, ref_mode mode, const ref_ray *ray)
{
    for (int64_t j = 0; j < ray->count; j++) {
        double point[3], sample[4];
        ref_point(point, ray, (double)j);
        ref_round_point(point);
        ref_reconstruct(sample, &scene->volume, mode, point);
        expect(e, (double)(ray->index + j), sample);
    }
}

static void expect_pieces(expectation *e, const qv_scene *scene, ref_mode mode, const ref_ray *ray)
{
    ref_piece piece = ref_first_piece(ray);
    while (ref_next_piece(&piece, ray, 1, HUGE_VAL)) {
        const double middle = (piece.begin + piece.end) / 2, length = piece.end - piece.begin;
        double point[3], sample[4];
        ref_point(point, ray, middle);
        ref_round_point(point);
        ref_reconstruct(sample, &scene->volume, mode, point);
        ref_weigh(sample, &scene->volume, mode, length * scene->camera.step / QV_ONE_Q16);
        expect(e, floor(ref_grid(ray, middle)), sample);
    }
}

/* Weights have 16 fraction bits. A slice that is hardly there may not be blended at all. */
static void check_note(const note *n, const double expected[4])
{
    const double least = 1e-9, most = 4e-5;
    if (n->count == 0) {
        assert_true(expected[3] < least);
        return;
    }
    assert_int_equal(n->count, 1);
    assert_true(fabs(n->fragment.opacity / 4294967295.0 - expected[3]) < most);
    for (unsigned c = 0; c < 3; c++)
        assert_true(fabs(n->fragment.light[c] / (double)FX_LIGHT_ONE - expected[c]) < most);
}

static void check_pixels(expectation all[FIXTURE_HEIGHT][FIXTURE_WIDTH], notes of, int32_t slice)
{
    for (int32_t y = 0; y < FIXTURE_HEIGHT; y++)
        for (int32_t x = 0; x < FIXTURE_WIDTH; x++)
            check_note(&of[y][x], all[y][x].slice[slice - all[y][x].first]);
}

static void slices_are_those_of_the_reference(const qv_sampling *sampling, ref_mode mode,
                                              uint32_t seed)
{
    static expectation all[FIXTURE_HEIGHT][FIXTURE_WIDTH];
    static notes of;
    const qv_context context = make_scene(sampling, seed);
    int32_t first, end;
    assert_int_equal(qv_slice_range(&first, &end, &context, &fixture_frame), QV_OK);
    assert_in_range(end - first, 5, MOST_SLICES);
    memset(all, 0, sizeof all);
    for (int32_t y = 0; y < FIXTURE_HEIGHT; y++)
        for (int32_t x = 0; x < FIXTURE_WIDTH; x++) {
            ref_ray ray;
            ref_stored_ray(&ray, &f.scene, x, y);
            all[y][x].first = first;
            if (ref_is_by_length(mode))
                expect_pieces(&all[y][x], &f.scene, mode, &ray);
            else
                expect_samples(&all[y][x], &f.scene, mode, &ray);
        }
    for (int32_t slice = first; slice < end; slice++) {
        take_notes(of, &context, slice);
        check_pixels(all, of, slice);
    }
}

static void slices_of_samples(void **state)
{
    static const ref_mode modes[3] = {REF_NEAREST, REF_SEPARATE, REF_WEIGHTED};
    (void)state;

    for (unsigned i = 0; i < STEP_SAMPLINGS; i++)
        for (uint32_t seed = 1; seed <= 4; seed++)
            for (unsigned order = 0; order < 2; order++)
                slices_are_those_of_the_reference(step_samplings[i][order], modes[i / STORAGES],
                                                  seed);
}

static void slices_of_stretches(void **state)
{
    static const ref_mode modes[LENGTH_MODES] = {REF_CORRECTED,  REF_BSPLINE_WEIGHTED,
                                                 REF_EXTINCTION, REF_BSPLINE_EXTINCTION,
                                                 REF_EXTINCTION, REF_BSPLINE_EXTINCTION};
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++)
        for (uint32_t seed = 1; seed <= 4; seed++) {
            const length_sampling *of = &length_samplings[i];
            const qv_sampling *const orders[3] = {of->front, of->back, of->levels};
            slices_are_those_of_the_reference(orders[(i + seed) % 3], modes[i / STORAGES], seed);
        }
}

/* ---- The picture --------------------------------------------------------------------- */

/* How far the picture by slices may be from that by rays. */
static void expect_picture(const qv_context *context, const qv_blend *blend, int most)
{
    static frame by_slices;
    fixture_pixels is, expected;
    fixture_render(expected, &f);
    frame_make(&by_slices, blend, 0);
    frame_render(&by_slices, &rounded, context, &fixture_frame);
    frame_read(is, &by_slices, context);
    for (unsigned i = 0; i < sizeof is; i++) {
        const int off = (&is[0][0][0])[i] - (&expected[0][0][0])[i];
        assert_true(i % 4 == 3 && blend == &qv_over_rgb24 ? is[0][0][3] == 255
                                                          : off <= most && off >= -most);
    }
}

/* Without the opacity, black is behind all. Of pyramids, the volume and what of level 1 is blended
   with it: coarser levels have longer stretches, which slices sample step by step. */
static void expect_pictures(const qv_sampling *sampling, uint32_t seed)
{
    static const uint8_t background[4] = {200, 10, 90, 128};
    (void)make_scene(sampling, seed);
    memcpy(f.scene.background, background, sizeof background);
    f.scene.level = sampling->by_length ? (uint16_t)(50 * seed) : 0;
    const qv_context context = fixture_context(&f);
    expect_picture(&context, &qv_over_rgba24, 1);
    expect_picture(&context, &qv_over_rgb24, 1);
    expect_picture(&context, &qv_under_rgb24, 1);
    expect_picture(&context, &qv_over_rgba16, 8); /* rounded, not dithered */
}

static void slices_make_the_picture(void **state)
{
    (void)state;
    for (unsigned i = 0; i < STEP_SAMPLINGS; i++)
        for (uint32_t seed = 1; seed <= 4; seed++)
            expect_pictures(step_samplings[i][seed / 2 % 2], seed);
    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++)
        for (uint32_t seed = 1; seed <= 4; seed++) {
            const length_sampling *of = &length_samplings[i];
            const qv_sampling *const orders[3] = {of->front, of->back, of->levels};
            expect_pictures(orders[(i + seed) % 3], seed);
        }
}

/* ---- Parts ---------------------------------------------------------------------------- */

static qv_dither any_dither(unsigned i)
{
    static qv_sequence *const sequences[] = {qv_sequence_blocks, qv_sequence_golden,
                                             qv_sequence_hash};
    static const qv_technique *const techniques[] = {&qv_technique_corrected, &qv_technique_bumped,
                                                     &qv_technique_ordered, &qv_technique_random};
    const qv_dither dither = {.sequence = sequences[i % COUNT(sequences)],
                              .technique = techniques[i % COUNT(techniques)],
                              .frame = 3 * i,
                              .period = (uint8_t)(2 + i),
                              .still = i % 5 == 0};
    return dither;
}

static void render_parts(frame *into, const qv_dither *dither, const qv_context *context,
                         int32_t width, int32_t height)
{
    for (int32_t y = 0; y < FIXTURE_HEIGHT; y += height)
        for (int32_t x = 0; x < FIXTURE_WIDTH; x += width) {
            qv_rect part = {x, y, x + width, y + height};
            part.right = part.right < FIXTURE_WIDTH ? part.right : FIXTURE_WIDTH;
            part.bottom = part.bottom < FIXTURE_HEIGHT ? part.bottom : FIXTURE_HEIGHT;
            frame_render(into, dither, context, &part);
        }
}

/* Whatever is handed out last is nothing: there, only that all of the memory is written. */
static void parts_have_the_bytes_of_the_whole(void **state)
{
    static const int32_t sizes[][2] = {{FIXTURE_WIDTH, 1}, {FIXTURE_WIDTH, 4}, {5, 3}, {1, 1}};
    static frame whole, parts;
    (void)state;

    for (unsigned i = 0; i < MODELS; i++)
        for (unsigned s = 0; s < COUNT(sizes); s++) {
            const qv_dither dither = any_dither(i + s);
            const qv_context context = make_scene(
                i % 2 != 0 ? &qv_weighted_rgba8 : &qv_extinction_rgbt16_back_to_front, i + s);
            frame_make(&whole, models[i].blend, s % 2 != 0);
            frame_make(&parts, models[i].blend, s % 2 != 0);
            frame_render(&whole, &dither, &context, &fixture_frame);
            render_parts(&parts, &dither, &context, sizes[s][0], sizes[s][1]);
            assert_memory_equal(parts.pixels, whole.pixels, sizeof whole.pixels);
            assert_memory_equal(parts.beside, whole.beside, sizeof whole.beside);
        }
}

/* Whether the bytes around the rows' pixels still are what they were. */
static int gaps_untouched(const uint8_t *plane, size_t row)
{
    int untouched = fixture_untouched(plane, FRAME_GAP);
    for (size_t y = 0; y < FIXTURE_HEIGHT; y++)
        untouched &= fixture_untouched(plane + FRAME_GAP + y * (row + FRAME_GAP) + row, FRAME_GAP);
    const size_t end = FRAME_GAP + FIXTURE_HEIGHT * (row + FRAME_GAP);
    return untouched && fixture_untouched(plane + end, FRAME_BYTES - end);
}

static void no_byte_around_the_pixels_is_touched(void **state)
{
    static frame of;
    (void)state;

    for (unsigned i = 0; i < 2 * MODELS; i++) {
        const qv_dither dither = any_dither(i);
        const qv_context context = make_scene(&qv_weighted_rgba8, i);
        const blend_model *model = &models[i / 2];
        frame_make(&of, model->blend, i % 2 != 0);
        frame_render(&of, &dither, &context, &fixture_frame);
        assert_true(gaps_untouched(of.pixels, (size_t)model->bytes * FIXTURE_WIDTH));
        assert_true(gaps_untouched(of.beside, (size_t)model->beside * FIXTURE_WIDTH));
    }
}

static void rows_may_run_upwards(void **state)
{
    static frame down, up;
    (void)state;

    for (unsigned i = 0; i < MODELS; i++) {
        const qv_dither dither = any_dither(i);
        const qv_context context = make_scene(&qv_weighted_rgba8, i);
        fixture_pixels pixels_down, pixels_up;
        frame_make(&down, models[i].blend, 0);
        frame_make(&up, models[i].blend, 1);
        frame_render(&down, &dither, &context, &fixture_frame);
        frame_render(&up, &dither, &context, &fixture_frame);
        frame_read(pixels_down, &down, &context);
        frame_read(pixels_up, &up, &context);
        assert_memory_equal(pixels_up, pixels_down, sizeof pixels_down);
    }
}

/* ---- Moments --------------------------------------------------------------------------- */

/* Each pixel's dither value is that of its place, of the slice and of the frame. */
static void dither_goes_by_place_slice_and_frame(void **state)
{
    static notes of;
    const qv_context context = make_scene(&qv_nearest_rgba8, 2);
    unsigned seen = 0;
    (void)state;

    for (int32_t slice = -4; slice < 4; slice++)
        for (unsigned still = 0; still < 2; still++) {
            const qv_rect part = {-3, 2, -3 + FIXTURE_WIDTH, 2 + FIXTURE_HEIGHT};
            const qv_dither dither = {
                .sequence = qv_sequence_golden, .frame = 7, .still = (uint8_t)still};
            const qv_buffer b = {
                .pixels = of, .bytes = sizeof of, .stride = sizeof of[0], .blend = &probe};
            assert_int_equal(qv_clear(&b, &context, &part), QV_OK);
            assert_int_equal(qv_slice(&b, &dither, &context, &part, slice), QV_OK);
            for (uint32_t y = 0; y < FIXTURE_HEIGHT; y++)
                for (uint32_t x = 0; x < FIXTURE_WIDTH; x++) {
                    uint32_t u = 0x9E3779B9u * (0x400000 - (uint32_t)slice + 7 + 7 * 1024);
                    if (!still)
                        u += 0xC13FA9A9u * (x - 3) + 0x91E10DA6u * (y + 2);
                    assert_true(of[y][x].count == 0 || of[y][x].u == u);
                    seen += of[y][x].count;
                }
        }
    assert_true(seen > 500);
}

/* Front to back, pixels that let no more through than the scene's termination are done. */
static void closed_pixels_take_no_more(void **state)
{
    static frame before, after;
    (void)state;

    make_scene(&qv_weighted_rgba8, 2);
    f.scene.termination = 0x6000;
    const qv_context context = fixture_context(&f);
    unsigned closed = 0, open = 0;
    frame_make(&before, &qv_under_rgb16, 0);
    frame_render(&before, &rounded, &context, &fixture_frame);
    after = before;
    const qv_buffer b = frame_part(&after, &fixture_frame),
                    was = frame_part(&before, &fixture_frame);
    for (int32_t slice = -8; slice < 8; slice++)
        assert_int_equal(qv_slice(&b, &rounded, &context, &fixture_frame, slice), QV_OK);
    for (ptrdiff_t y = 0; y < FIXTURE_HEIGHT; y++)
        for (ptrdiff_t x = 0; x < FIXTURE_WIDTH; x++) {
            const ptrdiff_t at = y * b.beside_stride + 3 * x;
            const uint64_t old = model_bits((const uint8_t *)was.beside + at, 0, 24);
            const uint64_t now = model_bits((const uint8_t *)b.beside + at, 0, 24);
            closed += old <= 0x600000;
            open += now < old;
            assert_true(old > 0x600000 || now == old);
        }
    assert_true(closed > 10 && open > 10);
}

/* Exactly at the threshold, and a unit above. */
static void the_threshold_is_closed(void **state)
{
    (void)state;
    make_scene(&qv_weighted_rgba8, 2);
    memset(f.voxels, 200, sizeof f.voxels);
    f.scene.termination = 0x6000;
    const qv_context context = fixture_context(&f);
    const qv_rect centre = {FIXTURE_WIDTH / 2, FIXTURE_HEIGHT / 2, FIXTURE_WIDTH / 2 + 1,
                            FIXTURE_HEIGHT / 2 + 1};
    for (uint8_t above = 0; above < 2; above++) {
        const uint8_t before[3] = {above, 0, 0x60};
        uint8_t pixel[3] = {0, 0, 0}, transmittance[3] = {above, 0, 0x60};
        const qv_buffer b = {.pixels = pixel,
                             .beside = transmittance,
                             .bytes = 3,
                             .beside_bytes = 3,
                             .blend = &qv_under_rgb888};
        assert_int_equal(qv_slice(&b, &rounded, &context, &centre, 0), QV_OK);
        assert_int_equal(memcmp(transmittance, before, 3) != 0, above);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slices_of_samples),
        cmocka_unit_test(slices_of_stretches),
        cmocka_unit_test(slices_make_the_picture),
        cmocka_unit_test(parts_have_the_bytes_of_the_whole),
        cmocka_unit_test(no_byte_around_the_pixels_is_touched),
        cmocka_unit_test(rows_may_run_upwards),
        cmocka_unit_test(dither_goes_by_place_slice_and_frame),
        cmocka_unit_test(closed_pixels_take_no_more),
        cmocka_unit_test(the_threshold_is_closed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
