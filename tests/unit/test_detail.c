/*
 * The level of detail that a view asks for, against logarithms and distances in real
 * numbers.
 */
#include "check.h"
#include "downsample_fixture.h"

#include <math.h>

static source s;
static qv_scene scene;
static qv_pyramid pyramid;
static qv_view view;

static const double turn = 4294967296.0; /* binary angles in one */

/* A volume of 300 x 20 x 20 voxels, seen from aside, 200 x 100 pixels. */
static void make(uint32_t pitch, uint32_t step)
{
    static const uint16_t size[3] = {300, 20, 20};
    memset(&scene, 0, sizeof scene);
    source_shape(&s, QV_STORAGE_RGBA8, size);
    scene.volume = s.volume;
    scene.pyramid = &pyramid;
    pyramid.levels = qv_pyramid_levels(size);
    qv_rotation(view.rotation, 0x1B345678u, 0x0C000000u, 0xF3000000u);
    view.pitch = pitch;
    view.step = step;
    view.width = 200;
    view.height = 100;
}

static void aim(qv_angle field_of_view)
{
    const qv_status status =
        field_of_view == 0 ? qv_orthographic(&scene.camera, &scene.volume, &view)
                           : qv_perspective(&scene.camera, &scene.volume, &view, field_of_view);
    assert_int_equal(status, QV_OK);
    scene.level = 0xA5A5;
    scene.level_distance = 0xA5A5;
}

/* ---- Orthographic ---- */

static void expect_level(uint32_t pitch, uint16_t level)
{
    view.pitch = pitch;
    aim(0);
    assert_int_equal(qv_detail(&scene, &view), QV_OK);
    assert_int_equal(scene.level, level);
    assert_int_equal(scene.level_distance, 0);
}

static void whole_levels(void **state)
{
    (void)state;

    make(QV_ONE_Q16, QV_ONE_Q16);
    expect_level(16, 0);
    expect_level(QV_ONE_Q16 / 2, 0);
    expect_level(QV_ONE_Q16, 0);
    for (uint16_t level = 1; level < 9; level++)
        expect_level(QV_ONE_Q16 << level, (uint16_t)(256 * level));
    scene.volume.spacing[1] = QV_ONE_Q16 / 16;
    scene.volume.spacing[2] = QV_ONE_Q16 / 2;
    expect_level(QV_ONE_Q16 / 16, 0);
    expect_level(QV_ONE_Q16 * 2, 5 * 256);
}

static void levels_between(void **state)
{
    uint32_t seed = 3;
    (void)state;

    make(QV_ONE_Q16, QV_ONE_Q16);
    for (unsigned i = 0; i < 2000; i++) {
        const uint32_t spacing = 4096 + random_below(&seed, QV_ONE_Q16 * 2);
        view.pitch = spacing + random_below(&seed, QV_ONE_Q16 * (i % 32 + 1));
        for (unsigned axis = 0; axis < 3; axis++)
            scene.volume.spacing[axis] = spacing + axis * 1000;
        aim(0);
        assert_int_equal(qv_detail(&scene, &view), QV_OK);
        const double exact = fmin(256 * log2((double)view.pitch / spacing), 256 * 9);
        if (!(fabs(scene.level - exact) <= 0.501))
            fail_msg("%u is not %f", (unsigned)scene.level, exact);
    }
}

static void no_more_levels_than_there_are(void **state)
{
    (void)state;

    make(QV_ONE_Q16, QV_ONE_Q16);
    pyramid.levels = 3;
    expect_level(QV_ONE_Q16 * 8, 3 * 256);
    expect_level(QV_ONE_Q16 * 9, 3 * 256);
    expect_level(QV_ONE_Q16 * 7, 719); /* 256 * log2 7 = 718.7 */
}

/* ---- Perspective ---- */

/* Steps from the eye to where a pixel is as wide as the least spacing. */
static double exact_distance(qv_angle field_of_view, double spacing)
{
    const double pi = acos(-1);
    const double half = view.height * (view.pitch / 65536.0) / 2;
    const double to_plane = half / tan(field_of_view / turn * pi);
    return to_plane * spacing / (view.pitch / 65536.0) / (view.step / 65536.0);
}

/* Cut to whole steps: below the exact distance by less than 1, but for rounding. */
static void distances(void **state)
{
    uint32_t seed = 9;
    (void)state;

    for (unsigned i = 0; i < 2000; i++) {
        make(1000 + random_below(&seed, QV_ONE_Q16 * 3),
             4096 + random_below(&seed, QV_ONE_Q16 * 4));
        const qv_angle field = 0x02000000u + random_below(&seed, 0x60000000u);
        const uint32_t spacing = 4096 + random_below(&seed, QV_ONE_Q16 * 2);
        for (unsigned axis = 0; axis < 3; axis++)
            scene.volume.spacing[axis] = spacing + axis * 1000;
        aim(field);
        assert_int_equal(qv_detail(&scene, &view), QV_OK);
        assert_int_equal(scene.level, 0);
        const double exact = fmax(1, exact_distance(field, spacing / 65536.0));
        const double below = exact - scene.level_distance;
        if (!(below > -1e-3 && below < 1 + 1e-3))
            fail_msg("%u is not %f", (unsigned)scene.level_distance, exact);
    }
}

/* From the nearest step, or out of the distance's range. */
static void distances_have_limits(void **state)
{
    (void)state;

    make(QV_ONE_Q16 * 100, QV_ONE_Q16 * 16);
    aim(0x60000000u);
    assert_int_equal(qv_detail(&scene, &view), QV_OK);
    assert_int_equal(scene.level_distance, 1);
    make(16, QV_ONE_Q16 / 16);
    aim(0x00C00000u);
    scene.volume.spacing[0] = scene.volume.spacing[1] = scene.volume.spacing[2] = 256 * QV_ONE_Q16;
    assert_int_equal(qv_detail(&scene, &view), QV_OK);
    assert_int_equal(scene.level_distance, (1 << 23) - 1);
}

/* A camera that looks away from what its view looks at. */
static void the_plane_behind_the_eye(void **state)
{
    (void)state;

    make(QV_ONE_Q16, QV_ONE_Q16);
    aim(0x20000000u);
    for (unsigned axis = 0; axis < 3; axis++)
        scene.camera.along[axis] = -scene.camera.along[axis];
    assert_int_equal(qv_detail(&scene, &view), QV_OK);
    assert_int_equal(scene.level_distance, 1);
}

/* Farther than any eye that qv_init accepts: 2^24 steps of 1/16 count as 2^22. */
static void an_eye_too_far_away(void **state)
{
    (void)state;

    make(QV_ONE_Q16, QV_ONE_Q16 / 16);
    qv_rotation(view.rotation, 0, 0, 0);
    aim(0x20000000u);
    scene.camera.along[0] = scene.camera.along[2] = 0;
    scene.camera.along[1] = (qv_coord)1 << 52;
    assert_int_equal(qv_detail(&scene, &view), QV_OK);
    assert_int_equal(scene.level_distance, 1 << 22);
}

/* ---- What is refused ---- */

static void expect_refused(qv_status expected)
{
    assert_int_equal(qv_detail(&scene, &view), expected);
    assert_int_equal(scene.level, 0xA5A5);
    assert_int_equal(scene.level_distance, 0xA5A5);
}

static void make_good(void)
{
    make(QV_ONE_Q16, QV_ONE_Q16);
    aim(0);
}

static void null_pointers_are_refused(void **state)
{
    (void)state;

    make_good();
    assert_int_equal(qv_detail(NULL, &view), QV_ERROR_NULL);
    assert_int_equal(qv_detail(&scene, NULL), QV_ERROR_NULL);
    scene.pyramid = NULL;
    expect_refused(QV_ERROR_NULL);
    make_good();
    scene.camera.projection = NULL;
    expect_refused(QV_ERROR_NULL);
}

static void bad_arguments_are_refused(void **state)
{
    (void)state;

    make_good();
    view.pitch = 15;
    expect_refused(QV_ERROR_VIEW);
    make_good();
    view.width = 0;
    expect_refused(QV_ERROR_VIEW);
    make_good();
    view.step = 4095;
    expect_refused(QV_ERROR_STEP);
    make_good();
    scene.volume.spacing[2] = 4095;
    expect_refused(QV_ERROR_SPACING);
    make_good();
    scene.camera.across[0] = INT64_MAX;
    expect_refused(QV_ERROR_CAMERA);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_levels),
        cmocka_unit_test(levels_between),
        cmocka_unit_test(no_more_levels_than_there_are),
        cmocka_unit_test(distances),
        cmocka_unit_test(distances_have_limits),
        cmocka_unit_test(the_plane_behind_the_eye),
        cmocka_unit_test(an_eye_too_far_away),
        cmocka_unit_test(null_pointers_are_refused),
        cmocka_unit_test(bad_arguments_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
