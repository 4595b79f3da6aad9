/*
 * stages_ray.c - rays of pixels: section 8.
 */
#include "stages.h"

#include "fx_root.h"
#include "ray.h"

/* ---- Rays of pixels --------------------------------------------------------- */

typedef struct view_inputs {
    int64_t origin[3], across[3], down[3], along[3], x, y;
    uint64_t phase;
} view_inputs;

typedef struct orthographic_row {
    view_inputs in;
    int64_t place[3], advance[3];
} orthographic_row;

static void set_camera(qv_context *context, const view_inputs *in, const int64_t pace[3])
{
    static const qv_context none;
    *context = none;
    for (unsigned axis = 0; axis < 3; axis++) {
        context->scene.camera.origin[axis] = in->origin[axis];
        context->scene.camera.across[axis] = in->across[axis];
        context->scene.camera.down[axis] = in->down[axis];
        context->scene.camera.along[axis] = in->along[axis];
        context->scene.camera.pace[axis] = pace[axis];
    }
    context->scene.phase = (uint16_t)in->phase;
}

static void keep_ray(int64_t place[3], int64_t advance[3], const qv_ray *ray)
{
    for (unsigned axis = 0; axis < 3; axis++) {
        place[axis] = ray->place[axis];
        advance[axis] = ray->advance[axis];
    }
}

static unsigned orthographic_compute(void *columns)
{
    static const int64_t none[3];
    orthographic_row *row = columns;
    qv_context context;
    qv_ray ray;
    set_camera(&context, &row->in, none);
    (void)qv_ray_orthographic(&ray, &context, (int32_t)row->in.x, (int32_t)row->in.y);
    keep_ray(row->place, row->advance, &ray);
    return 0;
}

static void draw_view(view_inputs *in, vector_random *random, unsigned along_bits)
{
    for (unsigned axis = 0; axis < 3; axis++) {
        in->origin[axis] = vector_signed(random, 44);
        in->across[axis] = vector_signed(random, 38);
        in->down[axis] = vector_signed(random, 38);
        in->along[axis] = vector_signed(random, along_bits);
    }
    in->x = vector_between(random, -32767, 32766);
    in->y = vector_between(random, -32767, 32766);
    in->phase = vector_any(random, 16);
}

static void orthographic_draw(void *columns, vector_random *random)
{
    orthographic_row *row = columns;
    draw_view(&row->in, random, 40);
}

/* The ends of the ranges of section 7. */
static void edge_view(view_inputs *in, unsigned number, int64_t along)
{
    int64_t sign = number % 2 ? -1 : 1, full = number / 2 % 2 ? 1 : 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        in->origin[axis] = sign * full * (INT64_C(1) << 52);
        in->across[axis] = sign * (INT64_C(1) << 44);
        in->down[axis] = -sign * (INT64_C(1) << 44);
        in->along[axis] = axis == 1 ? -along : along;
    }
    in->x = number / 4 % 2 ? 32766 : -32767;
    in->y = number / 8 % 2 ? 32766 : 0;
    in->phase = number / 16 % 2 ? 65535 : 0;
}

static void orthographic_edges(vector_set *set)
{
    for (unsigned i = 0; i < 32; i++) {
        orthographic_row row = {.place = {0, 0, 0}};
        edge_view(&row.in, i, INT64_C(1) << 40);
        vector_add(set, &row, VECTOR_EDGE | VECTOR_OVERFLOW);
    }
    for (uint64_t phase = 0x7FFE; phase < 0x8003; phase++) {
        orthographic_row row = {.in = {.along = {1, -1, 3}, .phase = phase}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

#define VIEW_FIELDS(unit)                                                                          \
    {"origin", 3, 'i', "s64.32", "of the camera, axis [i]"},                                       \
        {"across", 3, 'i', "s64.32", "from pixel to pixel to the right, axis [i]"},                \
        {"down", 3, 'i', "s64.32", "from line to line, axis [i]"},                                 \
        {"along", 3, 'i', "s64.32", unit}, {"x", 1, 'i', "s16", "column of the pixel"},            \
        {"y", 1, 'i', "s16", "line of the pixel"},                                                 \
    {                                                                                              \
        "phase", 1, 'i', "u16.16", "of the sample grid"                                            \
    }

static const vector_field orthographic_fields[] = {
    VIEW_FIELDS("from sample to sample, axis [i]"),
    {"place", 3, 'o', "s64.32",
     "origin[i] + x * across[i] + y * down[i] + floor((along[i] * phase + 32768) / 65536)"},
    {"advance", 3, 'o', "s64.32", "along[i]"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_ray_orthographic = {
    .name = "ray_orthographic",
    .section = "8",
    .title = "the ray of a pixel, orthographic",
    .rounding = "the phase's part to nearest, ties upwards",
    .saturation = "none",
    .fields = orthographic_fields,
    .columns = VECTOR_COLUMNS(orthographic_row),
    .seed = 8,
    .random_rows = 200,
    .edges = orthographic_edges,
    .draw = orthographic_draw,
    .compute = orthographic_compute,
};

typedef struct perspective_row {
    view_inputs in;
    int64_t pace[3], v[3];
    uint64_t h, m[3], n, r, e, exists;
    int64_t advance[3], place[3];
} perspective_row;

static uint64_t magnitude_of(int64_t v)
{
    return v < 0 ? 0u - (uint64_t)v : (uint64_t)v;
}

/* The way to the unit vector: v, its bits, their squares, the root. */
static void find_direction(perspective_row *row)
{
    for (unsigned axis = 0; axis < 3; axis++) {
        row->v[axis] =
            row->in.along[axis] + row->in.x * row->in.across[axis] + row->in.y * row->in.down[axis];
        while (magnitude_of(row->v[axis]) >> 31 >> row->h != 0)
            row->h++;
    }
    for (unsigned axis = 0; axis < 3; axis++) {
        row->m[axis] = magnitude_of(row->v[axis]) >> row->h;
        row->n += row->m[axis] * row->m[axis];
    }
    unsigned exponent;
    row->r = fx_rsqrt(row->n, &exponent);
    row->e = exponent;
}

static unsigned perspective_compute(void *columns)
{
    perspective_row *row = columns;
    qv_context context;
    qv_ray ray;
    find_direction(row);
    set_camera(&context, &row->in, row->pace);
    row->exists = qv_ray_perspective(&ray, &context, (int32_t)row->in.x, (int32_t)row->in.y) != 0;
    if (row->exists)
        keep_ray(row->place, row->advance, &ray);
    return 0;
}

static void perspective_draw(void *columns, vector_random *random)
{
    perspective_row *row = columns;
    draw_view(&row->in, random, 48);
    for (unsigned axis = 0; axis < 3; axis++)
        row->pace[axis] = vector_between(random, 1 << 24, INT64_C(1) << 40);
}

static void perspective_edges(vector_set *set)
{
    for (unsigned i = 0; i < 32; i++) {
        perspective_row row = {.pace = {INT64_C(1) << 40, INT64_C(1) << 40, INT64_C(1) << 32}};
        edge_view(&row.in, i, INT64_C(1) << 52);
        vector_add(set, &row, VECTOR_EDGE | VECTOR_OVERFLOW);
    }
    static const int64_t shorts[] = {0, 1, 65535, 65536, 65537, 0x7FFFFFFF, 0x80000000};
    for (unsigned i = 0; i < 21; i++) {
        perspective_row row = {.pace = {INT64_C(1) << 31, INT64_C(1) << 32, INT64_C(3) << 31}};
        row.in.along[i % 3] = i % 2 ? -shorts[i / 3] : shorts[i / 3];
        row.in.phase = 0x5555;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field perspective_fields[] = {
    VIEW_FIELDS("to the plane of the picture, world units, axis [i]"),
    {"pace", 3, 'i', "s64.32", "step in voxels, axis [i]"},
    {"v", 3, 'm', "s64.32", "along[i] + x * across[i] + y * down[i]"},
    {"h", 1, 'm', "u6", "the least integer >= 0 with all |v| < 2^(31+h)"},
    {"m", 3, 'm', "u31", "floor(|v[i]| / 2^h)"},
    {"n", 1, 'm', "u64", "m0 * m0 + m1 * m1 + m2 * m2"},
    {"r", 1, 'm', "u32.30", "r of rsqrt(n)"},
    {"e", 1, 'm', "u6", "x of rsqrt(n)"},
    {"exists", 1, 'o', "u1", "0 where all |v| < 65536; advance and place are then 0"},
    {"advance", 3, 'o', "s64.32",
     "q30(pace[i], sign(v[i]) * min(2^30, floor((m[i] * r + 2^(e-1)) / 2^e)))"},
    {"place", 3, 'o', "s64.32", "origin[i] + floor((advance[i] * phase + 32768) / 65536)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_ray_perspective = {
    .name = "ray_perspective",
    .section = "8",
    .title = "the ray of a pixel, in perspective",
    .rounding = "m is cut; the unit's magnitudes, advance and the phase's part to nearest",
    .saturation = "components of the unit vector at 2^30",
    .fields = perspective_fields,
    .columns = VECTOR_COLUMNS(perspective_row),
    .seed = 808,
    .random_rows = 250,
    .edges = perspective_edges,
    .draw = perspective_draw,
    .compute = perspective_compute,
};
