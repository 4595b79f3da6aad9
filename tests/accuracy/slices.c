/*
 * Whole pictures by slices against the double-precision reference: seeded random scenes of
 * modes that know no lengths and of those that weigh by length, in frame buffers of 24, 16 and
 * 8 bits, back to front and front to back.
 */
#include "check.h"
#include "comparison.h"
#include "length_samplings.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

enum { EDGE = 14, SCENES = 24 };

/* A frame buffer, and how far the picture may be from the reference: in levels of 255 once it
   is rounded, and before that. */
typedef struct contest {
    const char *name;
    const qv_blend *blend;
    qv_sequence *sequence;
    int front_to_back;
    uint32_t most;
    double farthest;
    tally all;
} contest;

/* What qvol.h states, with half a level for the rounding of the read-out. Walls of full opacity
   show the last bits of weights, in pictures by rays too: a tenth of a level. */
static contest contests[] = {
    {"over_rgba24", &qv_over_rgba24, qv_sequence_rounded, 0, 1, .5 + .15, {0}},
    {"over_rgb24", &qv_over_rgb24, qv_sequence_rounded, 0, 1, .5 + .15, {0}},
    {"under_rgb24", &qv_under_rgb24, qv_sequence_rounded, 1, 1, .5 + .15, {0}},
    {"over_rgba16", &qv_over_rgba16, qv_sequence_blocks, 0, 1, .75 + .5, {0}},
    {"over_rgba8888_residual8",
     &qv_over_rgba8888_residual8,
     qv_sequence_blocks,
     0,
     1,
     .75 + .5,
     {0}},
    {"under_rgb16", &qv_under_rgb16, qv_sequence_blocks, 1, 1, .75 + .5, {0}},
    {"over_rgba12", &qv_over_rgba12, qv_sequence_blocks, 0, 5, 4.5 + .5, {0}},
    {"over_rgb888_residual4", &qv_over_rgb888_residual4, qv_sequence_blocks, 0, 5, 4.5 + .5, {0}},
    {"over_rgba8888", &qv_over_rgba8888, qv_sequence_blocks, 0, 37, 37, {0}},
    {"over_rgb888", &qv_over_rgb888, qv_sequence_blocks, 0, 37, 37, {0}},
    {"under_rgb888", &qv_under_rgb888, qv_sequence_blocks, 1, 48, 48, {0}},
};

enum { CONTESTS = sizeof contests / sizeof contests[0] };

static void check_status(qv_status status)
{
    assert_string_equal(qv_status_text(status), qv_status_text(QV_OK));
}

/* A rectangle in the middle of the frame, by slices, as RGBA8888. */
static void render(uint8_t pixels[EDGE][EDGE][4], const contest *of, const qv_context *context,
                   const qv_rect *rect)
{
    static uint8_t memory[EDGE * EDGE * 12], beside[EDGE * EDGE * 4];
    const qv_dither dither = {.sequence = of->sequence};
    const qv_buffer buffer = {memory,
                              beside,
                              sizeof memory,
                              sizeof beside,
                              EDGE * of->blend->bytes,
                              EDGE * of->blend->beside,
                              of->blend};
    const qv_image image = {pixels, sizeof(uint8_t[EDGE][EDGE][4]), EDGE * 4, &qv_format_rgba8888};
    int32_t first, end;
    check_status(qv_slice_range(&first, &end, context, rect));
    check_status(qv_clear(&buffer, context, rect));
    for (int32_t i = 0; i < end - first; i++)
        check_status(
            qv_slice(&buffer, &dither, context, rect, of->front_to_back ? first + i : end - 1 - i));
    check_status(qv_read_out(&image, &buffer, context, rect));
}

/* Tallies one scene in one frame buffer, over the pixels that the volume covers. */
static tally run(const contest *of, const seeded_scene *made, ref_mode mode)
{
    const int32_t left = ((int32_t)made->view.width - EDGE) / 2;
    const int32_t top = ((int32_t)made->view.height - EDGE) / 2;
    const qv_rect rect = {left, top, left + EDGE, top + EDGE};
    uint8_t pixels[EDGE][EDGE][4];
    qv_context context;
    tally scene = {0};
    check_status(qv_init(&context, &made->scene));
    render(pixels, of, &context, &rect);
    for (int32_t y = 0; y < EDGE; y++)
        for (int32_t x = 0; x < EDGE; x++) {
            ref_pixel expected;
            ref_render(&expected, &made->scene, mode, left + x, top + y);
            if (expected.opacity > 0)
                tally_pixel(&scene, pixels[y][x], &expected);
        }
    return scene;
}

/* One scene in all frame buffers; those without opacity have an opaque background. */
static void run_all(seeded_scene *made, const qv_sampling *sampling, ref_mode mode, uint32_t seed)
{
    const uint8_t background = made->scene.background[3];
    made->scene.sampling = sampling;
    for (unsigned i = 0; i < CONTESTS; i++) {
        contest *of = &contests[i];
        made->scene.background[3] = strstr(of->name, "rgba") ? background : 255;
        const tally scene = run(of, made, mode);
        if (scene.worst > of->most || scene.farthest > of->farthest) {
            (void)fprintf(stderr, "seed %" PRIu32 ", storage %d, %s:\n", seed,
                          made->scene.volume.storage, made->filling);
            tally_print(of->name, &scene);
        }
        tally_add(&of->all, &scene);
    }
}

static void check_contests(void)
{
    unsigned beyond = 0;
    for (unsigned i = 0; i < CONTESTS; i++) {
        contest *of = &contests[i];
        tally_print(of->name, &of->all);
        beyond += of->all.worst > of->most || of->all.farthest > of->farthest;
        assert_true(of->all.channels > 4 * EDGE * EDGE * SCENES);
        of->all = (tally){0};
    }
    assert_int_equal(beyond, 0);
}

static void test_steps(void **state)
{
    static const qv_sampling *const samplings[3][4] = {
        {&qv_nearest_rgba8, &qv_nearest_rgba16, &qv_nearest_indexed8, &qv_nearest_indexed8_16},
        {&qv_separate_rgba8, &qv_separate_rgba16, &qv_separate_indexed8, &qv_separate_indexed8_16},
        {&qv_weighted_rgba8, &qv_weighted_rgba16, &qv_weighted_indexed8, &qv_weighted_indexed8_16},
    };
    (void)state;
    for (uint32_t seed = 1; seed <= SCENES; seed++)
        for (unsigned storage = 0; storage < 4; storage++) {
            const unsigned mode = (seed + storage) % 3;
            const qv_sampling *sampling = samplings[mode][storage];
            seeded_scene made;
            check_status(seeded_make(&made, seed, (qv_storage)sampling->storage));
            run_all(&made, sampling, (ref_mode)(REF_NEAREST + (int)mode), seed);
            seeded_free(&made);
        }
    check_contests();
}

static void test_lengths(void **state)
{
    static const ref_mode modes[LENGTH_MODES] = {REF_CORRECTED,  REF_BSPLINE_WEIGHTED,
                                                 REF_EXTINCTION, REF_BSPLINE_EXTINCTION,
                                                 REF_EXTINCTION, REF_BSPLINE_EXTINCTION};
    (void)state;
    for (uint32_t seed = 1; seed <= SCENES; seed++)
        for (unsigned i = seed % 3; i < LENGTH_SAMPLINGS; i += 3) {
            const length_sampling *of = &length_samplings[i];
            const qv_sampling *sampling = seed % 2 != 0 ? of->front : of->back;
            seeded_scene made;
            check_status(seeded_make_by_length(&made, seed, (qv_storage)sampling->storage));
            run_all(&made, sampling, modes[i / STORAGES], seed);
            seeded_free(&made);
        }
    check_contests();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_steps),
        cmocka_unit_test(test_lengths),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
