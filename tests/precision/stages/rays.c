/*
 * rays.c - angles, roots, rotations, lengths in voxels, and the directions of rays.
 */
#include "search.h"

#include "camera.h"
#include "fx_angle.h"
#include "fx_root.h"
#include "ray.h"
#include "stretch.h"

#include <string.h>

#define PI 3.141592653589793238462643383279502884L

static long double angle_of(uint64_t angle)
{
    return ldexpl((long double)angle, -31) * PI;
}

/* ---- Sine, root --------------------------------------------------------------------------- */

static double sine_error(const uint64_t angle[], unsigned unused)
{
    int32_t sine, cosine;
    (void)unused;
    fx_sine_cosine(&sine, &cosine, (fx_angle)angle[0]);
    const long double by_sine = sine - ldexpl(sinl(angle_of(angle[0])), 30);
    const long double by_cosine = cosine - ldexpl(cosl(angle_of(angle[0])), 30);
    return (double)(fabsl(by_sine) > fabsl(by_cosine) ? by_sine : by_cosine);
}

static double root_error(const uint64_t n[], unsigned unused)
{
    unsigned exponent;
    (void)unused;
    if (n[0] == 0)
        return NO_SUCH_INPUT;
    const uint32_t root = fx_rsqrt(n[0], &exponent);
    const long double found = ldexpl(root, -30 - (int)exponent);
    return (double)ldexpl(found * sqrtl((long double)n[0]) - 1, 30);
}

static void tell_number(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "0x%llX", (unsigned long long)input[0]);
}

static void measure_sine(measured *m, unsigned parameter)
{
    static const search s = {sine_error, tell_number, 1, {UINT32_MAX}};
    search_worst(m, &s, parameter);
}

static void measure_root(measured *m, unsigned parameter)
{
    static const search s = {root_error, tell_number, 1, {UINT64_MAX}};
    search_worst(m, &s, parameter);
}

/* ---- Rotation ----------------------------------------------------------------------------- */

static void exact_rotation(long double row[3][3], const uint64_t angle[3])
{
    const long double sa = sinl(angle_of(angle[0])), ca = cosl(angle_of(angle[0]));
    const long double se = sinl(angle_of(angle[1])), ce = cosl(angle_of(angle[1]));
    const long double sr = sinl(angle_of(angle[2])), cr = cosl(angle_of(angle[2]));
    const long double right[3] = {ca, sa, 0}, down[3] = {sa * se, -ca * se, -ce};
    for (unsigned axis = 0; axis < 3; axis++) {
        row[0][axis] = right[axis] * cr + down[axis] * sr;
        row[1][axis] = down[axis] * cr - right[axis] * sr;
    }
    row[2][0] = -sa * ce;
    row[2][1] = ca * ce;
    row[2][2] = -se;
}

static double rotation_error(const uint64_t angle[], unsigned unused)
{
    int32_t rotation[3][3];
    long double exact[3][3];
    double worst = 0;
    (void)unused;
    qv_rotation(rotation, (qv_angle)angle[0], (qv_angle)angle[1], (qv_angle)angle[2]);
    exact_rotation(exact, angle);
    for (unsigned i = 0; i < 9; i++) {
        const long double error = rotation[i / 3][i % 3] - ldexpl(exact[i / 3][i % 3], 30);
        worst = fmax(worst, (double)fabsl(error));
    }
    return worst;
}

static void tell_angles(measured *m, const uint64_t angle[], unsigned unused)
{
    (void)unused;
    measured_input(m, "0x%X, 0x%X, 0x%X", (unsigned)angle[0], (unsigned)angle[1],
                   (unsigned)angle[2]);
}

static void measure_rotation(measured *m, unsigned parameter)
{
    static const search s = {rotation_error, tell_angles, 3, {UINT32_MAX, UINT32_MAX, UINT32_MAX}};
    search_worst(m, &s, parameter);
}

/* ---- Lengths ------------------------------------------------------------------------------ */

enum { LEAST_SPACING = 4096 };

static double voxels_error(const uint64_t input[], unsigned unused)
{
    qv_volume volume;
    (void)unused;
    memset(&volume, 0, sizeof volume);
    volume.spacing[0] = (uint32_t)input[1] + LEAST_SPACING;
    const qv_coord found = qv_voxels((uint32_t)input[0], &volume, 0);
    return (double)(found - ldexpl((long double)input[0], 32) / volume.spacing[0]);
}

static void tell_length(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "length %u, spacing %u", (unsigned)input[0],
                   (unsigned)input[1] + LEAST_SPACING);
}

static void measure_voxels(measured *m, unsigned parameter)
{
    static const search s = {voxels_error, tell_length, 2, {1 << 24, (1 << 24) - LEAST_SPACING}};
    search_worst(m, &s, parameter);
}

/* ---- Directions of perspective ------------------------------------------------------------ */

/* Three components of 40 bits with 8 fraction bits more; the pace shows 30 bits of each. */
enum { HALF_RANGE_BITS = 39, PACE_BITS = 40 };

static long double component_of(uint64_t number)
{
    return (long double)number - ((uint64_t)1 << HALF_RANGE_BITS);
}

/* The library's advance in units of 2^-30 of the pace, and the exact one; 0 without a ray. */
static int directions(long double found[3], long double exact[3], const uint64_t input[])
{
    static qv_context context;
    qv_camera *camera = &context.scene.camera;
    qv_ray ray;
    long double square = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        camera->along[axis] = (qv_coord)component_of(input[axis]);
        camera->pace[axis] = (qv_coord)1 << PACE_BITS;
        square += component_of(input[axis]) * component_of(input[axis]);
    }
    if (!qv_ray_perspective(&ray, &context, 0, 0))
        return 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        found[axis] = ldexpl((long double)ray.advance[axis], 30 - PACE_BITS);
        exact[axis] = ldexpl(component_of(input[axis]) / sqrtl(square), 30);
    }
    return 1;
}

static double direction_error(const uint64_t input[], unsigned unused)
{
    long double found[3], exact[3], worst = 0;
    (void)unused;
    if (!directions(found, exact, input))
        return NO_SUCH_INPUT;
    for (unsigned axis = 0; axis < 3; axis++)
        worst = fmaxl(worst, fabsl(found[axis] - exact[axis]));
    return (double)worst;
}

static void tell_direction(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "along (%.0Lf, %.0Lf, %.0Lf)", component_of(input[0]), component_of(input[1]),
                   component_of(input[2]));
}

static void measure_direction(measured *m, unsigned parameter)
{
    static const search s = {direction_error,
                             tell_direction,
                             3,
                             {(uint64_t)2 << HALF_RANGE_BITS, (uint64_t)2 << HALF_RANGE_BITS,
                              (uint64_t)2 << HALF_RANGE_BITS}};
    search_worst(m, &s, parameter);
}

/* ---- Way through the box ------------------------------------------------------------------ */

/* Where a ray along x leaves a box of 4096 voxels. Numbers: the place of sample 0, and how far the
   advance is above its least. */
enum { BOX = 4096, LEAST_ADVANCE = 1 << 24 };
#define ADVANCE_MOST ((uint64_t)1 << 40)

static double way_error(const uint64_t input[], unsigned unused)
{
    static qv_context context;
    qv_ray ray;
    const uint64_t advance = input[1] + LEAST_ADVANCE;
    const long double way = (long double)((uint64_t)BOX << 32) - (long double)input[0];
    const long double exact = ldexpl(way / (long double)advance, QV_STEP_BITS);
    (void)unused;
    memset(&ray, 0, sizeof ray);
    for (unsigned axis = 0; axis < 3; axis++)
        context.scene.volume.size[axis] = BOX;
    ray.place[0] = (qv_coord)input[0];
    ray.advance[0] = (qv_coord)advance;
    ray.first = -QV_GRID_LIMIT;
    qv_path_clip(&ray, &context);
    return (double)((long double)ray.leave - exact);
}

static void tell_way(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "place 0x%llX, advance 0x%llX", (unsigned long long)input[0],
                   (unsigned long long)input[1] + LEAST_ADVANCE);
}

static void measure_way(measured *m, unsigned parameter)
{
    static const search s = {
        way_error, tell_way, 2, {((uint64_t)BOX << 32) - 1, ADVANCE_MOST - LEAST_ADVANCE}};
    search_worst(m, &s, parameter);
}

/* ---- The chapter -------------------------------------------------------------------------- */

static const stage stages[] = {
    {"sine and cosine", "angle u32 to s32.30", "series; last to nearest", "2^-30", 2, 2, "search",
     measure_sine, 0, NULL},
    {"reciprocal root", "u64 to u32.30 by 2^x", "Newton, products to nearest", "2^-30 of it", 1.5,
     2, "search", measure_root, 0, NULL},
    {"rotation", "3 angles u32 to 9 s32.30", "products to nearest", "2^-30", 5.22, 2, "search",
     measure_rotation, 0, NULL},
    {"length in voxels", "2 u32.16 to s64.32", "quotient, to nearest", "2^-32 voxel", .5, 2,
     "search", measure_voxels, 0, NULL},
    {"direction of a ray", "3 s64.32 to 3 s32.30", "cut, root, product to nearest", "2^-30", 2.42,
     2, "search", measure_direction, 0, NULL},
    {"way through the box", "2 s64.32 to s64.24", "quotient, cut to even", "2^-24 step", 2.02, 2,
     "search", measure_way, 0, NULL},
};

const chapter chapter_rays = {
    "Ray set-up (SPEC 2, 4 to 9, 37)",
    "**Sine.** In units of 2^-32: each of four steps rounds a coefficient and a product, 1/2\n"
    "each, and the first coefficient stands for one more term, within .6: 5.2, and 1/2 for the\n"
    "product with u. The last rounding, to 30 bits, is 1/2 of 2^-30: 5.7 / 4 + 1/2 = 1.9;\n"
    "cosine 2.0. Of all angles (`make test-exhaustive`) the worst is 1.0716 off.\n\n"
    "**Root.** In units of 2^-30 of r: the iteration has converged; the last one rounds f r^2\n"
    "twice (1/2 of its own unit in all, after the factor 1/2), r once (1/2), and f was cut\n"
    "(1/2).\n\n"
    "**Rotation.** With d = 1.08 for a sine or cosine, of all angles, and a, e, r for azimuth,\n"
    "elevation and roll from 0 to 90 degrees: x of the first row is right cos r + down sin r, off\n"
    "by d (cos r + (sin a + sin e) sin r) through right and down, d (cos a + sin a sin e) through\n"
    "the roll, and by roundings of 1/2 sin r + 1/2 + 1/2: together 5.22 at most. The others\n"
    "are like it, with sines and cosines changed, or less.\n\n"
    "**Length.** One quotient to nearest. From there on an orthographic ray is exact: pixel and\n"
    "sample numbers multiply whole numbers.\n\n"
    "**Direction.** In units of 2^-30, of a component x of the unit vector: the cuts of the\n"
    "other two, less than 1 each of 2^30 or more, lengthen it by sqrt(2) x sqrt(1 - x^2) at\n"
    "most, its own shortens it by 1 - x^2; the root is off by 1.5 x, the product by 1/2: 2.42,\n"
    "at x = .87. 4096 steps of a voxel make 9e-6 voxel of it, 1/200 of what a position is\n"
    "rounded by (1.4).\n\n"
    "**Way.** The place where a ray leaves the box, in steps, is cut to even units of 2^-24:\n"
    "less than 2, and 2^-6 for bits of a long advance that are dropped before. Samples are\n"
    "clipped exactly.\n",
    stages, COUNT(stages)};
