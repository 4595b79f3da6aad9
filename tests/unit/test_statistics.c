/*
 * Statistics of rendering, and the threshold at which rays end.
 */
#include "check.h"
#include "ray.h"
#include "sample.h"
#include "scene_fixture.h"

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_sample_is_counted),
        cmocka_unit_test(rays_end_at_the_threshold),
        cmocka_unit_test(the_threshold_is_a_transmittance),
        cmocka_unit_test(the_default_threshold_costs_little),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
