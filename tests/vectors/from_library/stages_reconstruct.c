/*
 * stages_reconstruct.c - other samples: nearest, the extinction of stored opacity, B-splines;
 * sections 12, 40 and 41.
 */
#include "corners.h"
#include "stages.h"

#include "bspline.h"

#include <string.h>

/* ---- Nearest ---------------------------------------------------------------- */

typedef struct nearest_row {
    uint64_t f[3], wide, channel[4][8], corner, skipped, o, l[3];
} nearest_row;

static unsigned nearest_compute(void *columns)
{
    nearest_row *row = columns;
    const unsigned storage = row->wide ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBA8;
    const int32_t bytes = (int32_t)qv_entry_bytes(storage);
    corners at;
    set_corners(&at, row->channel, storage);
    qv_cell cell = {.base = at.at[0]};
    for (unsigned axis = 0; axis < 3; axis++) {
        cell.fraction[axis] = fx_fraction_of((uint32_t)row->f[axis]);
        cell.next[axis] = (qv_offset)bytes << axis;
    }
    const qv_address voxel = qv_cell_nearest_voxel(&cell);
    qv_sample sample;
    row->corner = (uint64_t)(voxel - at.at[0]) / (uint64_t)bytes;
    row->skipped = !qv_sample_entry(&sample, voxel, storage);
    if (row->skipped)
        return 0;
    row->o = fx_share_bits(sample.opacity);
    for (unsigned c = 0; c < 3; c++)
        row->l[c] = fx_sum_bits(sample.light[c]);
    return 0;
}

static void nearest_draw(void *columns, vector_random *random)
{
    nearest_row *row = columns;
    row->wide = vector_bits(random, 1);
    draw_corners(row->f, row->channel, random, row->wide ? 16 : 8);
}

static void nearest_edges(vector_set *set)
{
    for (unsigned i = 0; i < 16; i++) {
        nearest_row row = {.wide = i / 8};
        for (unsigned q = 0; q < 32; q++)
            row.channel[q / 8][q % 8] = 10 * q + 1u - q / 31u * 56u;
        for (unsigned axis = 0; axis < 3; axis++)
            row.f[axis] = 127 + (i >> axis & 1u);
        for (unsigned q = 0; q < 32; q++)
            row.channel[q / 8][q % 8] %= 256;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field nearest_fields[] = {
    FRACTIONS,
    {"wide", 1, 'i', "u1", "storage: 0 of 8 bits, 1 of 16 bits"},
    ENTRIES("u16"),
    {"corner", 1, 'm', "u3", "q, with bit axis set where f of that axis is 128 or more"},
    {"skipped", 1, 'o', "u1", "1 where a of the corner is 0; o and l are then 0"},
    {"o", 1, 'o', "u32", "65536 times a of the corner"},
    {"l", 3, 'o', "u32",
     "o times colour [i] of the corner, where wide = 1 floor(o * colour / 65536)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_nearest = {
    .name = "nearest",
    .section = "12",
    .title = "the nearest corner",
    .rounding = "none: exact",
    .saturation = "none",
    .fields = nearest_fields,
    .columns = VECTOR_COLUMNS(nearest_row),
    .seed = 1221,
    .random_rows = 60,
    .edges = nearest_edges,
    .draw = nearest_draw,
    .compute = nearest_compute,
};

/* ---- Extinction of stored opacity ------------------------------------------- */

typedef struct converted_row {
    uint64_t f[3], channel[4][8], w[8], e[8], h[8], skipped, s, o, l[3];
} converted_row;

static unsigned converted_compute(converted_row *row, unsigned storage)
{
    corners at;
    qv_sample sample;
    fx_fraction fraction[3];
    set_corners(&at, row->channel, storage);
    set_weights(row->w, row->f);
    for (unsigned axis = 0; axis < 3; axis++)
        fraction[axis] = fx_fraction_of((uint32_t)row->f[axis]);
    row->skipped = !qv_interpolate_corners(&sample, at.at, fraction, storage, QV_BY_DENSITY);
    if (row->skipped)
        return 0;
    row->s = sample.scale;
    for (unsigned q = 0; q < 8; q++) {
        const fx_weight weight = fx_weight_of((uint32_t)row->w[q]);
        row->e[q] = qv_density(at.at[q], storage);
        row->h[q] = fx_share_bits(qv_share(weight, at.at[q], sample.scale, storage, QV_BY_DENSITY));
    }
    row->o = fx_share_bits(sample.opacity);
    for (unsigned c = 0; c < 3; c++)
        row->l[c] = fx_sum_bits(sample.light[c]);
    return row->o == 0x7FFFFFFFu ? VECTOR_OVERFLOW : 0;
}

static unsigned converted8_compute(void *row)
{
    return converted_compute(row, QV_STORAGE_RGBA8);
}

static unsigned converted16_compute(void *row)
{
    return converted_compute(row, QV_STORAGE_RGBA16);
}

static void converted8_draw(void *columns, vector_random *random)
{
    converted_row *row = columns;
    draw_corners(row->f, row->channel, random, 8);
}

static void converted16_draw(void *columns, vector_random *random)
{
    converted_row *row = columns;
    draw_corners(row->f, row->channel, random, 16);
}

static void add_converted(vector_set *set, const uint64_t f[3], uint64_t channel[4][8])
{
    converted_row row = {.f = {f[0], f[1], f[2]}};
    memcpy(row.channel, channel, sizeof row.channel);
    vector_add(set, &row, VECTOR_EDGE);
}

static void converted8_edges(vector_set *set)
{
    corner_edges(set, 8, add_converted);
}

static void converted16_edges(vector_set *set)
{
    corner_edges(set, 16, add_converted);
}

#define SUM(before, after)                                                                         \
    before "0" after "0) + " before "1" after "1) + " before "2" after "2) + " before "3" after    \
           "3) + " before "4" after "4) + " before "5" after "5) + " before "6" after              \
           "6) + " before "7" after "7)"

#define CONVERTED_FIELDS(format, extinction, factor)                                               \
    FRACTIONS, ENTRIES(format), CORNER_WEIGHTS, {"e", 8, 'm', "u30.24", extinction},               \
        {"h", 8, 'm', "u32", "hi(2^15 w[i], 2^(s+2) e[i])"},                                       \
        {"skipped", 1, 'o', "u1", "1 where all a are 0; e, h, s, o and l are then 0"},             \
        {"s", 1, 'o', "u5", "the least integer >= 0 with max(e) * 2^s >= 2^29"},                   \
        {"o", 1, 'o', "u32", "h0 + h1 + h2 + h3 + h4 + h5 + h6 + h7"},                             \
        {"l0", 1, 'o', "u32", SUM("shift16(h", factor "r")},                                       \
        {"l1", 1, 'o', "u32", SUM("shift16(h", factor "g")},                                       \
        {"l2", 1, 'o', "u32", SUM("shift16(h", factor "b")},                                       \
    {                                                                                              \
        NULL, 0, 0, NULL, NULL                                                                     \
    }

static const vector_field converted8_fields[] = {
    CONVERTED_FIELDS("unorm8", "ext8(a[i]) - floor(ext8(a[i]) / 2^30)", ", 257 ")};

const vector_stage stage_converted8 = {
    .name = "converted8",
    .section = "41",
    .title = "sample of the extinction of 8-bit opacities",
    .rounding = "h to nearest, ties upwards; terms are cut",
    .saturation = "none",
    .fields = converted8_fields,
    .columns = VECTOR_COLUMNS(converted_row),
    .seed = 4108,
    .random_rows = 150,
    .edges = converted8_edges,
    .draw = converted8_draw,
    .compute = converted8_compute,
};

static const vector_field converted16_fields[] = {
    CONVERTED_FIELDS("unorm16", "ext16(a[i]) - floor(ext16(a[i]) / 2^30)", ", ")};

const vector_stage stage_converted16 = {
    .name = "converted16",
    .section = "41",
    .title = "sample of the extinction of 16-bit opacities",
    .rounding = "h to nearest, ties upwards; terms are cut",
    .saturation = "none",
    .fields = converted16_fields,
    .columns = VECTOR_COLUMNS(converted_row),
    .seed = 4116,
    .random_rows = 150,
    .edges = converted16_edges,
    .draw = converted16_draw,
    .compute = converted16_compute,
};

/* ---- Weights of a B-spline -------------------------------------------------- */

typedef struct bspline_row {
    uint64_t f[3], z[3], y[9], w[27];
} bspline_row;

static unsigned bspline_compute(void *columns)
{
    bspline_row *row = columns;
    qv_triple triple[3];
    fx_weight slice[3], line[3], voxel[3];
    for (unsigned axis = 0; axis < 3; axis++) {
        triple[axis].tap[0] = fx_tap_of_square(256u - (uint32_t)row->f[axis]);
        triple[axis].tap[1] = fx_tap_of_square((uint32_t)row->f[axis]);
    }
    qv_part_one(slice, &triple[2]);
    for (unsigned k = 0; k < 3; k++) {
        row->z[k] = fx_weight_bits(slice[k]);
        qv_part(line, slice[k], &triple[1]);
        for (unsigned j = 0; j < 3; j++) {
            row->y[3 * k + j] = fx_weight_bits(line[j]);
            qv_part(voxel, line[j], &triple[0]);
            for (unsigned i = 0; i < 3; i++)
                row->w[9 * k + 3 * j + i] = fx_weight_bits(voxel[i]);
        }
    }
    return (row->f[2] & 1u) != 0 ? VECTOR_TIE : 0;
}

static void bspline_draw(void *columns, vector_random *random)
{
    bspline_row *row = columns;
    for (unsigned axis = 0; axis < 3; axis++)
        row->f[axis] = vector_bits(random, 8);
}

static void bspline_edges(vector_set *set)
{
    static const uint8_t places[] = {0, 1, 127, 128, 255};
    for (unsigned i = 0; i < 125; i++) {
        const bspline_row row = {.f = {places[i % 5], places[i / 5 % 5], places[i / 25]}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field bspline_fields[] = {
    {"f", 3, 'i', "u8.8", "place in the voxel on axis [i]"},
    {"z0", 1, 'm', "u17.16", "floor((65536 (256 - f2)^2 + 2^16) / 2^17)"},
    {"z1", 1, 'm', "u17.16", "65536 - z0 - z2"},
    {"z2", 1, 'm', "u17.16", "floor((65536 f2^2 + 2^16) / 2^17)"},
    {"y", 9, 'm', "u17.16", "with [i] = v1 + 3 v2: part(z[v2], 1)[v1]"},
    {"w", 27, 'o', "u17.16", "with [i] = v0 + 3 v1 + 9 v2: part(y[v1 + 3 v2], 0)[v0]"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_bspline = {
    .name = "bspline",
    .section = "40",
    .title = "the 27 weights of a B-spline",
    .rounding = "outer parts to nearest, ties upwards; the middle one is the rest",
    .saturation = "none; the weights sum to 65536",
    .fields = bspline_fields,
    .columns = VECTOR_COLUMNS(bspline_row),
    .seed = 40,
    .random_rows = 150,
    .edges = bspline_edges,
    .draw = bspline_draw,
    .compute = bspline_compute,
};

/* ---- B-spline samples ------------------------------------------------------- */

typedef struct bspline_sample_row {
    uint64_t f[3], kind, channel[4][27], skipped, s, o, l[3];
} bspline_sample_row;

/* Of a volume of 3 * 3 * 3 voxels, at a place in the middle one. */
static unsigned bspline_sample_compute(void *columns)
{
    bspline_sample_row *row = columns;
    const unsigned storage = row->kind % 2 ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBA8;
    const int32_t bytes = (int32_t)qv_entry_bytes(storage);
    uint8_t narrow[27][4];
    uint16_t wide[27][4];
    qv_ray ray = {.first = 0};
    for (unsigned i = 0; i < 4 * 27; i++) {
        narrow[i % 27][i / 27] = (uint8_t)row->channel[i / 27][i % 27];
        wide[i % 27][i / 27] = (uint16_t)row->channel[i / 27][i % 27];
    }
    const qv_volume volume = {.voxels = row->kind % 2 ? (qv_address)wide : narrow[0],
                              .size = {3, 3, 3},
                              .stride = {bytes, 3 * bytes, 9 * bytes},
                              .storage = (uint8_t)storage};
    for (unsigned axis = 0; axis < 3; axis++)
        ray.place[axis] = (INT64_C(1) << 31) + (int64_t)(row->f[axis] << 24);
    qv_sample sample = {.scale = 0};
    row->skipped =
        !qv_bspline(&sample, &ray, &volume, storage, row->kind / 2 ? QV_BY_DENSITY : QV_BY_SHARE);
    if (row->skipped)
        return 0;
    row->s = sample.scale;
    row->o = fx_share_bits(sample.opacity);
    for (unsigned c = 0; c < 3; c++)
        row->l[c] = fx_sum_bits(sample.light[c]);
    return 0;
}

static void bspline_sample_draw(void *columns, vector_random *random)
{
    bspline_sample_row *row = columns;
    unsigned sparse = (unsigned)vector_bits(random, 1);
    row->kind = vector_bits(random, 2);
    for (unsigned axis = 0; axis < 3; axis++)
        row->f[axis] = vector_bits(random, 8);
    for (unsigned i = 0; i < 4 * 27; i++)
        row->channel[i / 27][i % 27] = vector_any(random, row->kind % 2 ? 16 : 8);
    for (unsigned v = 0; v < 27 && sparse; v++)
        row->channel[3][v] *= vector_bits(random, 1);
}

static void bspline_sample_edges(vector_set *set)
{
    for (unsigned i = 0; i < 16; i++) {
        bspline_sample_row row = {.kind = i % 4, .f = {i % 3 * 127, 255, i / 4}};
        uint64_t full = row.kind % 2 ? 65535 : 255;
        for (unsigned v = 0; v < 27; v++)
            for (unsigned c = 0; c < 4; c++)
                row.channel[c][v] = i / 4 == 0 ? full : i / 4 == 1 ? 0 : v == 13 || c < 3;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* One voxel with opacity among those that have none, each in turn. */
static void bspline_sample_added(vector_set *set)
{
    for (unsigned lone = 0; lone < 27; lone++) {
        bspline_sample_row row = {.kind = lone % 4, .f = {77, 128, 200}};
        for (unsigned v = 0; v < 27; v++)
            for (unsigned c = 0; c < 4; c++)
                row.channel[c][v] = c < 3 ? 255 - v : v == lone ? 200 : 0;
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field bspline_sample_fields[] = {
    {"f", 3, 'i', "u8.8", "place in the voxel on axis [i]"},
    {"kind", 1, 'i', "u2",
     "0 weighted of 8 bits, 1 of 16 bits; 2 and 3 the extinction of such opacities"},
    {"r", 27, 'i', "u16", "red of voxel [i] = v0 + 3 v1 + 9 v2"},
    {"g", 27, 'i', "u16", "green of voxel [i]"},
    {"b", 27, 'i', "u16", "blue of voxel [i]"},
    {"a", 27, 'i', "u16", "opacity of voxel [i], or extinction where kind < 2"},
    {"skipped", 1, 'o', "u1", "1 where all a are 0; the rest is then 0"},
    {"s", 1, 'o', "u5", "s of section 41, 0 where kind < 2"},
    {"o", 1, 'o', "u32", "O of sections 12 and 41, with the weights of the stage bspline"},
    {"l", 3, 'o', "u32", "L of sections 12 and 41, colour [i]"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_bspline_sample = {
    .name = "bspline_sample",
    .section = "40, 41",
    .title = "a sample of 27 voxels",
    .rounding = "terms of 16 bits are cut; those of extinction rounded before",
    .saturation = "none",
    .fields = bspline_sample_fields,
    .columns = VECTOR_COLUMNS(bspline_sample_row),
    .seed = 4027,
    .random_rows = 80,
    .edges = bspline_sample_edges,
    .added = bspline_sample_added,
    .draw = bspline_sample_draw,
    .compute = bspline_sample_compute,
};
