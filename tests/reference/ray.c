#include "reference.h"

#include <math.h>
#include <string.h>

/* ---- A line of samples and the box -------------------------------------- */

/*
 * Points start + k * step in Q31.32 or in real numbers. Real coordinates serve
 * to find the range of k roughly; the caller then decides each end by its own
 * arithmetic.
 */
typedef struct span {
    double low, high;
} span;

/* Cuts the span of k to where one axis lies in 0 .. size. */
static span clip_axis(span k, double start, double step, double size)
{
    if (step == 0) {
        const bool inside = 0 <= start && start < size;
        return inside ? k : (span){HUGE_VAL, -HUGE_VAL};
    }
    const double at_zero = -start / step, at_size = (size - start) / step;
    k.low = fmax(k.low, fmin(at_zero, at_size));
    k.high = fmin(k.high, fmax(at_zero, at_size));
    return k;
}

/* The k of the box that the ray reaches from k = from on. */
static span clip(const double start[3], const double step[3], const uint16_t size[3], double from)
{
    span k = {from, HUGE_VAL};
    for (int axis = 0; axis < 3; axis++) {
        k = clip_axis(k, start[axis], step[axis], size[axis]);
    }
    return k;
}

static bool in_box(const double point[3], const uint16_t size[3])
{
    bool inside = true;
    for (int axis = 0; axis < 3; axis++) {
        inside = inside && 0 <= point[axis] && point[axis] < size[axis];
    }
    return inside;
}

/* Samples that the rough span may miss at either end. */
static const int margin = 2;

/* Sets index and count so that the ray holds every sample in the box, and few others. */
static void enclose(ref_ray *ray, const double start[3], const double step[3],
                    const uint16_t size[3], double from)
{
    const span k = clip(start, step, size, from);
    ray->index = 0;
    ray->count = 0;
    if (k.low <= k.high + margin) {
        ray->index = (int64_t)fmax(floor(k.low) - margin, ceil(from));
        ray->count = (int64_t)ceil(k.high) + margin - ray->index + 1;
    }
}

/* Sets the way through the box of a ray whose samples are counted from the first one. */
static void measure(ref_ray *ray, const uint16_t size[3], double from)
{
    const span way = clip(ray->first, ray->step, size, from - (double)ray->index);
    const bool hits = way.low < way.high;
    ray->enter = hits ? way.low : 0;
    ray->leave = hits ? way.high : 0;
}

/*
 * Drops samples at both ends of a ray that lie outside the box. The box is
 * convex, so what remains is what lies inside.
 */
static void trim(ref_ray *ray, const uint16_t size[3])
{
    double point[3];
    ref_point(point, ray, 0);
    while (ray->count > 0 && !in_box(point, size)) {
        for (int axis = 0; axis < 3; axis++) {
            ray->first[axis] = point[axis] + ray->step[axis];
        }
        ray->enter--;
        ray->leave--;
        ray->index++;
        ray->count--;
        ref_point(point, ray, 0);
    }
    ref_point(point, ray, (double)ray->count - 1);
    while (ray->count > 0 && !in_box(point, size)) {
        ray->count--;
        ref_point(point, ray, (double)ray->count - 1);
    }
}

void ref_point(double point[3], const ref_ray *ray, double steps)
{
    for (int axis = 0; axis < 3; axis++) {
        point[axis] = ray->first[axis] + steps * ray->step[axis];
    }
}

void ref_round_point(double point[3])
{
    for (int axis = 0; axis < 3; axis++) {
        point[axis] = floor(point[axis] * 256 + 0.5) / 256;
    }
}

/* ---- The stored camera -------------------------------------------------- */

static const double two_to_32 = 4294967296.0;

/* round(value * phase / 2^16) for a phase of 16 bits, ties upwards. */
static int64_t times_phase(int64_t value, uint16_t phase)
{
    const int64_t product = value * phase; /* |value| <= 2^38: below 2^54 */
    const int64_t raised = product + 0x8000;
    const int64_t quotient = raised / 0x10000;
    return quotient - (raised % 0x10000 < 0 ? 1 : 0);
}

/*
 * The samples of start + k * step, all Q31.32, of either sign. Integers carry the
 * point to the first sample; from there on every point in the box has at most 12 + 32
 * bits, which a double holds exactly.
 */
static void integer_ray(ref_ray *ray, const int64_t start[3], const int64_t step[3],
                        const uint16_t size[3])
{
    double real_start[3];
    for (int axis = 0; axis < 3; axis++) {
        real_start[axis] = (double)start[axis] / two_to_32;
        ray->step[axis] = (double)step[axis] / two_to_32;
    }
    enclose(ray, real_start, ray->step, size, -HUGE_VAL);
    for (int axis = 0; axis < 3; axis++) {
        ray->first[axis] = (double)(start[axis] + ray->index * step[axis]) / two_to_32;
    }
    measure(ray, size, -HUGE_VAL);
    trim(ray, size);
}

static void stored_orthographic(ref_ray *ray, const qv_scene *scene, int32_t x, int32_t y)
{
    const qv_camera *camera = &scene->camera;
    int64_t start[3];
    for (int axis = 0; axis < 3; axis++) {
        start[axis] = camera->origin[axis] + x * camera->across[axis] + y * camera->down[axis] +
                      times_phase(camera->along[axis], scene->phase);
    }
    integer_ray(ray, start, camera->along, scene->volume.size);
}

/* The samples of start + k * step in real numbers; the ray begins at k = from. */
static void real_ray(ref_ray *ray, const double start[3], const double step[3],
                     const uint16_t size[3], double from)
{
    enclose(ray, start, step, size, from);
    for (int axis = 0; axis < 3; axis++) {
        ray->step[axis] = step[axis];
        ray->first[axis] = start[axis] + (double)ray->index * step[axis];
    }
    measure(ray, size, from);
    trim(ray, size);
}

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/* Whether a direction is one that a perspective camera renders. */
static bool usable(const double v[3])
{
    const double shortest = 1.0 / 65536;
    return fabs(v[0]) >= shortest || fabs(v[1]) >= shortest || fabs(v[2]) >= shortest;
}

static void stored_perspective(ref_ray *ray, const qv_scene *scene, int32_t x, int32_t y)
{
    const qv_camera *camera = &scene->camera;
    double v[3], start[3], step[3];
    for (int axis = 0; axis < 3; axis++) {
        const int64_t sum = camera->along[axis] + x * camera->across[axis] + y * camera->down[axis];
        v[axis] = (double)sum / two_to_32;
    }
    if (!usable(v)) {
        memset(ray, 0, sizeof *ray);
        return;
    }
    const double phase = scene->phase / 65536.0;
    for (int axis = 0; axis < 3; axis++) {
        step[axis] = (double)camera->pace[axis] / two_to_32 * v[axis] / length(v);
        start[axis] = (double)camera->origin[axis] / two_to_32 + phase * step[axis];
    }
    real_ray(ray, start, step, scene->volume.size, -phase);
}

void ref_stored_ray(ref_ray *ray, const qv_scene *scene, int32_t x, int32_t y)
{
    if (scene->camera.projection == &qv_projection_perspective) {
        stored_perspective(ray, scene, x, y);
    } else {
        stored_orthographic(ray, scene, x, y);
    }
}

/* ---- The ideal camera --------------------------------------------------- */

static double spacing(const qv_volume *volume, int axis)
{
    return volume->spacing[axis] == 0 ? 1 : volume->spacing[axis] / 65536.0;
}

/* World units from the eye to the plane through the volume's centre. */
static double eye_distance(const ref_view *view)
{
    return view->height / 2 * view->pitch / tan(view->field_of_view / 2);
}

void ref_ideal_ray(ref_ray *ray, const qv_scene *scene, const ref_view *view, int32_t x, int32_t y)
{
    const bool perspective = view->field_of_view > 0;
    const double right = (x + 0.5 - view->width / 2) * view->pitch;
    const double down = (y + 0.5 - view->height / 2) * view->pitch;
    const double forward = perspective ? eye_distance(view) : 0;
    const double phase = scene->phase / 65536.0;
    double aim[3], start[3], step[3];
    for (int axis = 0; axis < 3; axis++) {
        aim[axis] = right * view->rotation[0][axis] + down * view->rotation[1][axis] +
                    forward * view->rotation[2][axis];
    }
    for (int axis = 0; axis < 3; axis++) {
        const double unit = spacing(&scene->volume, axis);
        const double direction = perspective ? aim[axis] / length(aim) : view->rotation[2][axis];
        const double from = perspective ? -forward * view->rotation[2][axis] : aim[axis];
        step[axis] = direction * view->step / unit;
        start[axis] = scene->volume.size[axis] / 2.0 + from / unit + phase * step[axis];
    }
    real_ray(ray, start, step, scene->volume.size, perspective ? -phase : -HUGE_VAL);
}
