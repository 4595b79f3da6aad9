/*
 * Rotations, and both constructors of cameras.
 */
#include "check.h"
#include "reference.h"
#include "scene_fixture.h"

#include <math.h>
#include <stdlib.h>

#define ONE    0x40000000 /* 1 in Q2.30 */
#define DEGREE (0x100000000 / 360.0)

/* ---- Rotation ---- */

static void expect_rotation(const int32_t expected[3][3], qv_angle azimuth, qv_angle elevation,
                            qv_angle roll)
{
    int32_t rotation[3][3];
    qv_rotation(rotation, azimuth, elevation, roll);
    assert_memory_equal(rotation, expected, sizeof rotation);
}

/* As the header describes them: from the front, from the right, from above, and
   with the head to the right. */
static void rotations_have_the_documented_directions(void **state)
{
    static const int32_t front[3][3] = {{ONE, 0, 0}, {0, 0, -ONE}, {0, ONE, 0}};
    static const int32_t from_right[3][3] = {{0, ONE, 0}, {0, 0, -ONE}, {-ONE, 0, 0}};
    static const int32_t from_above[3][3] = {{ONE, 0, 0}, {0, -ONE, 0}, {0, 0, -ONE}};
    static const int32_t tilted[3][3] = {{0, 0, -ONE}, {-ONE, 0, 0}, {0, ONE, 0}};
    (void)state;

    expect_rotation(front, 0, 0, 0);
    expect_rotation(from_right, QUARTER_TURN, 0, 0);
    expect_rotation(from_above, 0, QUARTER_TURN, 0);
    expect_rotation(tilted, 0, 0, QUARTER_TURN);
}

/* Every row and column holds one +-1; right x down = forward. */
static void quarter_turns_are_exact(void **state)
{
    (void)state;

    for (uint32_t turns = 0; turns < 64; turns++) {
        int32_t r[3][3];
        qv_rotation(r, (turns & 3) * QUARTER_TURN, (turns >> 2 & 3) * QUARTER_TURN,
                    (turns >> 4) * QUARTER_TURN);
        for (unsigned i = 0; i < 3; i++) {
            const unsigned j = (i + 1) % 3, k = (i + 2) % 3;
            for (unsigned axis = 0; axis < 3; axis++)
                assert_true(r[i][axis] % ONE == 0);
            assert_int_equal(labs(r[i][0]) + labs(r[i][1]) + labs(r[i][2]), ONE);
            assert_int_equal(labs(r[0][i]) + labs(r[1][i]) + labs(r[2][i]), ONE);
            assert_int_equal((r[0][j] / ONE) * (r[1][k] / ONE) - (r[0][k] / ONE) * (r[1][j] / ONE),
                             r[2][i] / ONE);
        }
    }
}

static double dot(const int32_t a[3], const int32_t b[3])
{
    double sum = 0;
    for (unsigned axis = 0; axis < 3; axis++)
        sum += ldexp(a[axis], -30) * ldexp(b[axis], -30);
    return sum;
}

static void rotations_are_near_the_real_ones_and_orthonormal(void **state)
{
    uint32_t seed = 3;
    double error = 0, skew = 0;
    (void)state;

    for (unsigned i = 0; i < 20000; i++) {
        const qv_angle azimuth = random_next(&seed), elevation = random_next(&seed);
        const qv_angle roll = i % 2 != 0 ? random_next(&seed) : 0u - elevation;
        int32_t r[3][3];
        double expected[3][3];
        qv_rotation(r, azimuth, elevation, roll);
        ref_rotation(expected, azimuth, elevation, roll);
        for (unsigned row = 0; row < 3; row++)
            for (unsigned other = 0; other < 3; other++) {
                error = fmax(error, fabs(ldexp(r[row][other], -30) - expected[row][other]));
                skew = fmax(skew, fabs(dot(r[row], r[other]) - (row == other ? 1 : 0)));
            }
    }
    assert_true(error <= ldexp(1, -27));
    assert_true(skew <= ldexp(1, -25)); /* four components, each within 2^-27 */
}

/* ---- Constructors ---- */

static fixture f;

/* A frame of 8 rows whose centre is the corner of four pixels, from in front. */
static qv_view plain_view(void)
{
    qv_view view = fixture_view(0, 0, 0);
    view.pitch = QV_ONE_Q16 / 2;
    view.step = QV_ONE_Q16 / 4;
    view.width = 4;
    view.height = 8;
    return view;
}

static void expect_vector(const qv_coord actual[3], qv_coord x, qv_coord y, qv_coord z)
{
    assert_true(actual[0] == x);
    assert_true(actual[1] == y);
    assert_true(actual[2] == z);
}

/* A box of 6 x 5 x 4 whose centre lies at 3, 2.5, 2; in the middle of the frame,
   1.5 pixels to the right of pixel (0, 0) and 3.5 below it. */
static void orthographic_camera_in_numbers(void **state)
{
    const qv_view view = plain_view();
    qv_camera camera;
    (void)state;

    fixture_volume(&f, QV_STORAGE_RGBA8, 1);
    assert_int_equal(qv_orthographic(&camera, &f.scene.volume, &view), QV_OK);
    expect_vector(camera.across, VOXEL / 2, 0, 0);
    expect_vector(camera.down, 0, 0, -VOXEL / 2);
    expect_vector(camera.along, 0, VOXEL / 4, 0);
    expect_vector(camera.pace, 0, 0, 0);
    expect_vector(camera.origin, 3 * VOXEL - 3 * VOXEL / 4, 5 * VOXEL / 2,
                  2 * VOXEL + 7 * VOXEL / 4);
    assert_int_equal(camera.step, view.step);
    assert_true(camera.projection == &qv_projection_orthographic);
}

/* The view's lengths are in world units: a voxel of 2 on x is passed in half as
   many voxels. */
static void spacing_divides_lengths(void **state)
{
    const qv_view view = plain_view();
    qv_camera camera;
    (void)state;

    fixture_volume(&f, QV_STORAGE_RGBA8, 1);
    f.scene.volume.spacing[0] = 2 * QV_ONE_Q16;
    f.scene.volume.spacing[1] = QV_ONE_Q16 / 2;
    assert_int_equal(qv_orthographic(&camera, &f.scene.volume, &view), QV_OK);
    expect_vector(camera.across, VOXEL / 4, 0, 0);
    expect_vector(camera.along, 0, VOXEL / 2, 0);
    assert_int_equal(qv_perspective(&camera, &f.scene.volume, &view, QUARTER_TURN), QV_OK);
    expect_vector(camera.pace, VOXEL / 8, VOXEL / 2, VOXEL / 4);
    expect_vector(camera.across, VOXEL / 2, 0, 0); /* directions are in world units */
}

/* Spacings of 3 and 6 leave thirds of 2^-32 voxel: 1/6 ends in .67, 1/12 in .33. */
static void lengths_round_to_nearest(void **state)
{
    const qv_view view = plain_view();
    qv_camera camera;
    (void)state;

    fixture_volume(&f, QV_STORAGE_RGBA8, 1);
    f.scene.volume.spacing[0] = 3 * QV_ONE_Q16;
    f.scene.volume.spacing[2] = 6 * QV_ONE_Q16;
    assert_int_equal(qv_orthographic(&camera, &f.scene.volume, &view), QV_OK);
    expect_vector(camera.across, VOXEL / 6 + 1, 0, 0);
    expect_vector(camera.down, 0, 0, -(VOXEL / 12));
}

/* At 90 degrees half the frame's height, 2, is the distance of the eye; directions
   lead to the plane through the centre of the box. */
static void perspective_camera_in_numbers(void **state)
{
    const qv_view view = plain_view();
    qv_camera camera;
    (void)state;

    fixture_volume(&f, QV_STORAGE_RGBA8, 1);
    assert_int_equal(qv_perspective(&camera, &f.scene.volume, &view, QUARTER_TURN), QV_OK);
    expect_vector(camera.origin, 3 * VOXEL, 5 * VOXEL / 2 - 2 * VOXEL, 2 * VOXEL);
    expect_vector(camera.across, VOXEL / 2, 0, 0);
    expect_vector(camera.down, 0, 0, -VOXEL / 2);
    expect_vector(camera.along, -3 * VOXEL / 4, 2 * VOXEL, 7 * VOXEL / 4);
    expect_vector(camera.pace, VOXEL / 4, VOXEL / 4, VOXEL / 4);
    assert_int_equal(camera.step, view.step);
    assert_true(camera.projection == &qv_projection_perspective);
}

/* ---- Views that are refused ---- */

/* What both constructors say; they must leave the camera alone. */
static void expect_status(const qv_view *view, qv_angle field_of_view, qv_status orthographic,
                          qv_status perspective)
{
    qv_camera camera;
    fixture_poison(&camera, sizeof camera);
    assert_int_equal(qv_orthographic(&camera, &f.scene.volume, view), orthographic);
    assert_true((orthographic == QV_OK) != fixture_untouched(&camera, sizeof camera));
    fixture_poison(&camera, sizeof camera);
    assert_int_equal(qv_perspective(&camera, &f.scene.volume, view, field_of_view), perspective);
    assert_true((perspective == QV_OK) != fixture_untouched(&camera, sizeof camera));
}

static void frames_out_of_range(void **state)
{
    static const uint16_t bad[] = {0, QV_PIXEL_MAX + 1, 65535}, good[] = {1, 2, QV_PIXEL_MAX};
    qv_view view = plain_view();
    (void)state;

    fixture_volume(&f, QV_STORAGE_RGBA8, 1);
    for (unsigned i = 0; i < 3; i++) {
        view = plain_view();
        view.width = bad[i];
        expect_status(&view, QUARTER_TURN, QV_ERROR_VIEW, QV_ERROR_VIEW);
        view.width = good[i];
        view.height = good[i];
        expect_status(&view, QUARTER_TURN, QV_OK, QV_OK);
        view.height = bad[i];
        expect_status(&view, QUARTER_TURN, QV_ERROR_VIEW, QV_ERROR_VIEW);
    }
}

static void pitch_and_step_out_of_range(void **state)
{
    static const uint32_t pitches[] = {0, 15, (256u << 16) + 1, UINT32_MAX};
    static const uint32_t steps[] = {0, 4095, (16u << 16) + 1, UINT32_MAX};
    qv_view view = plain_view();
    (void)state;

    fixture_volume(&f, QV_STORAGE_RGBA8, 1);
    for (unsigned i = 0; i < 4; i++) {
        view = plain_view();
        view.pitch = pitches[i];
        expect_status(&view, QUARTER_TURN, QV_ERROR_VIEW, QV_ERROR_VIEW);
        view = plain_view();
        view.step = steps[i];
        expect_status(&view, QUARTER_TURN, QV_ERROR_STEP, QV_ERROR_STEP);
    }
    for (unsigned i = 0; i < 4; i++) {
        view.pitch = i % 2 != 0 ? 256u << 16 : 16;
        view.step = i / 2 != 0 ? 16u << 16 : 4096;
        expect_status(&view, QUARTER_TURN, QV_OK, QV_OK);
    }
}

/* 1 and 150 degrees are inside; a frame of 65536 world units is too high. */
static void fields_of_view_out_of_range(void **state)
{
    const qv_angle least = (qv_angle)ceil(DEGREE), most = (qv_angle)floor(150 * DEGREE);
    qv_view view = plain_view();
    (void)state;

    fixture_volume(&f, QV_STORAGE_RGBA8, 1);
    expect_status(&view, 0, QV_OK, QV_ERROR_VIEW);
    expect_status(&view, least - 1, QV_OK, QV_ERROR_VIEW);
    expect_status(&view, least, QV_OK, QV_OK);
    expect_status(&view, most, QV_OK, QV_OK);
    expect_status(&view, most + 1, QV_OK, QV_ERROR_VIEW);
    expect_status(&view, UINT32_MAX, QV_OK, QV_ERROR_VIEW);
    view.pitch = 256u << 16;
    view.height = 255;
    expect_status(&view, QUARTER_TURN, QV_OK, QV_OK);
    view.height = 256;
    expect_status(&view, QUARTER_TURN, QV_OK, QV_ERROR_VIEW);
}

static void spacing_out_of_range(void **state)
{
    const qv_view view = plain_view();
    (void)state;

    for (unsigned axis = 0; axis < 3; axis++) {
        fixture_volume(&f, QV_STORAGE_RGBA8, 1);
        f.scene.volume.spacing[axis] = 4095;
        expect_status(&view, QUARTER_TURN, QV_ERROR_SPACING, QV_ERROR_SPACING);
        f.scene.volume.spacing[axis] = (256u << 16) + 1;
        expect_status(&view, QUARTER_TURN, QV_ERROR_SPACING, QV_ERROR_SPACING);
    }
}

static void null_pointers(void **state)
{
    const qv_view view = plain_view();
    const qv_volume *volume = &f.scene.volume;
    qv_camera camera;
    (void)state;

    fixture_volume(&f, QV_STORAGE_RGBA8, 1);
    fixture_poison(&camera, sizeof camera);
    assert_int_equal(qv_orthographic(NULL, volume, &view), QV_ERROR_NULL);
    assert_int_equal(qv_orthographic(&camera, NULL, &view), QV_ERROR_NULL);
    assert_int_equal(qv_orthographic(&camera, volume, NULL), QV_ERROR_NULL);
    assert_int_equal(qv_perspective(NULL, volume, &view, QUARTER_TURN), QV_ERROR_NULL);
    assert_int_equal(qv_perspective(&camera, NULL, &view, QUARTER_TURN), QV_ERROR_NULL);
    assert_int_equal(qv_perspective(&camera, volume, NULL, QUARTER_TURN), QV_ERROR_NULL);
    assert_true(fixture_untouched(&camera, sizeof camera));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rotations_have_the_documented_directions),
        cmocka_unit_test(quarter_turns_are_exact),
        cmocka_unit_test(rotations_are_near_the_real_ones_and_orthonormal),
        cmocka_unit_test(orthographic_camera_in_numbers),
        cmocka_unit_test(spacing_divides_lengths),
        cmocka_unit_test(lengths_round_to_nearest),
        cmocka_unit_test(perspective_camera_in_numbers),
        cmocka_unit_test(frames_out_of_range),
        cmocka_unit_test(pitch_and_step_out_of_range),
        cmocka_unit_test(fields_of_view_out_of_range),
        cmocka_unit_test(spacing_out_of_range),
        cmocka_unit_test(null_pointers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
