/*
 * The reference on cases that can be worked out on paper, so that a mistake in
 * it cannot hide behind the same mistake in the library.
 */
#include "check.h"
#include "reference.h"

#include <math.h>
#include <string.h>

#define VOXELS 4

static bool near(double a, double b)
{
    return fabs(a - b) < 1e-12;
}

/* A row of RGBA8 voxels along z, seen along z with one sample in each voxel. */
static void row_scene(qv_scene *scene, unsigned char (*voxels)[4], uint16_t depth, uint16_t phase)
{
    const qv_coord one = (qv_coord)1 << 32;
    memset(scene, 0, sizeof *scene);
    scene->volume.voxels = voxels[0];
    scene->volume.size[0] = 1;
    scene->volume.size[1] = 1;
    scene->volume.size[2] = depth;
    scene->volume.stride[2] = 4;
    scene->volume.storage = QV_STORAGE_RGBA8;
    scene->camera.origin[0] = one / 2;
    scene->camera.origin[1] = one / 2;
    scene->camera.across[0] = one;
    scene->camera.down[1] = one;
    scene->camera.along[2] = one;
    scene->camera.projection = &qv_projection_orthographic;
    scene->phase = phase;
}

/* n samples of one opacity: 1 - (1 - a)^n, colour in proportion. */
static void test_uniform_slab(void **state)
{
    unsigned char voxels[VOXELS][4];
    qv_scene scene;
    ref_pixel pixel;
    (void)state;
    for (int i = 0; i < VOXELS; i++) {
        memcpy(voxels[i], (const unsigned char[4]){255, 51, 0, 51}, 4);
    }
    row_scene(&scene, voxels, VOXELS, 0x3000);
    for (int mode = REF_NEAREST; mode <= REF_WEIGHTED; mode++) {
        ref_render(&pixel, &scene, (ref_mode)mode, 0, 0);
        assert_int_equal(pixel.samples, VOXELS);
        assert_true(near(pixel.opacity, 1 - 0.8 * 0.8 * 0.8 * 0.8));
        assert_true(near(pixel.rgba[0], pixel.opacity));
        assert_true(near(pixel.rgba[1], pixel.opacity / 5));
        assert_true(near(pixel.rgba[2], 0));
    }
}

/* Air, then an opaque white voxel: the worked example of Wittenbrink et al. */
static void test_material_border(void **state)
{
    unsigned char voxels[3][4] = {{0, 0, 0, 0}, {255, 255, 255, 255}, {255, 255, 255, 255}};
    const double expected[3] = {1, 0.75, 1};
    qv_scene scene;
    ref_pixel pixel;
    (void)state;
    row_scene(&scene, voxels, 3, 0); /* samples on faces, halfway between centres */
    for (int mode = REF_NEAREST; mode <= REF_WEIGHTED; mode++) {
        ref_render(&pixel, &scene, (ref_mode)mode, 0, 0);
        assert_true(near(pixel.rgba[0], expected[mode]));
        assert_true(near(pixel.opacity, 1));
    }
}

/* Front and back, and the background behind both. */
static void test_order(void **state)
{
    unsigned char voxels[2][4] = {{255, 0, 0, 102}, {0, 255, 0, 51}};
    qv_scene scene;
    ref_pixel pixel;
    (void)state;
    row_scene(&scene, voxels, 2, 0x8000);
    memcpy(scene.background, (const uint8_t[4]){0, 0, 255, 127}, 4);
    ref_render(&pixel, &scene, REF_WEIGHTED, 0, 0);
    assert_true(near(pixel.rgba[0], 0.4));
    assert_true(near(pixel.rgba[1], 0.6 * 0.2));
    assert_true(near(pixel.rgba[2], 0.6 * 0.8 * 127 / 255));
    assert_true(near(pixel.opacity, 0.52));
    assert_true(near(pixel.rgba[3], 0.52 + 0.48 * 127 / 255));
}

/* 0 <= p < n: a sample on the near face counts, one on the far face does not. */
static void test_box(void **state)
{
    unsigned char voxels[VOXELS][4] = {{0}};
    qv_scene scene;
    ref_ray ray;
    (void)state;
    row_scene(&scene, voxels, VOXELS, 0);
    ref_stored_ray(&ray, &scene, 0, 0);
    assert_int_equal(ray.count, VOXELS);
    assert_int_equal(ray.index, 0);
    assert_true(near(ray.first[2], 0));
    scene.camera.along[2] = -scene.camera.along[2]; /* from the other side: 3, 2, 1, 0 */
    ref_stored_ray(&ray, &scene, 0, 0);
    assert_int_equal(ray.count, VOXELS);
    assert_int_equal(ray.index, 1 - VOXELS);
    assert_true(near(ray.first[2], VOXELS - 1));
    ref_stored_ray(&ray, &scene, 1, 0); /* x = 1.5 of a volume 1 wide */
    assert_int_equal(ray.count, 0);
}

/* The rows that qvol.h states for azimuth, elevation and roll. */
static void test_directions(void **state)
{
    static const struct {
        qv_angle azimuth, elevation, roll;
        double rows[3][3];
    } cases[] = {
        {0, 0, 0, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}},
        {0x40000000u, 0, 0, {{0, 1, 0}, {0, 0, -1}, {-1, 0, 0}}}, /* viewer at +x */
        {0, 0x40000000u, 0, {{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}, /* viewer at +z */
        {0, 0, 0x40000000u, {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}}, /* camera's right now down */
    };
    double rotation[3][3];
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        ref_rotation(rotation, cases[i].azimuth, cases[i].elevation, cases[i].roll);
        for (int entry = 0; entry < 9; entry++) {
            assert_true(near(rotation[entry / 3][entry % 3], cases[i].rows[entry / 3][entry % 3]));
        }
    }
}

/* Between two centres, and before the first one, where both taps are that one. */
static void test_weights(void **state)
{
    ref_taps taps;
    (void)state;
    ref_linear_taps(&taps, 1.75, VOXELS);
    assert_int_equal(taps.count, 2);
    assert_int_equal(taps.at[0], 1);
    assert_int_equal(taps.at[1], 2);
    assert_true(near(taps.weight[0], 0.75));
    assert_true(near(taps.weight[1], 0.25));
    ref_linear_taps(&taps, 0.125, VOXELS);
    assert_int_equal(taps.at[0], 0);
    assert_int_equal(taps.at[1], 0);
    assert_true(near(taps.weight[0] + taps.weight[1], 1));
}

/* Over, from the back, gives what under gives from the front. */
static void test_over_and_under(void **state)
{
    const double samples[3][4] = {{0.1, 0.2, 0.3, 0.4}, {0.5, 0, 0.25, 0.5}, {0.0, 0.7, 0.1, 0.9}};
    double front[4] = {0}, back[4] = {0};
    (void)state;
    for (int i = 0; i < 3; i++) {
        ref_under(front, samples[i]);
        ref_over(back, samples[2 - i]);
    }
    for (int channel = 0; channel < 4; channel++) {
        assert_true(near(front[channel], back[channel]));
    }
    assert_true(near(front[3], 1 - 0.6 * 0.5 * 0.1));
}

/* The ideal perspective: the centre of the frame sees the centre of the box from D away. */
static void test_ideal_eye(void **state)
{
    unsigned char voxels[VOXELS][4] = {{0}};
    ref_view view = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 0.5, 1, 0, 1, 9};
    qv_scene scene;
    ref_ray ray;
    (void)state;
    row_scene(&scene, voxels, VOXELS, 0);
    view.field_of_view = 2 * atan(0.25); /* half of 9 pixels of 0.5 at distance 9 */
    ref_ideal_ray(&ray, &scene, &view, 0, 4);
    assert_int_equal(ray.index, 7); /* the eye at z = 2 - 9, the near face 7 steps away */
    assert_int_equal(ray.count, VOXELS);
    assert_true(near(ray.first[0], 0.5));
    assert_true(near(ray.first[2], 0));
    ref_ideal_ray(&ray, &scene, &view, 0, 3); /* half a unit up at the centre */
    assert_true(near((ray.first[1] - 0.5) / (ray.first[2] + 7), -0.5 / 9));
}

static void test_levels(void **state)
{
    const double colour[4] = {1, 0.5, 0.25, 1};
    (void)state;
    assert_int_equal(ref_level(0, 255), 0);
    assert_int_equal(ref_level(1, 255), 255);
    assert_int_equal(ref_level(0.5, 255), 128); /* 127.5: a tie, upwards */
    assert_int_equal(ref_level(0.4999, 255), 127);
    assert_int_equal(ref_level(0.5, 31), 16);
    assert_true(near(ref_grey(colour), (77 + 75 + 7.25) / 256));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_uniform_slab),   cmocka_unit_test(test_material_border),
        cmocka_unit_test(test_order),          cmocka_unit_test(test_box),
        cmocka_unit_test(test_directions),     cmocka_unit_test(test_weights),
        cmocka_unit_test(test_over_and_under), cmocka_unit_test(test_ideal_eye),
        cmocka_unit_test(test_levels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
