/*
 * The rays of perspective cameras: the centre of the frame, directions against
 * real numbers, the first sample at the eye, and directions that make no ray.
 */
#include "check.h"
#include "ray.h"
#include "scene_fixture.h"

#include <math.h>

#define HALF     (VOXEL / 2)
#define ROUNDING (VOXEL / 512)

static fixture f;
static qv_camera *const camera = &f.scene.camera;

static void make(const qv_view *view, qv_angle field_of_view)
{
    fixture_make(&f, &qv_nearest_rgba8, 1);
    assert_int_equal(qv_perspective(camera, &f.scene.volume, view, field_of_view), QV_OK);
}

static qv_ray ray_of(int32_t x, int32_t y)
{
    const qv_context context = fixture_context(&f);
    qv_ray ray = {.samples = 0};
    if (qv_ray_perspective(&ray, &context, x, y))
        qv_ray_clip(&ray, &context);
    return ray;
}

/* An eye in the middle of the box that looks along z, and pixels of 1/8 in
   direction. */
static void make_by_hand(void)
{
    fixture_make(&f, &qv_nearest_rgba8, 1);
    memset(camera, 0, sizeof *camera);
    camera->projection = &qv_projection_perspective;
    camera->step = QV_ONE_Q16;
    for (unsigned axis = 0; axis < 3; axis++) {
        camera->origin[axis] = f.scene.volume.size[axis] * HALF;
        camera->pace[axis] = VOXEL / 4;
    }
    camera->across[0] = camera->down[1] = VOXEL / 8;
    camera->along[2] = VOXEL;
}

/* ---- Directions ---- */

/* A frame of odd width and height has a pixel in its centre: its ray is the view's
   forward direction and goes through the centre of the box. */
static void the_centre_ray_is_exact_at_quarter_turns(void **state)
{
    (void)state;

    for (uint32_t turns = 0; turns < 64; turns++) {
        const qv_view view =
            fixture_view((turns & 3) * QUARTER_TURN, (turns >> 2 & 3) * QUARTER_TURN,
                         (turns >> 4) * QUARTER_TURN);
        make(&view, QUARTER_TURN / 2);
        const qv_ray ray = ray_of(FIXTURE_WIDTH / 2, FIXTURE_HEIGHT / 2);
        assert_true(ray.samples != 0);
        for (unsigned axis = 0; axis < 3; axis++) {
            const qv_coord centre = f.scene.volume.size[axis] * HALF;
            assert_true(ray.advance[axis] ==
                        camera->pace[axis] / 0x40000000 * view.rotation[2][axis]);
            if (ray.advance[axis] == 0)
                assert_true(ray.place[axis] == centre - HALF + ROUNDING);
        }
    }
}

/* The unit vector of a pixel in real numbers: along + x*across + y*down. */
static void direction(double unit[3], int32_t x, int32_t y)
{
    double square = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        const qv_coord v = camera->along[axis] + x * camera->across[axis] + y * camera->down[axis];
        unit[axis] = ldexp((double)v, -32);
        square += unit[axis] * unit[axis];
    }
    for (unsigned axis = 0; axis < 3; axis++)
        unit[axis] /= sqrt(square);
}

static void directions_are_near_the_real_ones(void **state)
{
    static const qv_angle fields[3] = {0x00B60B61u, QUARTER_TURN / 2, 0x6AAAAAAAu};
    uint32_t seed = 17;
    double error = 0;
    (void)state;

    for (unsigned i = 0; i < 20000; i++) {
        const qv_view view = fixture_view(random_next(&seed), random_next(&seed), i << 29);
        const int32_t x = (int32_t)random_below(&seed, FIXTURE_WIDTH);
        const int32_t y = (int32_t)random_below(&seed, FIXTURE_HEIGHT);
        double unit[3];
        make(&view, fields[i % 3]);
        direction(unit, x, y);
        const qv_ray ray = ray_of(x, y);
        for (unsigned axis = 0; axis < 3 && ray.samples != 0; axis++)
            error = fmax(error,
                         fabs((double)ray.advance[axis] / (double)camera->pace[axis] - unit[axis]));
    }
    assert_true(error > 0);
    assert_true(error <= ldexp(1, -27));
}

/* ---- The first sample ---- */

/* From an eye in the box k starts at 0, and the phase counts from the eye. */
static void samples_start_at_the_eye(void **state)
{
    (void)state;

    make_by_hand(); /* 2 voxels to the far face, in steps of 1/4 */
    for (unsigned i = 0; i < 4; i++) {
        f.scene.phase = (uint16_t)(i << 14);
        const qv_ray ray = ray_of(0, 0);
        assert_true(ray.place[2] + HALF - ROUNDING == camera->origin[2] + i * VOXEL / 16);
        assert_int_equal(ray.samples, 8);
    }
    f.scene.phase = 0;
    camera->along[2] = -VOXEL;
    assert_int_equal(ray_of(0, 0).samples, 9); /* the face at 0 belongs to the box */
}

/* What lies behind the eye is not seen. */
static void nothing_behind_the_eye(void **state)
{
    (void)state;

    make_by_hand();
    camera->origin[2] = 5 * VOXEL;
    assert_int_equal(ray_of(0, 0).samples, 0);
    camera->along[2] = -VOXEL;
    assert_int_equal(ray_of(0, 0).samples, 16);
}

/* ---- Directions that make no ray ---- */

/* Below 2^-16 on every axis. */
static void directions_too_short(void **state)
{
    const qv_coord least = VOXEL >> 16;
    (void)state;

    make_by_hand();
    for (int sign = -1; sign <= 1; sign += 2) {
        camera->along[2] = sign * least;
        assert_true(ray_of(0, 0).samples != 0);
        camera->along[2] = sign * (least - 1);
        assert_int_equal(ray_of(0, 0).samples, 0);
        camera->along[0] = camera->along[2]; /* longer, but not on any axis */
        assert_int_equal(ray_of(0, 0).samples, 0);
        assert_true(ray_of(1, 0).samples != 0);
        camera->along[0] = 0;
    }
}

/* Only the direction of v counts: lengths of 2^-16 to 2^20 world units. */
static void lengths_of_directions_do_not_matter(void **state)
{
    (void)state;

    for (int shift = -16; shift <= 20; shift++) {
        make_by_hand();
        camera->along[0] = shift < 0 ? VOXEL >> -shift : VOXEL << shift;
        camera->along[2] = -camera->along[0];
        const qv_ray ray = ray_of(0, 0);
        assert_in_range(ray.advance[0], 759250124, 759250128); /* 2^30 / sqrt(2) */
        assert_true(ray.advance[2] == -ray.advance[0]);
        assert_true(ray.samples != 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_centre_ray_is_exact_at_quarter_turns),
        cmocka_unit_test(directions_are_near_the_real_ones),
        cmocka_unit_test(samples_start_at_the_eye),
        cmocka_unit_test(nothing_behind_the_eye),
        cmocka_unit_test(directions_too_short),
        cmocka_unit_test(lengths_of_directions_do_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
