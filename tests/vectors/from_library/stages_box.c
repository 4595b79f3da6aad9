/*
 * stages_box.c - where rays meet the box, and the pieces of their way: sections 9, 37, 38 and 44.
 */
#include "stages.h"

#include "ray.h"
#include "stretch.h"

/* ---- Clipping --------------------------------------------------------------- */

typedef struct box_inputs {
    uint64_t n[3];
    int64_t place[3], advance[3];
} box_inputs;

typedef struct clip_row {
    box_inputs in;
    int64_t least;
    uint64_t samples;
    int64_t k0, point[3];
} clip_row;

static void set_box(qv_context *context, qv_ray *ray, const box_inputs *in)
{
    static const qv_context none;
    static const qv_ray nowhere;
    *context = none;
    *ray = nowhere;
    for (unsigned axis = 0; axis < 3; axis++) {
        context->scene.volume.size[axis] = (uint16_t)in->n[axis];
        ray->place[axis] = in->place[axis];
        ray->advance[axis] = in->advance[axis];
    }
}

static unsigned clip_compute(void *columns)
{
    clip_row *row = columns;
    qv_context context;
    qv_ray ray;
    set_box(&context, &ray, &row->in);
    ray.first = (int32_t)row->least;
    qv_ray_clip(&ray, &context);
    row->samples = ray.samples;
    if (ray.samples == 0)
        return 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        row->point[axis] = ray.place[axis];
        if (row->in.advance[axis] != 0)
            row->k0 = (ray.place[axis] - QV_CENTRED - row->in.place[axis]) / row->in.advance[axis];
    }
    return 0;
}

/* A ray through a point of the box, some steps from sample 0. */
static void draw_box(box_inputs *in, vector_random *random)
{
    int64_t k = vector_between(random, -2000, 2000);
    for (unsigned axis = 0; axis < 3; axis++) {
        in->n[axis] = (uint64_t)vector_between(random, 1, 500);
        in->advance[axis] = vector_signed(random, 34);
        in->place[axis] =
            (int64_t)(vector_bits(random, 63) % (in->n[axis] << 32)) - k * in->advance[axis];
        if (vector_bits(random, 3) == 0)
            in->place[axis] += vector_signed(random, 42);
    }
    if (in->advance[0] == 0)
        in->advance[0] = INT64_C(1) << 31;
}

static void clip_draw(void *columns, vector_random *random)
{
    clip_row *row = columns;
    draw_box(&row->in, random);
    row->least = vector_bits(random, 1) ? 0 : -QV_GRID_LIMIT;
}

/* Along one axis, forwards and backwards, with the faces hit or just not hit. */
static box_inputs edge_box(unsigned number)
{
    static const int64_t starts[] = {
        -1, 0, 1, (INT64_C(3) << 32) - 1, INT64_C(3) << 32, -(INT64_C(3) << 31), INT64_C(7) << 31};
    static const int64_t steps[] = {INT64_C(1) << 31,    -(INT64_C(1) << 31), INT64_C(1) << 32,
                                    -(INT64_C(1) << 32), 0x55555555,          1 << 23};
    const unsigned axis = number / 42 % 3;
    box_inputs in = {.n = {3, 3, 3}};
    for (unsigned other = 0; other < 3; other++)
        in.place[other] = INT64_C(1) << 32;
    in.place[axis] = starts[number % 7];
    in.advance[axis] = steps[number / 7 % 6];
    return in;
}

enum { BOX_EDGES = 3 * 42 };

static void clip_edges(vector_set *set)
{
    for (unsigned i = 0; i < BOX_EDGES; i++) {
        const clip_row row = {.in = edge_box(i), .least = i % 4 == 0 ? 0 : -QV_GRID_LIMIT};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

#define BOX_FIELDS                                                                                 \
    {"n", 3, 'i', "u13", "voxels on axis [i]"},                                                    \
        {"place", 3, 'i', "s64.32", "sample 0 of the ray on axis [i]"},                            \
    {                                                                                              \
        "advance", 3, 'i', "s64.32", "from sample to sample on axis [i]"                           \
    }

/* Sample numbers at the ends of the grid. */
static void clip_added(vector_set *set)
{
    static const int64_t firsts[] = {QV_GRID_LIMIT,         QV_GRID_LIMIT - 1, QV_GRID_LIMIT - 9,
                                     QV_GRID_LIMIT / 2 + 1, -QV_GRID_LIMIT,    9 - QV_GRID_LIMIT};
    for (unsigned i = 0; i < 12; i++) {
        const int64_t step = i < 6 ? 1 << 23 : -(1 << 23);
        clip_row row = {.in = {.n = {4096, 1, 1}, .advance = {step, 0, 0}},
                        .least = -QV_GRID_LIMIT};
        row.in.place[0] = (i < 6 ? 0 : (INT64_C(4096) << 32) - 1) - firsts[i % 6] * step;
        vector_add(set, &row, VECTOR_EDGE | VECTOR_OVERFLOW);
    }
    const clip_row slow = {.in = {{4, 4, 4}, {-5, INT64_C(4) << 32, 7}, {1, -1, 0}}}; /* shortest */
    vector_add(set, &slow, VECTOR_EDGE);
    for (unsigned i = 0; i < 12; i++) { /* the longest steps */
        const int64_t step = (i < 6 ? 1 : -1) * (INT64_C(1) << 40);
        clip_row row = {.in = {.n = {4096, 4096, 4096}, .advance = {step, -step, step}},
                        .least = -QV_GRID_LIMIT};
        for (unsigned axis = 0; axis < 3; axis++)
            row.in.place[axis] =
                (INT64_C(2048) << 32) + axis - firsts[i % 6] * row.in.advance[axis];
        vector_add(set, &row, VECTOR_EDGE | VECTOR_OVERFLOW);
    }
}

static const vector_field clip_fields[] = {
    BOX_FIELDS,
    {"least", 1, 'i', "s23", "least sample number"},
    {"samples", 1, 'o', "u24", "K1 - K0 + 1, or 0 where there are none; the rest is then 0"},
    {"k0", 1, 'o', "s23", "K0, the first sample in the box"},
    {"point", 3, 'o', "s64.32", "place[i] + k0 * advance[i] - 2^31 + 2^23"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_clip = {
    .name = "clip",
    .section = "9",
    .title = "the samples of a ray that lie in the box",
    .rounding = "none: exact",
    .saturation = "sample numbers at least and at 2^22 - 1",
    .fields = clip_fields,
    .columns = VECTOR_COLUMNS(clip_row),
    .seed = 9,
    .random_rows = 250,
    .edges = clip_edges,
    .added = clip_added,
    .draw = clip_draw,
    .compute = clip_compute,
};

/* ---- The way through the box ------------------------------------------------ */

typedef struct way_row {
    box_inputs in;
    uint64_t eye, phase, exists;
    int64_t enter, leave;
} way_row;

static unsigned way_compute(void *columns)
{
    way_row *row = columns;
    qv_context context;
    qv_ray ray;
    set_box(&context, &ray, &row->in);
    context.scene.phase = (uint16_t)row->phase;
    ray.first = row->eye ? 0 : -QV_GRID_LIMIT;
    qv_path_clip(&ray, &context);
    row->exists = ray.samples != 0;
    row->enter = row->exists ? ray.enter : 0;
    row->leave = row->exists ? ray.leave : 0;
    return 0;
}

static void way_draw(void *columns, vector_random *random)
{
    way_row *row = columns;
    draw_box(&row->in, random);
    row->eye = vector_bits(random, 1);
    row->phase = vector_any(random, 16);
}

static void way_edges(vector_set *set)
{
    for (unsigned i = 0; i < BOX_EDGES; i++) {
        const way_row row = {.in = edge_box(i), .eye = i % 2, .phase = i % 4 < 2 ? 0 : 0x5555};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Found by search: here a bit less of a long divisor shows. */
static void way_added(vector_set *set)
{
    static const way_row rows[] = {{.in = {{385, 91, 86},
                                           {-4009306429647, 12243954277370, -945645799975},
                                           {-2868982404, 6454733266, -615462468}}},
                                   {.in = {{278, 115, 387},
                                           {-3920714595369, 4203341052147, -123538858624},
                                           {3185821520, -3258316039, 644262908}}},
                                   {.in = {{175, 26, 231},
                                           {-2285986186990, -1172636844972, -1031806067420},
                                           {7309771770, 2914571586, 2611452191}}},
                                   {.in = {{213, 221, 232},
                                           {-1589306841304, 1922046741564, 1751922848949},
                                           {6308485290, -3694678981, -4118747260}}}};
    for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++)
        vector_add(set, &rows[i], VECTOR_EDGE);
    const way_row slow = {.in = {{4, 4, 4}, {-5, INT64_C(4) << 32, 7}, {1, -1, 0}}, .eye = 1};
    vector_add(set, &slow, VECTOR_EDGE); /* the shortest steps that there are */
}

static const vector_field way_fields[] = {
    BOX_FIELDS,
    {"eye", 1, 'i', "u1", "1 in perspective, 0 in orthographic views"},
    {"phase", 1, 'i', "u16.16", "of the sample grid"},
    {"exists", 1, 'o', "u1", "1 where there is a way; else the rest is 0"},
    {"enter", 1, 'o', "s64.24", "enter of section 37"},
    {"leave", 1, 'o', "s64.24", "leave of section 37"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_way = {
    .name = "way",
    .section = "37",
    .title = "where a ray enters and leaves the box",
    .rounding = "cut towards sample 0, to even positions",
    .saturation = "positions at the eye, or at -2^46 and 2^46",
    .fields = way_fields,
    .columns = VECTOR_COLUMNS(way_row),
    .seed = 37,
    .random_rows = 250,
    .edges = way_edges,
    .added = way_added,
    .draw = way_draw,
    .compute = way_compute,
};

/* ---- Pieces ----------------------------------------------------------------- */

typedef struct piece_row {
    int64_t place[3], advance[3], begin, leave;
    uint64_t level;
    int64_t end;
    uint64_t length;
    int64_t t, point[3];
} piece_row;

static unsigned piece_compute(void *columns)
{
    piece_row *row = columns;
    qv_ray ray = {.enter = row->begin, .leave = row->leave};
    qv_run run;
    for (unsigned axis = 0; axis < 3; axis++) {
        ray.place[axis] = row->place[axis];
        ray.advance[axis] = row->advance[axis];
    }
    qv_run_begin(&run, &ray);
    (void)qv_next_run(&run, &ray, row->leave, (unsigned)row->level);
    row->length = run.length;
    row->t = run.middle;
    row->end = 2 * run.middle - row->begin;
    for (unsigned axis = 0; axis < 3; axis++)
        row->point[axis] = ray.place[axis];
    return 0;
}

static void piece_draw(void *columns, vector_random *random)
{
    piece_row *row = columns;
    row->level = vector_bits(random, 1) ? 0 : vector_bits(random, 2);
    row->begin = 2 * vector_between(random, -(1 << 28), 1 << 28);
    row->leave = row->begin + 2 * vector_between(random, 1, 1 << 25);
    for (unsigned axis = 0; axis < 3; axis++) {
        row->advance[axis] = vector_signed(random, 36);
        row->place[axis] = vector_signed(random, 44);
    }
}

/* Stretches that are whole, cut at either end, and as short as they can be; l at ties. */
static void piece_edges(vector_set *set)
{
    static const int64_t begins[] = {-(1 << 23), 0, (1 << 23) - 2, -(3 << 23), 2};
    static const int64_t lengths[] = {2, 126, 128, 130, 384, 1 << 23, 1 << 24, 3 << 24};
    for (unsigned i = 0; i < 5 * 8 * 2; i++) {
        const piece_row row = {.place = {INT64_C(5) << 31, INT64_C(3) << 32, 1},
                               .advance = {0x55555555, -0x12345678, INT64_C(1) << 40},
                               .begin = begins[i / 8 % 5],
                               .leave = begins[i / 8 % 5] + lengths[i % 8],
                               .level = i / 40 * 2};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* The longest steps, the farthest pieces and the coarsest levels. */
static void piece_added(vector_set *set)
{
    for (unsigned i = 0; i < 16; i++) {
        const int64_t way = (i % 2 ? -1 : 1) * ((INT64_C(1) << 46) - (INT64_C(1) << 37));
        piece_row row = {.begin = way, .level = i / 4 % 4 * 4};
        row.leave = way + (i / 2 % 2 ? INT64_C(1) << 37 : 6);
        for (unsigned axis = 0; axis < 3; axis++) {
            row.advance[axis] = (axis == 1 ? -1 : 1) * (INT64_C(1) << 40);
            row.place[axis] = (INT64_C(5) << 32) - (way >> 24) * row.advance[axis];
        }
        vector_add(set, &row, VECTOR_EDGE | VECTOR_OVERFLOW);
    }
}

static const vector_field piece_fields[] = {
    {"place", 3, 'i', "s64.32", "sample 0 of the ray on axis [i]"},
    {"advance", 3, 'i', "s64.32", "from sample to sample on axis [i]"},
    {"begin", 1, 'i', "s64.24", "where the piece begins, even"},
    {"leave", 1, 'i', "s64.24", "where the way ends, even, above begin"},
    {"level", 1, 'i', "u4", "l of section 44; 0 of section 38"},
    {"end", 1, 'm', "s64.24",
     "min(leave, 2^(24+level) (floor((begin + 2^23) / 2^(24+level)) + 1) - 2^23)"},
    {"length", 1, 'o', "u29.16", "floor((end - begin + 128) / 256)"},
    {"t", 1, 'o', "s64.24", "begin + (end - begin) / 2"},
    {"point", 3, 'o', "s64.32",
     "floor((place[i] + floor((t * advance[i] + 2^23) / 2^24)) / 2^level) - 2^31 + 2^23"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_piece = {
    .name = "piece",
    .section = "38, 44",
    .title = "the first piece of a way, its length and its middle",
    .rounding = "length and point to nearest, ties upwards; the point of a level is cut",
    .saturation = "none",
    .fields = piece_fields,
    .columns = VECTOR_COLUMNS(piece_row),
    .seed = 38,
    .random_rows = 250,
    .edges = piece_edges,
    .added = piece_added,
    .draw = piece_draw,
    .compute = piece_compute,
};
