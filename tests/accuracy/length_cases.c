/*
 * The reference on cases that can be worked out on paper: pieces of a ray, depth and
 * opacity, B-splines and pyramids.
 */
#include "check.h"
#include "reference.h"

#include <math.h>
#include <string.h>

#define VOXELS 4

static const qv_coord one = (qv_coord)1 << 32;

static bool near(double a, double b)
{
    return fabs(a - b) < 1e-12;
}

/* A row of voxels of 4 bytes along z, seen along z with steps of one voxel. */
static void row_scene(qv_scene *scene, unsigned char (*voxels)[4], uint16_t depth,
                      qv_storage storage)
{
    memset(scene, 0, sizeof *scene);
    scene->volume.voxels = voxels[0];
    scene->volume.size[0] = 1;
    scene->volume.size[1] = 1;
    scene->volume.size[2] = depth;
    scene->volume.stride[2] = 4;
    scene->volume.storage = (uint8_t)storage;
    scene->volume.unit_distance = QV_ONE_Q16;
    scene->volume.extinction = QV_ONE_Q16;
    scene->camera.step = QV_ONE_Q16;
    scene->camera.origin[0] = one / 2;
    scene->camera.origin[1] = one / 2;
    scene->camera.across[0] = one;
    scene->camera.down[1] = one;
    scene->camera.along[2] = one;
    scene->camera.projection = &qv_projection_orthographic;
}

static void set_step(qv_scene *scene, double step)
{
    scene->camera.step = (uint32_t)(step * QV_ONE_Q16);
    scene->camera.along[2] = (qv_coord)(step * (double)one);
}

static void fill(unsigned char (*voxels)[4], int count, const unsigned char channels[4])
{
    for (int i = 0; i < count; i++) {
        memcpy(voxels[i], channels, 4);
    }
}

/* ---- Pieces --------------------------------------------------------------- */

/* Whether pieces end so many steps behind the first sample, one after the other. */
static void check_pieces(const ref_ray *ray, double stretch, double begin, const double *ends,
                         int count)
{
    ref_piece piece = ref_first_piece(ray);
    for (int i = 0; i < count; i++) {
        assert_true(ref_next_piece(&piece, ray, stretch, HUGE_VAL));
        assert_true(near(piece.begin, i == 0 ? begin : ends[i - 1]));
        assert_true(near(piece.end, ends[i]));
    }
    assert_true(!ref_next_piece(&piece, ray, stretch, HUGE_VAL));
}

/* Samples at 1/4, 5/4 ... of a way from 0 to 4: borders at 3/4, 7/4, 11/4, 15/4. */
static void test_pieces(void **state)
{
    unsigned char voxels[VOXELS][4] = {{0}};
    const double single[] = {0.5, 1.5, 2.5, 3.5, 3.75};
    /* stretches of two: k = 0 and 1, 2 and 3, then 4 */
    const double twice[] = {1.5, 3.5, 3.75};
    qv_scene scene;
    ref_ray ray;
    (void)state;
    row_scene(&scene, voxels, VOXELS, QV_STORAGE_RGBA8);
    scene.phase = 0x4000;
    ref_stored_ray(&ray, &scene, 0, 0);
    assert_int_equal(ray.index, 0);
    check_pieces(&ray, 1, -0.25, single, 5);
    check_pieces(&ray, 2, -0.25, twice, 3);
}

/* The grid of two-step stretches begins at k = 0 wherever the box begins. */
static void test_pieces_of_the_grid(void **state)
{
    unsigned char voxels[VOXELS][4] = {{0}};
    const double ends[] = {0.5, 2.5, 4}; /* k = 3; 4 and 5; 6 */
    qv_scene scene;
    ref_ray ray;
    (void)state;
    row_scene(&scene, voxels, VOXELS, QV_STORAGE_RGBA8);
    scene.camera.origin[2] = -3 * one;
    ref_stored_ray(&ray, &scene, 0, 0);
    assert_int_equal(ray.index, 3);
    check_pieces(&ray, 2, 0, ends, 3);
    ref_stored_ray(&ray, &scene, 1, 0); /* beside the box */
    check_pieces(&ray, 1, 0, NULL, 0);
}

/* A ray from an eye inside the box begins at the eye. */
static void test_pieces_from_the_eye(void **state)
{
    unsigned char voxels[VOXELS][4] = {{0}};
    const double ends[] = {-0.5, 0.5, 1.25}; /* of a way of 2 steps; s = 3/4, 7/4 are samples */
    qv_scene scene;
    ref_ray ray;
    (void)state;
    row_scene(&scene, voxels, VOXELS, QV_STORAGE_RGBA8);
    scene.camera.projection = &qv_projection_perspective;
    scene.camera.origin[2] = 2 * one;
    scene.phase = 0xc000;
    for (int axis = 0; axis < 3; axis++) {
        scene.camera.pace[axis] = one;
    }
    ref_stored_ray(&ray, &scene, 0, 0);
    assert_int_equal(ray.index, 0);
    assert_int_equal(ray.count, 2);
    check_pieces(&ray, 1, -0.75, ends, 3);
}

/* ---- Depth, opacity and length ---------------------------------------------- */

static void test_depth(void **state)
{
    (void)state;
    assert_true(near(ref_depth(0), 0));
    assert_true(near(ref_depth(0.75), 2));
    assert_true(near(ref_depth(1), 64));
    assert_true(near(ref_correct(0.75, 0.5), 0.5));
    assert_true(near(ref_correct(0.5, 3), 0.875));
    assert_true(near(ref_correct(0.3, 1), 0.3));
    assert_true(near(ref_correct(1, 1), 1));
    assert_true(near(ref_correct(1, 0.0625), 0.9375)); /* a sixteenth of a depth of 64 */
}

/* Figures 2 and 3 of Kraus and Buerger: half of the voxels at tau 4, seen at twice the size. */
static void test_figures(void **state)
{
    const double opaque = 1 - exp(-4), mean = opaque / 2;
    const double depth = 4 / log(2) / 2; /* base 2, of the mean extinction */
    (void)state;
    assert_true(fabs(1 - exp2(-2 * depth) - 0.98168) < 5e-6);
    assert_true(fabs(mean - 0.49084) < 5e-6);
    assert_true(fabs(ref_correct(mean, 2) - 0.74076) < 5e-6);
}

/* Equations 17 and 23 on a sample of two materials. */
static void test_colour_factors(void **state)
{
    const qv_volume volume = {.storage = QV_STORAGE_RGBA8, .unit_distance = 2 * QV_ONE_Q16};
    double corrected[4] = {0.75, 0.375, 0, 0.75}, extinction[4] = {1.5, 0.5, 0, 2};
    (void)state;
    ref_weigh(corrected, &volume, REF_CORRECTED, 1); /* half of the unit distance */
    assert_true(near(corrected[3], 0.5));
    assert_true(near(corrected[0], 0.5));
    assert_true(near(corrected[1], 0.25));
    ref_weigh(extinction, &volume, REF_EXTINCTION, 1);
    assert_true(near(extinction[3], 0.75));
    assert_true(near(extinction[0], 0.75 * 0.75));
    assert_true(near(extinction[1], 0.75 * 0.25));
}

/* A slab of four units of depth 1 each: the step and the phase change nothing. */
static void check_slab(qv_scene *scene, ref_mode mode, double depth)
{
    static const double steps[] = {0.25, 0.75, 1, 3, 7};
    ref_pixel pixel;
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        set_step(scene, steps[i]);
        scene->phase = (uint16_t)(i * 0x3100u);
        ref_render(&pixel, scene, mode, 0, 0);
        assert_true(near(pixel.opacity, 1 - exp2(-depth)));
        assert_true(near(pixel.rgba[0], pixel.opacity));
        assert_true(near(pixel.rgba[1], pixel.opacity / 5));
    }
}

static void test_slabs(void **state)
{
    unsigned char voxels[VOXELS][4];
    const double depth = -log2(0.8); /* of an opacity of 51 / 255 */
    qv_scene scene;
    (void)state;
    fill(voxels, VOXELS, (const unsigned char[4]){255, 51, 0, 51});
    row_scene(&scene, voxels, VOXELS, QV_STORAGE_RGBA8);
    for (int mode = REF_CORRECTED; mode <= REF_BSPLINE_EXTINCTION; mode++) {
        scene.volume.unit_distance = QV_ONE_Q16;
        check_slab(&scene, (ref_mode)mode, 4 * depth);
        scene.volume.unit_distance = 2 * QV_ONE_Q16;
        check_slab(&scene, (ref_mode)mode, 2 * depth);
    }
    scene.volume.storage = QV_STORAGE_RGBT8;
    scene.volume.extinction = 5 * QV_ONE_Q16; /* of the full value: 1 of 51 */
    check_slab(&scene, REF_EXTINCTION, 4);
    check_slab(&scene, REF_BSPLINE_EXTINCTION, 4);
}

/* Unit distance 0 is the step, so opacities hold for it: nothing to correct. */
static void test_unit_of_a_step(void **state)
{
    unsigned char voxels[VOXELS][4];
    qv_scene scene;
    ref_pixel pixel;
    (void)state;
    fill(voxels, VOXELS, (const unsigned char[4]){255, 255, 255, 51});
    row_scene(&scene, voxels, VOXELS, QV_STORAGE_RGBA8);
    scene.volume.unit_distance = 0;
    set_step(&scene, 2);
    scene.phase = 0x8000; /* whole steps only */
    for (int mode = REF_CORRECTED; mode <= REF_BSPLINE_EXTINCTION; mode++) {
        ref_render(&pixel, &scene, (ref_mode)mode, 0, 0);
        assert_int_equal(pixel.samples, 2);
        assert_true(near(pixel.opacity, 1 - 0.8 * 0.8));
    }
}

/* ---- Reconstruction ----------------------------------------------------------- */

/* Halfway between a red voxel of depth 2 and a green one of depth 1. */
static void test_between_voxels(void **state)
{
    unsigned char voxels[2][4] = {{255, 0, 0, 102}, {0, 255, 0, 51}};
    const double point[3] = {0.5, 0.5, 1};
    qv_scene scene;
    double sample[4];
    (void)state;
    row_scene(&scene, voxels, 2, QV_STORAGE_RGBT8);
    scene.volume.extinction = 5 * QV_ONE_Q16;
    ref_reconstruct(sample, &scene.volume, REF_EXTINCTION, point);
    assert_true(near(sample[3], 1.5));
    assert_true(near(sample[0], 1));
    assert_true(near(sample[1], 0.5));
    scene.volume.storage = QV_STORAGE_RGBA8; /* opacities .4 and .2 */
    ref_reconstruct(sample, &scene.volume, REF_CORRECTED, point);
    assert_true(near(sample[3], 0.3));
    assert_true(near(sample[0], 0.2));
    assert_true(near(sample[1], 0.1));
}

/* Every storage of extinction, by hand: half of 1 per unit. */
static void test_storages(void **state)
{
    const uint16_t wide[4] = {0, 0, 0, 13107}; /* a fifth */
    const unsigned char narrow[4] = {0, 0, 0, 51}, index = 0;
    qv_volume volume = {.size = {1, 1, 1}, .extinction = 5 * QV_ONE_Q16 / 2};
    const int32_t at[3] = {0, 0, 0};
    double rgba[4];
    (void)state;
    for (int storage = QV_STORAGE_RGBT8; storage <= QV_STORAGE_INDEXED8_T16; storage++) {
        const bool is_wide = storage == QV_STORAGE_RGBT16 || storage == QV_STORAGE_INDEXED8_T16;
        const bool indexed = storage >= QV_STORAGE_INDEXED8_T8;
        const unsigned char *entry = is_wide ? (const unsigned char *)wide : narrow;
        volume.storage = (uint8_t)storage;
        volume.voxels = indexed ? &index : entry;
        volume.palette = indexed ? entry : NULL;
        ref_voxel(rgba, &volume, at);
        assert_true(near(ref_extinction(rgba[3], &volume), 0.5));
    }
}

static void check_taps(double point, const int32_t at[3], const double weight[3])
{
    ref_taps taps;
    ref_bspline_taps(&taps, point, VOXELS);
    assert_int_equal(taps.count, 3);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(taps.at[i], at[i]);
        assert_true(near(taps.weight[i], weight[i]));
    }
}

/* At a centre, on a border between voxels, between the two, and at both faces. */
static void test_bspline(void **state)
{
    (void)state;
    check_taps(1.5, (const int32_t[3]){0, 1, 2}, (const double[3]){0.125, 0.75, 0.125});
    check_taps(2, (const int32_t[3]){1, 2, 3}, (const double[3]){0.5, 0.5, 0});
    check_taps(1.75, (const int32_t[3]){0, 1, 2}, (const double[3]){0.03125, 0.6875, 0.28125});
    check_taps(0.5, (const int32_t[3]){0, 0, 1}, (const double[3]){0.125, 0.75, 0.125});
    check_taps(3.5, (const int32_t[3]){2, 3, 3}, (const double[3]){0.125, 0.75, 0.125});
    check_taps(4, (const int32_t[3]){3, 3, 3}, (const double[3]){0.5, 0.5, 0});
}

/* One voxel among empty ones, at its centre: 3/4 on the axis that has neighbours. */
static void test_bspline_of_a_voxel(void **state)
{
    unsigned char voxels[3][4] = {{0}, {255, 255, 255, 255}, {0}};
    const double point[3] = {0.5, 0.5, 1.5};
    qv_scene scene;
    double sample[4];
    (void)state;
    row_scene(&scene, voxels, 3, QV_STORAGE_RGBA8);
    ref_reconstruct(sample, &scene.volume, REF_BSPLINE_WEIGHTED, point);
    assert_true(near(sample[3], 0.75));
    ref_reconstruct(sample, &scene.volume, REF_BSPLINE_EXTINCTION, point);
    assert_true(near(sample[3], 48)); /* of a depth of 64 */
    assert_true(near(sample[0], 48));
}

/* ---- Pyramids -------------------------------------------------------------------- */

/* Where levels lie, and what they are as volumes. */
static void test_pyramid_levels(void **state)
{
    unsigned char voxels[VOXELS][4] = {{0}}, coarser[9][4] = {{0}};
    const qv_pyramid pyramid = {coarser[0], sizeof coarser, 3};
    qv_scene scene;
    qv_volume level;
    (void)state;
    row_scene(&scene, voxels, VOXELS, QV_STORAGE_INDEXED8_T8);
    scene.volume.size[0] = 5;
    scene.volume.spacing[1] = 3 * QV_ONE_Q16;
    scene.pyramid = &pyramid;
    ref_pyramid_level(&level, &scene, 1); /* 3 x 1 x 2 */
    assert_true(level.voxels == coarser[0]);
    assert_int_equal(level.storage, QV_STORAGE_RGBT8);
    assert_int_equal(level.size[0], 3);
    assert_int_equal(level.stride[2], 12);
    assert_int_equal(level.spacing[0], 2 * QV_ONE_Q16);
    assert_int_equal(level.spacing[1], 6 * QV_ONE_Q16);
    ref_pyramid_level(&level, &scene, 2); /* 2 x 1 x 1 */
    assert_true(level.voxels == coarser[6]);
    assert_int_equal(level.size[0], 2);
    assert_int_equal(level.size[2], 1);
    ref_pyramid_level(&level, &scene, 3);
    assert_true(level.voxels == coarser[8]);
}

/* Depths 1 per unit in the volume, 2 in level 1, 4 in level 2. */
static void test_pyramid_samples(void **state)
{
    unsigned char voxels[VOXELS][4], coarser[3][4];
    const qv_pyramid pyramid = {coarser[0], sizeof coarser, 2};
    static const double depths[] = {1, 1.25, 2, 3, 4}; /* by level: 0, 1/4, 1, 3/2, 2 */
    static const uint16_t levels[] = {0, 64, 256, 384, 512};
    static const int pieces[] = {5, 5, 3, 3, 2}; /* borders -1/2, 1/2 ..; -1/2, 3/2 ..; -1/2, 7/2 */
    qv_scene scene;
    ref_pixel pixel;
    (void)state;
    fill(voxels, VOXELS, (const unsigned char[4]){255, 0, 0, 51});
    fill(coarser, 2, (const unsigned char[4]){255, 0, 0, 102});
    fill(coarser + 2, 1, (const unsigned char[4]){255, 0, 0, 204});
    row_scene(&scene, voxels, VOXELS, QV_STORAGE_RGBT8);
    scene.volume.extinction = 5 * QV_ONE_Q16;
    scene.pyramid = &pyramid;
    for (int i = 0; i < 5; i++) {
        scene.level = levels[i];
        ref_render(&pixel, &scene, REF_EXTINCTION, 0, 0);
        assert_int_equal(pixel.samples, pieces[i]);
        assert_true(near(pixel.opacity, 1 - exp2(-4 * depths[i])));
        assert_true(near(pixel.rgba[0], pixel.opacity));
    }
}

/* Level 1 of a row 1, 0 of depths: a point's place there is half of it. */
static void test_pyramid_places(void **state)
{
    unsigned char voxels[VOXELS][4] = {{0}}, coarser[2][4] = {{255, 0, 0, 255}, {0}};
    const qv_pyramid pyramid = {coarser[0], sizeof coarser, 1};
    qv_scene scene;
    ref_pixel pixel;
    (void)state;
    row_scene(&scene, voxels, VOXELS, QV_STORAGE_RGBT8);
    scene.pyramid = &pyramid;
    scene.level = 256;
    /* pieces 0 .. 3/2 and 3/2 .. 7/2 and 7/2 .. 4, middles 3/4, 5/2, 15/4; in level 1 3/8 (the
       first voxel), 5/4 (a quarter of it), 15/8 (the last) */
    ref_render(&pixel, &scene, REF_EXTINCTION, 0, 0);
    assert_int_equal(pixel.samples, 3);
    assert_true(near(pixel.opacity, 1 - exp2(-1.5 - 2 * 0.25)));
}

static void check_span(const qv_scene *scene, double position, int level, double share, double end)
{
    ref_span span;
    ref_span_at(&span, scene, position);
    assert_int_equal(span.level, level);
    assert_true(near(ref_share(&span, position), share));
    assert_true(span.end == end);
}

/* From level 1.5 at 100 steps: its whole part, and one level more at 200, 400 ... up to 3. */
static void test_level_by_distance(void **state)
{
    const qv_pyramid pyramid = {NULL, 0, 3};
    qv_scene scene = {.level = 384, .pyramid = &pyramid};
    (void)state;
    check_span(&scene, 1000, 1, 0.5, HUGE_VAL);
    scene.level_distance = 100;
    check_span(&scene, 0, 1, 0, 100);
    check_span(&scene, 99.5, 1, 0, 100);
    check_span(&scene, 100, 1, 0, 200);
    check_span(&scene, 175, 1, 0.75, 200);
    check_span(&scene, 200, 2, 0, 400);
    check_span(&scene, 250, 2, 0.25, 400);
    check_span(&scene, 400, 3, 0, HUGE_VAL);
    check_span(&scene, 1e6, 3, 0, HUGE_VAL);
    scene.pyramid = NULL; /* nothing but the volume */
    check_span(&scene, 250, 0, 0, HUGE_VAL);
}

/* From an eye before a row of 4: level 0 up to 3 steps, then between 0 and 1 with pieces of
   one step, cut where a span ends, half a step before sample 3. */
static void test_pieces_by_distance(void **state)
{
    unsigned char voxels[VOXELS][4], coarser[2][4];
    const qv_pyramid pyramid = {coarser[0], sizeof coarser, 1};
    qv_scene scene;
    ref_pixel pixel;
    (void)state;
    fill(voxels, VOXELS, (const unsigned char[4]){255, 0, 0, 51});
    fill(coarser, 2, (const unsigned char[4]){255, 0, 0, 102});
    row_scene(&scene, voxels, VOXELS, QV_STORAGE_RGBT8);
    scene.volume.extinction = 5 * QV_ONE_Q16;
    scene.camera.projection = &qv_projection_perspective;
    scene.camera.origin[2] = -one;
    for (int axis = 0; axis < 3; axis++) {
        scene.camera.pace[axis] = one;
    }
    scene.pyramid = &pyramid;
    scene.level_distance = 3;
    /* s = 1 .. 5; on the grid 3/2 .. 11/2: depth 1 up to 3, then 1 + (5/2) / 3 on average */
    ref_render(&pixel, &scene, REF_EXTINCTION, 0, 0);
    assert_int_equal(pixel.samples, 5);
    assert_true(near(pixel.opacity, 1 - exp2(-1.5 - 2.5 - 2.5 * 1.25 / 3)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pieces),
        cmocka_unit_test(test_pieces_of_the_grid),
        cmocka_unit_test(test_pieces_from_the_eye),
        cmocka_unit_test(test_depth),
        cmocka_unit_test(test_figures),
        cmocka_unit_test(test_colour_factors),
        cmocka_unit_test(test_slabs),
        cmocka_unit_test(test_unit_of_a_step),
        cmocka_unit_test(test_between_voxels),
        cmocka_unit_test(test_storages),
        cmocka_unit_test(test_bspline),
        cmocka_unit_test(test_bspline_of_a_voxel),
        cmocka_unit_test(test_pyramid_levels),
        cmocka_unit_test(test_pyramid_samples),
        cmocka_unit_test(test_pyramid_places),
        cmocka_unit_test(test_level_by_distance),
        cmocka_unit_test(test_pieces_by_distance),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
