/*
 * Statistics of rendering, and the threshold at which rays end.
 */
#include "check.h"
#include "bspline.h"
#include "length_samplings.h"
#include "sample.h"
#include "scene_fixture.h"
#include "stretch.h"

#include <math.h>
#include <stdlib.h>

static fixture f;

static qv_progress statistics(void)
{
    fixture_pixels pixels;
    const qv_context context = fixture_context(&f);
    const qv_image image = {pixels, sizeof pixels, FIXTURE_WIDTH * 4, &qv_format_rgba8888};
    qv_progress progress = {0, 0, 0, 0, 0};
    assert_int_equal(qv_render_some(&image, &progress, &context, &fixture_frame, 10000), QV_OK);
    return progress;
}

/* What there is to take: rays that meet the box, those with more than one sample,
   samples, and those of them in transparent cells. */
typedef struct inventory {
    uint32_t rays, longer, samples, transparent;
} inventory;

static void count_ray(inventory *all, qv_ray *ray)
{
    qv_sample sample;
    all->rays += ray->samples > 0;
    all->longer += ray->samples > 1;
    all->samples += ray->samples;
    for (; ray->samples != 0; ray->samples--) {
        all->transparent += !qv_sample_weighted(&sample, ray, &f.scene.volume, QV_STORAGE_RGBA8);
        for (unsigned axis = 0; axis < 3; axis++)
            ray->place[axis] += ray->advance[axis];
    }
}

static inventory count(void)
{
    const qv_context context = fixture_context(&f);
    inventory all = {0, 0, 0, 0};
    for (int32_t y = 0; y < FIXTURE_HEIGHT; y++)
        for (int32_t x = 0; x < FIXTURE_WIDTH; x++) {
            qv_ray ray;
            qv_ray_orthographic(&ray, &context, x, y);
            qv_ray_clip(&ray, &context);
            count_ray(&all, &ray);
        }
    return all;
}

static void make_sparse(const qv_sampling *sampling)
{
    fixture_make(&f, sampling, 5);
    for (unsigned i = 0; i < FIXTURE_VOXELS; i++)
        ((uint8_t *)f.voxels)[4 * i + 3] = i % 11 == 0 ? 20 : 0;
}

static void every_sample_is_counted(void **state)
{
    static const qv_sampling *const modes[2] = {&qv_weighted_rgba8,
                                                &qv_weighted_rgba8_back_to_front};
    (void)state;

    for (unsigned i = 0; i < 2; i++) {
        make_sparse(modes[i]);
        const inventory all = count();
        const qv_progress done = statistics();
        assert_int_equal(done.samples, all.samples);
        assert_int_equal(done.skipped, all.transparent);
        assert_in_range(done.skipped, 1, done.samples - 1);
        assert_int_equal(done.terminated, 0);
    }
}

/* Of an opaque volume each ray takes its first sample, whatever the threshold;
   back to front it takes them all. */
static void rays_end_at_the_threshold(void **state)
{
    static const uint16_t thresholds[3] = {0, QV_TERMINATION_DEFAULT, 65535};
    (void)state;

    for (unsigned i = 0; i < 3; i++) {
        fixture_make(&f, &qv_weighted_rgba8, 1);
        memset(f.voxels, 255, sizeof f.voxels);
        f.scene.termination = thresholds[i];
        const inventory all = count();
        const qv_progress done = statistics();
        assert_int_equal(done.samples, all.rays);
        assert_int_equal(done.terminated, all.longer);
        f.scene.sampling = &qv_weighted_rgba8_back_to_front;
        assert_int_equal(statistics().samples, all.samples);
        assert_int_equal(statistics().terminated, 0);
    }
}

/* A ray ends where the transmittance is at or below the threshold: .498, .248, .124
   and .062 after one to four samples. */
static void the_threshold_is_a_transmittance(void **state)
{
    static const uint16_t thresholds[4] = {32768, 16384, 8192, 8000};
    static const uint8_t voxel[4] = {255, 255, 255, 128}; /* leaves 127/255 */
    const qv_rect pixel = {FIXTURE_WIDTH / 2, FIXTURE_HEIGHT / 2, FIXTURE_WIDTH / 2 + 1,
                           FIXTURE_HEIGHT / 2 + 1};
    uint8_t rgba[4];
    const qv_image image = {rgba, 4, 0, &qv_format_rgba8888};
    (void)state;

    fixture_make(&f, &qv_nearest_rgba8, 1);
    for (unsigned i = 0; i < FIXTURE_VOXELS; i++)
        memcpy((uint8_t *)f.voxels + 4 * i, voxel, 4);
    for (unsigned i = 0; i < 4; i++) {
        qv_progress progress = {0, 0, 0, 0, 0};
        f.scene.termination = thresholds[i];
        const qv_context context = fixture_context(&f);
        assert_int_equal(qv_render_some(&image, &progress, &context, &pixel, 1), QV_OK);
        assert_int_equal(progress.samples, i + 1);
        assert_int_equal(progress.terminated, 1);
    }
}

/* The default threshold costs a quarter of a level, which may tip the rounding. */
static void the_default_threshold_costs_little(void **state)
{
    static fixture_pixels full, early;
    uint32_t ended = 0;
    (void)state;

    for (uint32_t seed = 1; seed <= 40; seed++) {
        fixture_make(&f, &qv_weighted_rgba16, seed);
        for (unsigned i = 3; i < FIXTURE_VOXELS * 4; i += 4)
            f.voxels[i] = (uint16_t)(65535 - f.voxels[i]);
        fixture_render(full, &f);
        f.scene.termination = QV_TERMINATION_DEFAULT;
        fixture_render(early, &f);
        ended += statistics().terminated;
        for (unsigned i = 0; i < sizeof full; i++)
            assert_true(abs((&full[0][0][0])[i] - (&early[0][0][0])[i]) <= 1);
    }
    assert_true(ended > 1000);
}

/* ---- Modes that weigh by length ---- */

/* The ray of a pixel and its way through the box. */
static qv_ray way_of(const qv_context *context, int32_t x, int32_t y)
{
    qv_ray ray;
    assert_int_equal(context->scene.camera.projection->ray(&ray, context, x, y), 1);
    qv_path_clip(&ray, context);
    return ray;
}

static void count_pieces(inventory *all, qv_ray *ray, qv_mode *mode)
{
    qv_sample sample;
    qv_run run;
    all->rays += ray->samples > 0;
    all->samples += ray->samples;
    qv_run_begin(&run, ray);
    while (qv_next_run(&run, ray, ray->leave, 0))
        for (; run.samples != 0; run.samples--) {
            all->transparent += !mode(&sample, ray, &f.scene.volume, QV_STORAGE_RGBA8);
            for (unsigned axis = 0; axis < 3; axis++)
                ray->place[axis] += ray->advance[axis];
        }
}

static inventory count_all_pieces(qv_mode *mode)
{
    const qv_context context = fixture_context(&f);
    inventory all = {0, 0, 0, 0};
    for (int32_t y = 0; y < FIXTURE_HEIGHT; y++)
        for (int32_t x = 0; x < FIXTURE_WIDTH; x++) {
            qv_ray ray = way_of(&context, x, y);
            count_pieces(&all, &ray, mode);
        }
    return all;
}

static void every_piece_is_counted(void **state)
{
    static const struct {
        const qv_sampling *sampling;
        qv_mode *mode;
    } modes[] = {{&qv_corrected_rgba8, qv_sample_weighted},
                 {&qv_corrected_rgba8_back_to_front, qv_sample_weighted},
                 {&qv_extinction_rgba8, qv_sample_converted},
                 {&qv_extinction_rgba8_back_to_front, qv_sample_converted},
                 {&qv_bspline_weighted_rgba8, qv_bspline_weighted},
                 {&qv_bspline_weighted_rgba8_back_to_front, qv_bspline_weighted},
                 {&qv_bspline_extinction_rgba8, qv_bspline_converted},
                 {&qv_bspline_extinction_rgba8_back_to_front, qv_bspline_converted}};
    (void)state;

    for (unsigned i = 0; i < sizeof modes / sizeof *modes; i++)
        for (unsigned perspective = 0; perspective < 2; perspective++) {
            make_sparse(modes[i].sampling);
            memset(f.voxels, 0, sizeof f.voxels / 4); /* where B-splines see nothing either */
            fixture_aim(&f, perspective * QUARTER_TURN);
            const inventory all = count_all_pieces(modes[i].mode);
            const qv_progress done = statistics();
            assert_int_equal(done.samples, all.samples);
            assert_int_equal(done.skipped, all.transparent);
            assert_in_range(done.skipped, 1, done.samples - 1);
            assert_int_equal(done.terminated, 0);
        }
}

/* Pieces of level 1 are two steps long, counted from the border of stretch 0. */
static void pieces_of_levels_are_counted(void **state)
{
    uint32_t expected = 0;
    (void)state;

    fixture_make(&f, &qv_extinction_rgbt8_levels, 3);
    fixture_add_pyramid(&f);
    f.scene.level = 256;
    const qv_context context = fixture_context(&f);
    for (int32_t y = 0; y < FIXTURE_HEIGHT; y++)
        for (int32_t x = 0; x < FIXTURE_WIDTH; x++) {
            const qv_ray ray = way_of(&context, x, y);
            const int64_t first = fx_shift_floor(qv_stretch_of(ray.enter), 1);
            if (ray.samples != 0)
                expected += (uint32_t)(fx_shift_floor(qv_stretch_of(ray.leave - 1), 1) - first + 1);
        }
    assert_int_equal(statistics().samples, expected);
    assert_true(expected > 200);
}

/* Of a homogeneous medium the pieces, of which the first is partial, are known. */
static uint32_t pieces_until(uint16_t threshold, int32_t x, int32_t y)
{
    const qv_context context = fixture_context(&f);
    qv_ray ray = way_of(&context, x, y);
    double opaque = -log2(threshold / 65536.0) / -log2(127.0 / 255);
    qv_run run;
    qv_run_begin(&run, &ray);
    assert_int_equal(qv_next_run(&run, &ray, ray.leave, 0), 1);
    return 1 + (uint32_t)ceil(fmax(0, opaque - run.length / 65536.0));
}

static void lengths_end_at_the_threshold(void **state)
{
    static const uint16_t thresholds[4] = {40000, 20000, 9000, 5000};
    static const uint8_t voxel[4] = {255, 255, 255, 128}; /* leaves 127/255 */
    static const int32_t x = FIXTURE_WIDTH / 2, y = FIXTURE_HEIGHT / 2;
    static const qv_rect pixel = {x, y, x + 1, y + 1};
    uint8_t rgba[4];
    const qv_image image = {rgba, 4, 0, &qv_format_rgba8888};
    (void)state;

    for (unsigned i = 0; i < 4 * STORAGES; i += STORAGES) {
        fixture_make(&f, length_samplings[i].front, 1);
        for (unsigned v = 0; v < FIXTURE_VOXELS; v++)
            memcpy((uint8_t *)f.voxels + 4 * v, voxel, 4);
        for (unsigned t = 0; t < 4; t++) {
            qv_progress progress = {0, 0, 0, 0, 0};
            f.scene.termination = thresholds[t];
            const qv_context context = fixture_context(&f);
            assert_int_equal(qv_render_some(&image, &progress, &context, &pixel, 1), QV_OK);
            assert_int_equal(progress.samples, pieces_until(thresholds[t], x, y));
            assert_int_equal(progress.terminated, 1);
        }
    }
}

/* All but opaque at once: one piece, or two where the first is short; back to front and
   behind the last piece no ray ends early. */
static void opaque_media_end_rays(void **state)
{
    (void)state;

    for (unsigned i = 0; i < LENGTH_SAMPLINGS; i++) {
        fixture_make(&f, length_samplings[i].front, 1);
        memset(f.voxels, 255, sizeof f.voxels);
        memset(&f.palette16, 255, sizeof f.palette16);
        memset(f.palette8, 255, sizeof f.palette8);
        f.scene.volume.unit_distance = f.scene.camera.step / 64;
        f.scene.volume.extinction = 8192 * QV_ONE_Q16;
        const inventory all = count_all_pieces(qv_sample_weighted);
        const qv_progress front = statistics();
        assert_in_range(front.samples, all.rays, all.rays * 5 / 4);
        assert_in_range(front.terminated, all.rays * 3 / 4, all.rays);
        f.scene.sampling = length_samplings[i].back;
        assert_int_equal(statistics().samples, all.samples);
        assert_int_equal(statistics().terminated, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_sample_is_counted),
        cmocka_unit_test(rays_end_at_the_threshold),
        cmocka_unit_test(the_threshold_is_a_transmittance),
        cmocka_unit_test(the_default_threshold_costs_little),
        cmocka_unit_test(every_piece_is_counted),
        cmocka_unit_test(pieces_of_levels_are_counted),
        cmocka_unit_test(lengths_end_at_the_threshold),
        cmocka_unit_test(opaque_media_end_rays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
