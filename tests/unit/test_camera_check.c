/*
 * The ranges of a camera made by hand, and the independence of its vectors.
 */
#include "check.h"
#include "camera.h"
#include "scene_fixture.h"

typedef enum projection { ORTHOGRAPHIC, PERSPECTIVE } projection;

/* One voxel from pixel to pixel and from sample to sample. */
static qv_camera by_hand(projection kind)
{
    qv_camera camera = {&qv_projection_orthographic,
                        QV_ONE_Q16,
                        {0, 0, 0},
                        {VOXEL, 0, 0},
                        {0, VOXEL, 0},
                        {0, 0, VOXEL},
                        {0, 0, 0}};
    if (kind == PERSPECTIVE) {
        camera.projection = &qv_projection_perspective;
        camera.pace[0] = camera.pace[1] = camera.pace[2] = VOXEL;
    }
    return camera;
}

static void expect(const qv_camera *camera, qv_status status)
{
    assert_int_equal(qv_camera_check(camera), status);
}

static void no_projection(void **state)
{
    qv_camera camera = by_hand(ORTHOGRAPHIC);
    (void)state;

    camera.projection = NULL;
    expect(&camera, QV_ERROR_NULL);
}

/* ---- Lengths ---- */

/* A component at its limit is in; what lies one bit beyond is out. */
static void expect_limit(qv_camera *camera, qv_coord *component, qv_coord limit)
{
    for (int sign = -1; sign <= 1; sign += 2) {
        *component = sign * limit;
        expect(camera, QV_OK);
        *component = sign * (limit + 1);
        expect(camera, QV_ERROR_CAMERA);
        *component = sign < 0 ? INT64_MIN : INT64_MAX;
        expect(camera, QV_ERROR_CAMERA);
    }
}

/* Each vector along its own axis, so that they stay independent. */
static void vectors_too_long(void **state)
{
    (void)state;

    for (int kind = ORTHOGRAPHIC; kind <= PERSPECTIVE; kind++) {
        qv_camera camera = by_hand((projection)kind);
        for (unsigned axis = 0; axis < 3; axis++) {
            expect_limit(&camera, &camera.origin[axis], VOXEL << 20);
            camera.origin[axis] = 0;
        }
        expect_limit(&camera, &camera.across[0], VOXEL << 12);
        camera.across[0] = VOXEL;
        expect_limit(&camera, &camera.down[1], VOXEL << 12);
        camera.down[1] = VOXEL;
        expect_limit(&camera, &camera.along[2], kind == PERSPECTIVE ? VOXEL << 20 : VOXEL << 8);
    }
}

/* The eye is at most 2^20 paces off, and at most 2^20 voxels. */
static void eyes_too_far(void **state)
{
    (void)state;

    for (unsigned axis = 0; axis < 3; axis++) {
        qv_camera camera = by_hand(PERSPECTIVE);
        camera.pace[axis] = VOXEL / 256;
        expect_limit(&camera, &camera.origin[axis], VOXEL << 12);
        camera.pace[axis] = 2 * VOXEL;
        expect_limit(&camera, &camera.origin[axis], VOXEL << 20);
    }
}

/* The pace of a perspective camera: 2^-8 .. 2^8 voxels on every axis. */
static void paces_out_of_range(void **state)
{
    static const qv_coord bad[] = {1,      VOXEL / 256 - 1, VOXEL * 256 + 1, -1,
                                   -VOXEL, INT64_MAX,       INT64_MIN,       0};
    (void)state;

    for (unsigned axis = 0; axis < 3; axis++) {
        qv_camera camera = by_hand(PERSPECTIVE);
        for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
            camera.pace[axis] = bad[i];
            expect(&camera, QV_ERROR_CAMERA);
        }
        camera.pace[axis] = VOXEL / 256;
        expect(&camera, QV_OK);
        camera.pace[axis] = VOXEL * 256;
        expect(&camera, QV_OK);
    }
}

/* In orthographic cameras along leads from sample to sample: 2^-9 voxel on some axis. */
static void steps_too_short(void **state)
{
    qv_camera camera = by_hand(ORTHOGRAPHIC);
    (void)state;

    for (int sign = -1; sign <= 1; sign += 2) {
        camera.along[2] = sign * (VOXEL / 512);
        expect(&camera, QV_OK);
        camera.along[2] = sign * (VOXEL / 512 - 1);
        expect(&camera, QV_ERROR_CAMERA);
    }
    camera = by_hand(PERSPECTIVE);
    camera.along[2] = VOXEL / 256 - 1; /* a direction of any length */
    expect(&camera, QV_OK);
}

/* ---- Independence ---- */

static void set(qv_coord v[3], qv_coord x, qv_coord y, qv_coord z)
{
    v[0] = x;
    v[1] = y;
    v[2] = z;
}

static void vectors_of_no_length(void **state)
{
    (void)state;

    for (int kind = ORTHOGRAPHIC; kind <= PERSPECTIVE; kind++) {
        for (unsigned i = 0; i < 3; i++) {
            qv_camera camera = by_hand((projection)kind);
            qv_coord *const vectors[3] = {camera.across, camera.down, camera.along};
            set(vectors[i], 0, 0, 0);
            expect(&camera, QV_ERROR_CAMERA);
            vectors[i][i] = 1; /* 2^-32 voxel is too short as well */
            expect(&camera, QV_ERROR_CAMERA);
            vectors[i][i] = VOXEL >> 8;
            expect(&camera, QV_OK);
        }
    }
}

static void a_camera_of_zeros(void **state)
{
    qv_camera camera;
    (void)state;

    memset(&camera, 0, sizeof camera);
    expect(&camera, QV_ERROR_NULL);
    camera.projection = &qv_projection_orthographic;
    expect(&camera, QV_ERROR_CAMERA);
    camera.pace[0] = camera.pace[1] = camera.pace[2] = VOXEL;
    expect(&camera, QV_ERROR_CAMERA);
}

static void parallel_and_coplanar_vectors(void **state)
{
    qv_camera camera = by_hand(ORTHOGRAPHIC);
    (void)state;

    set(camera.across, 3 * VOXEL, VOXEL, -VOXEL);
    set(camera.down, -6 * VOXEL, -2 * VOXEL, 2 * VOXEL); /* -2 across */
    expect(&camera, QV_ERROR_CAMERA);
    set(camera.down, 0, VOXEL, 2 * VOXEL);
    set(camera.along, 3 * VOXEL, 3 * VOXEL, 3 * VOXEL); /* across + 2 down */
    expect(&camera, QV_ERROR_CAMERA);
    set(camera.along, -3 * VOXEL, 3 * VOXEL, 3 * VOXEL);
    expect(&camera, QV_OK);
}

/* With across and down of 1/2 after scaling, the third vector needs 2^-12 beside
   their plane; along is scaled by 2^-1. Of either handedness. */
static void the_least_determinant(void **state)
{
    const qv_coord least = VOXEL >> 11;
    (void)state;

    for (int sign = -1; sign <= 1; sign += 2) {
        qv_camera camera = by_hand(ORTHOGRAPHIC);
        set(camera.along, 0, VOXEL, sign * least);
        expect(&camera, QV_OK);
        set(camera.along, 0, VOXEL, sign * (least - 1));
        expect(&camera, QV_ERROR_CAMERA);
    }
}

/* Long and short vectors in one camera: only directions decide. */
static void lengths_do_not_matter(void **state)
{
    (void)state;

    for (int shift = 0; shift <= 20; shift++) {
        qv_camera camera = by_hand(ORTHOGRAPHIC);
        set(camera.across, VOXEL * 4096, 0, 0);
        set(camera.down, 0, VOXEL * 8 >> shift, 0);
        expect(&camera, QV_OK);
        set(camera.down, VOXEL * 8 >> shift, 0, 0);
        expect(&camera, QV_ERROR_CAMERA);
    }
}

/* Every view of the constructors passes, at the limits of pitch and step too. */
static void views_are_independent(void **state)
{
    static const uint32_t pitches[3] = {16, QV_ONE_Q16, 256u << 16};
    static const uint32_t steps[3] = {4096, QV_ONE_Q16, 16u << 16};
    static fixture f;
    uint32_t seed = 5;
    (void)state;

    fixture_volume(&f, QV_STORAGE_RGBA8, 1);
    for (unsigned i = 0; i < 9000; i++) {
        qv_view view = fixture_view(random_next(&seed), random_next(&seed), random_next(&seed));
        qv_camera camera;
        view.pitch = pitches[i % 3];
        view.step = steps[i / 3 % 3];
        assert_int_equal(qv_orthographic(&camera, &f.scene.volume, &view), QV_OK);
        expect(&camera, QV_OK);
        assert_int_equal(qv_perspective(&camera, &f.scene.volume, &view, QUARTER_TURN), QV_OK);
        expect(&camera, QV_OK);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_projection),         cmocka_unit_test(vectors_too_long),
        cmocka_unit_test(eyes_too_far),          cmocka_unit_test(paces_out_of_range),
        cmocka_unit_test(steps_too_short),       cmocka_unit_test(vectors_of_no_length),
        cmocka_unit_test(a_camera_of_zeros),     cmocka_unit_test(parallel_and_coplanar_vectors),
        cmocka_unit_test(the_least_determinant), cmocka_unit_test(lengths_do_not_matter),
        cmocka_unit_test(views_are_independent),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
