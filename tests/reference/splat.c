#include "freevoxels.h"

#include "attenuation.h"

#include <math.h>
#include <string.h>

/* What is narrower or wider than this in pixels is not drawn. */
static const double least_width = 1.0 / 64, most_width = 4096;

static double spacing_of(const qv_volume *volume, int axis)
{
    return volume->spacing[axis] == 0 ? 1 : volume->spacing[axis] / 65536.0;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- Where the eye is --------------------------------------------------------- */

/* World units from the eye to the plane through the volume's centre. */
static double eye_distance(const ref_view *view)
{
    return view->height / 2 * view->pitch / tan(view->field_of_view / 2);
}

/* From the centre of the volume to the centre of a voxel, world units. */
static void from_centre(double way[3], const ref_splats *splats, int level, const int32_t at[3])
{
    const qv_volume *volume = &splats->levels[0];
    for (int axis = 0; axis < 3; axis++) {
        const double voxels = ldexp(at[axis] + 0.5, level) - volume->size[axis] / 2.0;
        way[axis] = voxels * spacing_of(volume, axis);
    }
}

bool ref_splat_eye(int32_t at[3], const ref_splats *splats)
{
    const qv_volume *volume = &splats->levels[0];
    bool inside = splats->view.field_of_view > 0;
    for (int axis = 0; inside && axis < 3; axis++) {
        const double back = eye_distance(&splats->view) * splats->view.rotation[2][axis];
        at[axis] = (int32_t)floor(volume->size[axis] / 2.0 - back / spacing_of(volume, axis));
        inside = at[axis] >= 0 && at[axis] < volume->size[axis];
    }
    return inside;
}

/* ---- Footprints --------------------------------------------------------------- */

/* The root of the sum of squares of what a voxel's edges span in a direction, world units. */
static double spread(const ref_splats *splats, const double direction[3], int level)
{
    double square = 0;
    for (int axis = 0; axis < 3; axis++) {
        square += pow(direction[axis] * spacing_of(&splats->levels[0], axis), 2);
    }
    return ldexp(sqrt(square), level);
}

void ref_splat_footprint(ref_footprint *found, const ref_splats *splats, int level,
                         const int32_t at[3])
{
    const ref_view *view = &splats->view;
    const bool perspective = view->field_of_view > 0;
    const double distance = perspective ? eye_distance(view) : 0;
    const double half[2] = {view->width / 2, view->height / 2};
    double way[3];
    from_centre(way, splats, level, at);
    found->ahead = distance + dot(way, view->rotation[2]);
    const double pixels = (perspective ? distance / found->ahead : 1) / view->pitch;
    for (int i = 0; i < 2; i++) {
        found->centre[i] = half[i] + dot(way, view->rotation[i]) * pixels;
        found->width[i] = spread(splats, view->rotation[i], level) * pixels;
    }
    for (int axis = 0; axis < 3; axis++) {
        const double ahead = view->rotation[2][axis];
        const double toward = perspective ? -distance * ahead - way[axis] : -ahead;
        found->toward[axis] = toward / spacing_of(&splats->levels[0], axis);
    }
}

/* The integral of a kernel of area 1 from its left edge: linear, and the quadratic B-spline. */
static double linear_integral(double t)
{
    const double u = fmin(fmax(t, -1), 1);
    return u < 0 ? (1 + u) * (1 + u) / 2 : 1 - (1 - u) * (1 - u) / 2;
}

static double quadratic_integral(double t)
{
    const double u = fmin(fmax(t, -1.5), 1.5);
    if (fabs(u) <= 0.5) {
        return 0.5 + 0.75 * u - u * u * u / 3;
    }
    const double tail = pow(1.5 - fabs(u), 3) / 6;
    return u < 0 ? tail : 1 - tail;
}

/* The share of a kernel that is as wide as its voxel in a pixel, as a part of the pixel. */
static double share(const ref_splats *splats, double pixel, double centre, double width)
{
    const double from = (pixel - centre) / width, to = (pixel + 1 - centre) / width;
    return splats->kernel == 2 ? width * (linear_integral(to) - linear_integral(from))
                               : width * (quadratic_integral(to) - quadratic_integral(from));
}

/* ---- What is drawn -------------------------------------------------------------- */

/* Half a voxel by its longest side. */
static double half_voxel(const ref_splats *splats, int level)
{
    double longest = 0;
    for (int axis = 0; axis < 3; axis++) {
        longest = fmax(longest, spacing_of(&splats->levels[0], axis));
    }
    return ldexp(longest, level) / 2;
}

static double width_in_pixels(const ref_splats *splats, int level, const int32_t at[3])
{
    ref_footprint footprint;
    ref_splat_footprint(&footprint, splats, level, at);
    const bool in_front =
        splats->view.field_of_view == 0 || footprint.ahead >= half_voxel(splats, level);
    return in_front ? fmax(footprint.width[0], footprint.width[1]) : HUGE_VAL;
}

bool ref_splat_is_drawn(const ref_splats *splats, int level, const int32_t at[3])
{
    const qv_splat_scene *scene = splats->scene;
    const double detail = scene->detail / 256.0;
    bool drawn = level >= scene->level && level <= scene->coarsest;
    if (drawn && level > scene->level) {
        drawn = width_in_pixels(splats, level, at) <= detail;
    }
    for (int coarser = level + 1; drawn && coarser <= scene->coarsest; coarser++) {
        const int up = coarser - level;
        const int32_t parent[3] = {at[0] >> up, at[1] >> up, at[2] >> up};
        drawn = width_in_pixels(splats, coarser, parent) > detail;
    }
    return drawn;
}

/* How far from the frame's centre an eye sees voxels: the frame, and the kernel of the finest level at
   the distance of the centre, or of a coarser voxel as wide as they are drawn. */
static double reach_of(const ref_splats *splats, int axis)
{
    const qv_splat_scene *scene = splats->scene;
    const ref_view *view = &splats->view;
    const double voxel = spread(splats, view->rotation[axis], scene->level) / view->pitch;
    const double coarse = scene->coarsest > scene->level ? scene->detail / 256.0 : 0;
    return (axis == 0 ? view->width : view->height) + splats->kernel * fmax(voxel, coarse);
}

/* Of what an eye sees, half a voxel before it, and not beyond its reach. */
static bool before_eye(const ref_splats *splats, const ref_footprint *footprint, int level)
{
    const ref_view *view = &splats->view;
    return footprint->ahead >= half_voxel(splats, level) &&
           fabs(footprint->centre[0] - view->width / 2) <= reach_of(splats, 0) &&
           fabs(footprint->centre[1] - view->height / 2) <= reach_of(splats, 1);
}

static bool in_sight(const ref_splats *splats, const ref_footprint *footprint, int level)
{
    const bool in_front = splats->view.field_of_view == 0 || before_eye(splats, footprint, level);
    const double least = fmin(footprint->width[0], footprint->width[1]);
    const double most = fmax(footprint->width[0], footprint->width[1]);
    return in_front && least >= least_width && most <= most_width;
}

/* ---- Light ---------------------------------------------------------------------- */

/* To the outside, or to the eye's voxel if the eye has one. */
static double transmittance(const ref_splats *splats, const double v[3], int level,
                            const int32_t at[3])
{
    const ref_depths *depths = &splats->depths;
    double depth = depths->along(depths->in, level, at, v);
    if (splats->inside) {
        depth -= depths->along(depths->in, 0, splats->eye, v);
    }
    return exp2(-fmax(depth, 0));
}

/* ambient + the sum over lamps of colour * transmittance, at most 1. */
static void illuminate(double light[3], const ref_splats *splats, int level, const int32_t at[3])
{
    const qv_lighting *lighting = &splats->scene->lighting;
    const ref_depths *depths = &splats->depths;
    const uint16_t *ambient = lighting->ambient;
    const bool unlit = lighting->count == 0 && (ambient[0] | ambient[1] | ambient[2]) == 0;
    for (int channel = 0; channel < 3; channel++) {
        light[channel] = unlit ? 1 : ambient[channel] / 65535.0;
    }
    for (int i = 0; i < lighting->count; i++) {
        const qv_lamp *lamp = &lighting->lamps[i];
        double v[3];
        for (int axis = 0; axis < 3; axis++) {
            v[axis] = lamp->direction[axis] / spacing_of(&splats->levels[0], axis);
        }
        const double passes = exp2(-depths->along(depths->in, level, at, v));
        for (int channel = 0; channel < 3; channel++) {
            light[channel] += lamp->colour[channel] / 65535.0 * passes;
        }
    }
    for (int channel = 0; channel < 3; channel++) {
        light[channel] = fmin(light[channel], 1);
    }
}

/* The opacity of a voxel along a step. Where opacities hold for a step of any direction, it is
   one of level 0. */
static double step_opacity(const ref_splats *splats, int level, double channel, const double v[3])
{
    const qv_volume *volume = &splats->levels[0];
    const bool by_step = !ref_holds_extinction(volume->storage) && volume->unit_distance == 0;
    const double depth =
        by_step ? ref_depth(channel) : ref_extinction(channel, volume) * ref_step_length(volume, v);
    return -expm1(-log(2) * ldexp(depth, level));
}

/* ---- Splats --------------------------------------------------------------------- */

/* A voxel as it is to be added: associated colour and opacity, before its kernel. */
typedef struct splat {
    ref_footprint footprint;
    double light[4];
    double weight; /* with which a layer of splats across the view adds up to 1 */
} splat;

/*
 * With how many layers of voxels a splat's share in the volume is to be multiplied, so that the
 * splats of each layer add up to 1: a voxel fills its volume, and its kernel covers a column of
 * the area of width times height. Lengths double on each level, which leaves the quotient as it
 * is.
 */
static double layer_weight(const ref_splats *splats, const double toward[3])
{
    const ref_view *view = &splats->view;
    double voxel = 1, layers = 0, ahead = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double side = spacing_of(&splats->levels[0], axis);
        voxel *= side;
        layers = fmax(layers, fabs(toward[axis]));
        ahead -= toward[axis] * side * view->rotation[2][axis];
    }
    const double area = spread(splats, view->rotation[0], 0) * spread(splats, view->rotation[1], 0);
    return voxel / area * layers / ahead;
}

static void make_splat(splat *made, const ref_splats *splats, int level, const int32_t at[3])
{
    const double *toward = made->footprint.toward;
    double rgba[4], lit[3];
    ref_voxel(rgba, &splats->levels[level], at);
    illuminate(lit, splats, level, at);
    made->light[3] = step_opacity(splats, level, rgba[3], toward);
    for (int channel = 0; channel < 3; channel++) {
        made->light[channel] = rgba[channel] * lit[channel] * made->light[3];
    }
    made->weight = layer_weight(splats, toward);
}

/* Adds a share of it (equation 10). */
static void add(ref_sums sum, const splat *of, double part)
{
    for (int channel = 0; channel < 4; channel++) {
        sum[channel] += of->light[channel] * part;
    }
}

/* Blends a share of it (equation 9), of which no channel is more than 1. */
static void blend(ref_sums sum, const splat *of, double part)
{
    const double kept = 1 - fmin(of->light[3] * part, 1);
    for (int channel = 0; channel < 4; channel++) {
        sum[channel] = fmin(sum[channel] * kept + fmin(of->light[channel] * part, 1), 1);
    }
}

static int first_pixel(const ref_splats *splats, const ref_footprint *footprint, int axis)
{
    const double reach = splats->kernel / 2.0 * footprint->width[axis];
    return (int)fmax(floor(footprint->centre[axis] - reach), 0);
}

static int end_pixel(const ref_splats *splats, const ref_footprint *footprint, int axis,
                     double frame)
{
    const double reach = splats->kernel / 2.0 * footprint->width[axis];
    return (int)fmin(ceil(footprint->centre[axis] + reach), frame);
}

static void put_all(ref_sums *sums, const ref_splats *splats, const splat *of)
{
    const ref_footprint *footprint = &of->footprint;
    const int width = (int)splats->view.width;
    const int left = first_pixel(splats, footprint, 0), top = first_pixel(splats, footprint, 1);
    const int right = end_pixel(splats, footprint, 0, splats->view.width);
    const int bottom = end_pixel(splats, footprint, 1, splats->view.height);
    for (int y = top; y < bottom; y++) {
        const double row = of->weight * share(splats, y, footprint->centre[1], footprint->width[1]);
        for (int x = left; x < right; x++) {
            const double column = share(splats, x, footprint->centre[0], footprint->width[0]);
            if (splats->over) {
                blend(sums[y * width + x], of, row * column);
            } else {
                add(sums[y * width + x], of, row * column);
            }
        }
    }
}

void ref_splat(ref_sums *sums, const ref_splats *splats, int level, const int32_t at[3])
{
    splat made;
    if (!ref_splat_is_drawn(splats, level, at)) {
        return;
    }
    ref_splat_footprint(&made.footprint, splats, level, at);
    if (!in_sight(splats, &made.footprint, level)) {
        return;
    }
    make_splat(&made, splats, level, at);
    if (made.light[3] == 0) {
        return;
    }
    if (!splats->over) {
        const double passes = transmittance(splats, made.footprint.toward, level, at);
        for (int channel = 0; channel < 4; channel++) {
            made.light[channel] *= passes;
        }
    }
    put_all(sums, splats, &made);
}

void ref_splat_level(ref_sums *sums, const ref_splats *splats, int level)
{
    const uint16_t *size = splats->levels[level].size;
    int32_t at[3];
    for (at[2] = 0; at[2] < size[2]; at[2]++) {
        for (at[1] = 0; at[1] < size[1]; at[1]++) {
            for (at[0] = 0; at[0] < size[0]; at[0]++) {
                ref_splat(sums, splats, level, at);
            }
        }
    }
}

/* ---- Before and after ----------------------------------------------------------- */

static void background_of(double associated[4], const qv_splat_scene *scene)
{
    associated[3] = scene->background[3] / 255.0;
    for (int channel = 0; channel < 3; channel++) {
        associated[channel] = scene->background[channel] / 255.0 * associated[3];
    }
}

void ref_splat_clear(ref_sums *sums, const ref_splats *splats)
{
    const size_t pixels = (size_t)splats->view.width * (size_t)splats->view.height;
    double start[4] = {0, 0, 0, 0};
    if (splats->over) {
        background_of(start, splats->scene);
    }
    for (size_t i = 0; i < pixels; i++) {
        memcpy(sums[i], start, sizeof start);
    }
}

void ref_splat_read_out(ref_pixel *pixel, const ref_sums sum, const ref_splats *splats)
{
    double background[4];
    pixel->opacity = fmin(sum[3], 1);
    for (int channel = 0; channel < 4; channel++) {
        pixel->rgba[channel] = fmin(sum[channel], pixel->opacity);
    }
    if (!splats->over) {
        background_of(background, splats->scene);
        ref_under(pixel->rgba, background);
    }
}
