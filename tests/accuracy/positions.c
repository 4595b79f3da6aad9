/*
 * Positions: how far the library's samples lie from the ideal ray in volumes of
 * 4096 voxels per axis, for every kind of view and steps from 1/16.
 */
#include "check.h"
#include "draw.h"
#include "ray.h"
#include "reference.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define VIEWS  1500
#define PIXELS 8 /* of each view */
#define POINTS 8 /* of each ray */

/* A ray that grazes an edge may miss it; one with more ideal samples in the box may not. */
#define CERTAIN 100

static const double two_to_32 = 4294967296.0;
static const double pi = 3.14159265358979323846;

/* The documented distance from the ideal ray is 2^-12 + 2^-29 * s / least_spacing, where s
   is measured from a point in world units; `eye` is what the eye may add along the ray. */
typedef struct documented {
    double from[3], spacing[3], least_spacing;
    double eye;
} documented;

/* Largest distances in voxels, before a point is rounded to 1/256 voxel and after. */
typedef struct distances {
    double from_ray, rounded_from_ray;       /* from the ideal ray, a line */
    double from_sample, rounded_from_sample; /* from the same sample on the ideal ray */
    documented at_hand;
    double exceeded;              /* the documented distances, by how much; below 0: never */
    double near_rounded_from_ray; /* of samples within 2^17 least spacings */
    uint64_t points;
    int refused; /* views whose eye is farther off than the library goes */
    int lost;    /* rays that it did not see in a view that it took */
} distances;

typedef struct view_kind {
    const char *name;
    bool perspective;
    double narrowest, widest; /* field of view in degrees */
    double most_spacing;      /* spacings lie between 1 / this and this */
    bool may_be_refused;      /* an eye too far off, or vectors that spacing makes too alike */
} view_kind;

/* ---- A scene of the largest volume; its voxels are never read ------------- */

static void huge_volume(qv_volume *volume, const view_kind *kind, draws *random)
{
    static const unsigned char memory[QV_PALETTE8_BYTES];
    memset(volume, 0, sizeof *volume);
    volume->voxels = memory;
    volume->palette = memory;
    volume->palette_bytes = QV_PALETTE8_BYTES;
    volume->storage = QV_STORAGE_INDEXED8;
    for (int axis = 0; axis < 3; axis++) {
        const double spacing = draw_scale(random, 1 / kind->most_spacing, kind->most_spacing);
        volume->size[axis] = QV_AXIS_MAX;
        volume->spacing[axis] = (uint32_t)(65536 * spacing);
        volume->stride[axis] = 1 << (12 * axis);
    }
    volume->voxels_bytes = (uint64_t)1 << 36;
}

static void draw_view(qv_view *view, ref_view *real, const view_kind *kind, draws *random)
{
    const uint32_t turn = draw_once_in(random, 8) ? 0xc0000000u : 0xffffffffu;
    const qv_angle azimuth = draw_bits(random) & turn;
    const qv_angle elevation = draw_bits(random) & turn;
    const qv_angle roll = draw_bits(random) & turn;
    view->height = (uint16_t)draw_scale(random, 64, 4096);
    view->width = (uint16_t)(view->height * draw_scale(random, 0.5, 2));
    const double pitch = QV_AXIS_MAX * 65535.0 / view->height * kind->most_spacing;
    view->pitch = (uint32_t)fmin(pitch, 256 * 65536);
    view->step = (uint32_t)(65536 * draw_scale(random, 1.0 / 16, 4));
    qv_rotation(view->rotation, azimuth, elevation, roll);
    ref_rotation(real->rotation, azimuth, elevation, roll);
    real->pitch = view->pitch / 65536.0;
    real->step = view->step / 65536.0;
    real->width = view->width;
    real->height = view->height;
}

static void draw_scene(qv_scene *scene, ref_view *real, const view_kind *kind, draws *random)
{
    qv_view view;
    memset(scene, 0, sizeof *scene);
    huge_volume(&scene->volume, kind, random);
    draw_view(&view, real, kind, random);
    scene->phase = (uint16_t)draw_bits(random);
    scene->sampling = &qv_nearest_indexed8;
    real->field_of_view = 0;
    if (kind->perspective) {
        const double degrees = draw_scale(random, kind->narrowest, kind->widest);
        const qv_angle field = (qv_angle)(degrees / 360 * two_to_32);
        real->field_of_view = field / two_to_32 * 2 * pi;
        assert_int_equal(qv_perspective(&scene->camera, &scene->volume, &view, field), QV_OK);
    } else {
        assert_int_equal(qv_orthographic(&scene->camera, &scene->volume, &view), QV_OK);
    }
}

/* ---- The library's points beside the ideal ones --------------------------- */

/* Sample j of the library's ray: exactly, and cut as its cells cut it. */
static void library_point(double exact[3], double rounded[3], const qv_ray *ray, uint32_t j)
{
    for (int axis = 0; axis < 3; axis++) {
        const int64_t place = ray->place[axis] + (int64_t)j * ray->advance[axis];
        const double shifted = (double)place / two_to_32;
        exact[axis] = shifted + 0.5 - 1.0 / 512;
        rounded[axis] = floor(shifted * 256) / 256 + 0.5;
    }
}

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* Steps along the ideal ray from its first sample to the foot of a point. */
static double steps_to(const ref_ray *ideal, const double point[3])
{
    double along = 0;
    for (int axis = 0; axis < 3; axis++) {
        along += (point[axis] - ideal->first[axis]) * ideal->step[axis];
    }
    return along / (length(ideal->step) * length(ideal->step));
}

/* Distance of a point from where the ideal ray is after some steps. */
static double from_place(const ref_ray *ideal, const double point[3], double steps)
{
    double offset[3];
    for (int axis = 0; axis < 3; axis++) {
        offset[axis] = point[axis] - (ideal->first[axis] + steps * ideal->step[axis]);
    }
    return length(offset);
}

static void compare_documented(distances *worst, const double exact[3], double line,
                               double rounded_line, double sample)
{
    const documented *d = &worst->at_hand;
    double offset[3];
    for (int axis = 0; axis < 3; axis++) {
        offset[axis] = (exact[axis] - d->from[axis]) * d->spacing[axis];
    }
    const double spacings = length(offset) / d->least_spacing;
    const double allowed = ldexp(1, -12) + ldexp(spacings, -29);
    worst->exceeded = fmax(worst->exceeded, line - allowed);
    worst->exceeded = fmax(worst->exceeded, sample - allowed - d->eye);
    if (spacings <= 131072) {
        worst->near_rounded_from_ray = fmax(worst->near_rounded_from_ray, rounded_line);
    }
}

/* Sample j of the library's ray, which is sample first + j of the ideal one. */
static void compare_point(distances *worst, const ref_ray *ideal, const qv_ray *ray, double first,
                          uint32_t j)
{
    double exact[3], rounded[3];
    library_point(exact, rounded, ray, j);
    const double line = from_place(ideal, exact, steps_to(ideal, exact));
    const double rounded_line = from_place(ideal, rounded, steps_to(ideal, rounded));
    worst->from_ray = fmax(worst->from_ray, line);
    worst->rounded_from_ray = fmax(worst->rounded_from_ray, rounded_line);
    worst->from_sample = fmax(worst->from_sample, from_place(ideal, exact, first + j));
    worst->rounded_from_sample =
        fmax(worst->rounded_from_sample, from_place(ideal, rounded, first + j));
    compare_documented(worst, exact, line, rounded_line, from_place(ideal, exact, first + j));
    worst->points++;
}

/* Both ends of the ray and points between them. The ideal ray may begin a sample earlier or
   later where the two cross a face. */
static void compare_ray(distances *worst, const qv_scene *scene, const ref_view *view,
                        const qv_context *context, draws *random)
{
    const int32_t x = (int32_t)draw_below(random, (uint32_t)view->width);
    const int32_t y = (int32_t)draw_below(random, (uint32_t)view->height);
    qv_ray ray;
    ref_ray ideal;
    scene->camera.projection->ray(&ray, context, x, y);
    qv_ray_clip(&ray, context);
    ref_ideal_ray(&ideal, scene, view, x, y);
    if (ray.samples == 0 || ideal.count == 0) {
        worst->lost += ideal.count > CERTAIN;
        return;
    }
    double start[3], rounded[3];
    library_point(start, rounded, &ray, 0);
    const double first = floor(steps_to(&ideal, start) + 0.5);
    compare_point(worst, &ideal, &ray, first, 0);
    compare_point(worst, &ideal, &ray, first, ray.samples - 1);
    for (int i = 2; i < POINTS; i++) {
        compare_point(worst, &ideal, &ray, first, draw_below(random, ray.samples));
    }
}

/* What the header allows in a view. */
static void set_documented(documented *d, const qv_scene *scene, const ref_view *view)
{
    double eye = 0;
    d->least_spacing = HUGE_VAL;
    for (int axis = 0; axis < 3; axis++) {
        const double middle = scene->volume.size[axis] / 2.0;
        const double origin = (double)scene->camera.origin[axis] / two_to_32;
        d->spacing[axis] = scene->volume.spacing[axis] / 65536.0;
        d->least_spacing = fmin(d->least_spacing, d->spacing[axis]);
        d->from[axis] = view->field_of_view == 0 ? middle : origin;
        eye += pow((middle - origin) * d->spacing[axis], 2);
    }
    d->eye = 0;
    if (view->field_of_view != 0) {
        d->eye = ldexp(sqrt(eye), -28) / sin(view->field_of_view / 2) / d->least_spacing;
    }
}

static void test_kind(const view_kind *kind)
{
    draws random = draw_seeded(1998);
    distances worst = {.exceeded = -1};
    qv_scene scene;
    qv_context context;
    ref_view view;
    for (int i = 0; i < VIEWS; i++) {
        draw_scene(&scene, &view, kind, &random);
        const qv_status status = qv_init(&context, &scene);
        if (status == QV_ERROR_CAMERA && kind->may_be_refused) {
            worst.refused++;
            continue;
        }
        assert_int_equal(status, QV_OK);
        set_documented(&worst.at_hand, &scene, &view);
        for (int pixel = 0; pixel < PIXELS; pixel++) {
            compare_ray(&worst, &scene, &view, &context, &random);
        }
    }
    printf("# %s: %d views, %d refused, %ju samples\n", kind->name, VIEWS, worst.refused,
           (uintmax_t)worst.points);
    printf("#   from the ideal ray: %.7f voxel (2^%.2f), rounded to 1/256: %.6f (1/%.1f)\n",
           worst.from_ray, log2(worst.from_ray), worst.rounded_from_ray,
           1 / worst.rounded_from_ray);
    printf("#   from the ideal sample: %.7f voxel (2^%.2f), rounded: %.6f (1/%.1f)\n",
           worst.from_sample, log2(worst.from_sample), worst.rounded_from_sample,
           1 / worst.rounded_from_sample);
    assert_true(worst.refused < VIEWS * 9 / 10);
    assert_true(worst.points > VIEWS);
    assert_int_equal(worst.lost, 0);
    assert_true(worst.near_rounded_from_ray <= 1.0 / 256);
    assert_true(worst.exceeded <= 0);
}

static void test_orthographic(void **state)
{
    const view_kind kind = {"orthographic", false, 0, 0, 1, false};
    (void)state;
    test_kind(&kind);
}

static void test_orthographic_spaced(void **state)
{
    const view_kind kind = {"orthographic, spacing 1/4 to 4", false, 0, 0, 4, false};
    (void)state;
    test_kind(&kind);
}

static void test_perspective(void **state)
{
    const view_kind kind = {"perspective, 20 to 150 degrees", true, 20, 150, 1, false};
    (void)state;
    test_kind(&kind);
}

static void test_perspective_spaced(void **state)
{
    const view_kind kind = {"perspective, spacing 1/4 to 4", true, 20, 150, 4, false};
    (void)state;
    test_kind(&kind);
}

static void test_every_spacing(void **state)
{
    const view_kind orthographic = {"orthographic, spacing 1/16 to 16", false, 0, 0, 16, true};
    const view_kind wide = {"perspective, spacing 1/16 to 16", true, 20, 150, 16, true};
    const view_kind narrow = {
        "perspective, 1 to 20 degrees, spacing 1/16 to 16", true, 1, 20, 16, true};
    (void)state;
    test_kind(&orthographic);
    test_kind(&wide);
    test_kind(&narrow);
}

static void test_perspective_narrow(void **state)
{
    const view_kind kind = {"perspective, 1 to 20 degrees", true, 1, 20, 1, true};
    (void)state;
    test_kind(&kind);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_orthographic),       cmocka_unit_test(test_orthographic_spaced),
        cmocka_unit_test(test_perspective),        cmocka_unit_test(test_perspective_spaced),
        cmocka_unit_test(test_perspective_narrow), cmocka_unit_test(test_every_spacing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
