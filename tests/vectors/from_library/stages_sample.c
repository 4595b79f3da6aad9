/*
 * stages_sample.c - weights and samples: sections 11 to 13.
 */
#include "corners.h"
#include "stages.h"

#include <string.h>

/* ---- Weights ---------------------------------------------------------------- */

typedef struct weights_row {
    uint64_t f[3], xy, xz, yz, xyz, w[8];
} weights_row;

static unsigned weights_compute(void *columns)
{
    weights_row *row = columns;
    set_weights(row->w, row->f);
    row->xy = row->f[0] * row->f[1];
    row->xz = row->f[0] * row->f[2];
    row->yz = row->f[1] * row->f[2];
    row->xyz = row->w[7];
    return (row->xy * row->f[2] & 255u) == 128u ? VECTOR_TIE : 0;
}

static void weights_edges(vector_set *set)
{
    static const uint8_t places[] = {0, 1, 2, 127, 128, 129, 254, 255};
    enum { PLACES = sizeof places };
    for (unsigned i = 0; i < PLACES * PLACES * PLACES; i++) {
        const weights_row row = {
            .f = {places[i % PLACES], places[i / PLACES % PLACES], places[i / PLACES / PLACES]}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static void weights_draw(void *columns, vector_random *random)
{
    weights_row *row = columns;
    for (unsigned axis = 0; axis < 3; axis++)
        row->f[axis] = vector_bits(random, 8);
}

static const vector_field weights_fields[] = {
    FRACTIONS,
    {"xy", 1, 'm', "u16.16", "f0 * f1"},
    {"xz", 1, 'm', "u16.16", "f0 * f2"},
    {"yz", 1, 'm', "u16.16", "f1 * f2"},
    {"xyz", 1, 'm', "u16.16", "floor((xy * f2 + 128) / 256)"},
    {"w0", 1, 'o', "u17.16", "65536 + xy + xz + yz - 256 f0 - 256 f1 - 256 f2 - xyz"},
    {"w1", 1, 'o', "u17.16", "256 f0 + xyz - xy - xz"},
    {"w2", 1, 'o', "u17.16", "256 f1 + xyz - xy - yz"},
    {"w3", 1, 'o', "u17.16", "xy - xyz"},
    {"w4", 1, 'o', "u17.16", "256 f2 + xyz - xz - yz"},
    {"w5", 1, 'o', "u17.16", "xz - xyz"},
    {"w6", 1, 'o', "u17.16", "yz - xyz"},
    {"w7", 1, 'o', "u17.16", "xyz"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_weights = {
    .name = "weights",
    .section = "11",
    .title = "the eight weights of trilinear interpolation",
    .rounding = "xyz to nearest, ties upwards; the rest is exact",
    .saturation = "none; the weights sum to 65536",
    .fields = weights_fields,
    .columns = VECTOR_COLUMNS(weights_row),
    .seed = 11,
    .random_rows = 300,
    .edges = weights_edges,
    .draw = weights_draw,
    .compute = weights_compute,
};

#define SUM_OF(name)                                                                               \
    name "0 + " name "1 + " name "2 + " name "3 + " name "4 + " name "5 + " name "6 + " name "7"

#define SKIPPED                                                                                    \
    {                                                                                              \
        "skipped", 1, 'o', "u1", "1 where all a are 0; o, l and a32 are then 0"                    \
    }
#define A32_OF_8                                                                                   \
    {                                                                                              \
        "a32", 1, 'o', "u32.32", "257 o + floor(o / 256) + floor(o / 65536)"                       \
    }
#define A32_OF_16                                                                                  \
    {                                                                                              \
        "a32", 1, 'o', "u32.32", "o + floor(o / 65536)"                                            \
    }

/* ---- Weighted --------------------------------------------------------------- */

typedef struct weighted_row {
    uint64_t f[3], channel[4][8], w[8], s[8], term[3][8], skipped, o, l[3], a32;
} weighted_row;

static void find_terms(weighted_row *row, const corners *at, unsigned storage)
{
    set_weights(row->w, row->f);
    for (unsigned q = 0; q < 8; q++) {
        fx_weight weight = fx_weight_of((uint32_t)row->w[q]);
        fx_share share = qv_share(weight, at->at[q], 0, storage, QV_BY_SHARE);
        fx_sum term[3];
        qv_terms(term, weight, share, at->at[q], storage, QV_BY_SHARE);
        row->s[q] = fx_share_bits(share);
        for (unsigned c = 0; c < 3; c++)
            row->term[c][q] = fx_sum_bits(term[c]);
    }
}

/* Interpolates in a way of the library; returns whether there is something to see. */
static int interpolate(uint64_t *o, uint64_t l[3], uint64_t *a32, const corners *at,
                       const uint64_t f[3], unsigned storage, qv_factor factor)
{
    const fx_fraction fraction[3] = {fx_fraction_of((uint32_t)f[0]), fx_fraction_of((uint32_t)f[1]),
                                     fx_fraction_of((uint32_t)f[2])};
    qv_sample sample;
    if (!qv_interpolate_corners(&sample, at->at, fraction, storage, factor))
        return 0;
    if (sample.scale != 0)
        vector_fail("sample", "scale", "is that of converted opacity");
    if (factor == QV_BY_WEIGHT)
        qv_associate_light(&sample, storage);
    *o = fx_share_bits(sample.opacity);
    *a32 = qv_opacity_q32(sample.opacity, storage);
    for (unsigned c = 0; c < 3; c++)
        l[c] = fx_sum_bits(sample.light[c]);
    return 1;
}

static unsigned weighted_compute(weighted_row *row, unsigned storage)
{
    corners at;
    set_corners(&at, row->channel, storage);
    find_terms(row, &at, storage);
    row->skipped = !interpolate(&row->o, row->l, &row->a32, &at, row->f, storage, QV_BY_SHARE);
    return row->a32 == UINT32_MAX ? VECTOR_OVERFLOW : 0;
}

static unsigned sample8_compute(void *row)
{
    return weighted_compute(row, QV_STORAGE_RGBA8);
}

static unsigned sample16_compute(void *row)
{
    return weighted_compute(row, QV_STORAGE_RGBA16);
}

static void sample8_draw(void *columns, vector_random *random)
{
    weighted_row *row = columns;
    draw_corners(row->f, row->channel, random, 8);
}

static void sample16_draw(void *columns, vector_random *random)
{
    weighted_row *row = columns;
    draw_corners(row->f, row->channel, random, 16);
}

static void add_weighted(vector_set *set, const uint64_t f[3], uint64_t channel[4][8])
{
    weighted_row row = {.f = {f[0], f[1], f[2]}};
    memcpy(row.channel, channel, sizeof row.channel);
    vector_add(set, &row, VECTOR_EDGE);
}

static void sample8_edges(vector_set *set)
{
    corner_edges(set, 8, add_weighted);
}

static void sample16_edges(vector_set *set)
{
    corner_edges(set, 16, add_weighted);
}

static void sample8_added(vector_set *set)
{
    lone_corners(set, 8, add_weighted);
}

static void sample16_added(vector_set *set)
{
    lone_corners(set, 16, add_weighted);
}

#define WEIGHTED_SUMS                                                                              \
    SKIPPED, {"o", 1, 'o', "u32", SUM_OF("s")}, {"l0", 1, 'o', "u32", SUM_OF("tr")},               \
        {"l1", 1, 'o', "u32", SUM_OF("tg")},                                                       \
    {                                                                                              \
        "l2", 1, 'o', "u32", SUM_OF("tb")                                                          \
    }

static const vector_field sample8_fields[] = {FRACTIONS,
                                              ENTRIES("unorm8"),
                                              CORNER_WEIGHTS,
                                              {"s", 8, 'm', "u32", "w[i] * a[i]"},
                                              {"tr", 8, 'm', "u32", "s[i] * r[i]"},
                                              {"tg", 8, 'm', "u32", "s[i] * g[i]"},
                                              {"tb", 8, 'm', "u32", "s[i] * b[i]"},
                                              WEIGHTED_SUMS,
                                              A32_OF_8,
                                              {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_sample8 = {
    .name = "sample8",
    .section = "12, 13",
    .title = "opacity-weighted sample of 8-bit storage",
    .rounding = "xyz to nearest, ties upwards; sums are exact; a32 is cut",
    .saturation = "none; o is at most 65536 * 255",
    .fields = sample8_fields,
    .columns = VECTOR_COLUMNS(weighted_row),
    .seed = 12,
    .random_rows = 200,
    .edges = sample8_edges,
    .added = sample8_added,
    .draw = sample8_draw,
    .compute = sample8_compute,
};

static const vector_field sample16_fields[] = {FRACTIONS,
                                               ENTRIES("unorm16"),
                                               CORNER_WEIGHTS,
                                               {"s", 8, 'm', "u32", "w[i] * a[i]"},
                                               {"tr", 8, 'm', "u32", "floor(s[i] * r[i] / 65536)"},
                                               {"tg", 8, 'm', "u32", "floor(s[i] * g[i] / 65536)"},
                                               {"tb", 8, 'm', "u32", "floor(s[i] * b[i] / 65536)"},
                                               WEIGHTED_SUMS,
                                               A32_OF_16,
                                               {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_sample16 = {
    .name = "sample16",
    .section = "12, 13",
    .title = "opacity-weighted sample of 16-bit storage",
    .rounding = "xyz to nearest, ties upwards; each term and a32 are cut",
    .saturation = "none; o is at most 65536 * 65535",
    .fields = sample16_fields,
    .columns = VECTOR_COLUMNS(weighted_row),
    .seed = 1216,
    .random_rows = 200,
    .edges = sample16_edges,
    .added = sample16_added,
    .draw = sample16_draw,
    .compute = sample16_compute,
};

/* ---- Separate --------------------------------------------------------------- */

typedef struct separate_row {
    uint64_t f[3], channel[4][8], w[8], d[3], skipped, o, l[3], a32;
} separate_row;

static unsigned separate_compute(separate_row *row, unsigned storage)
{
    corners at;
    set_corners(&at, row->channel, storage);
    set_weights(row->w, row->f);
    for (unsigned c = 0; c < 3; c++)
        for (unsigned q = 0; q < 8; q++)
            row->d[c] += row->w[q] * row->channel[c][q];
    row->skipped = !interpolate(&row->o, row->l, &row->a32, &at, row->f, storage, QV_BY_WEIGHT);
    return row->a32 == UINT32_MAX ? VECTOR_OVERFLOW : 0;
}

static unsigned separate8_compute(void *row)
{
    return separate_compute(row, QV_STORAGE_RGBA8);
}

static unsigned separate16_compute(void *row)
{
    return separate_compute(row, QV_STORAGE_RGBA16);
}

static void separate8_draw(void *columns, vector_random *random)
{
    separate_row *row = columns;
    draw_corners(row->f, row->channel, random, 8);
}

static void separate16_draw(void *columns, vector_random *random)
{
    separate_row *row = columns;
    draw_corners(row->f, row->channel, random, 16);
}

static void add_separate(vector_set *set, const uint64_t f[3], uint64_t channel[4][8])
{
    separate_row row = {.f = {f[0], f[1], f[2]}};
    memcpy(row.channel, channel, sizeof row.channel);
    vector_add(set, &row, VECTOR_EDGE);
}

static void separate8_edges(vector_set *set)
{
    corner_edges(set, 8, add_separate);
}

static void separate16_edges(vector_set *set)
{
    corner_edges(set, 16, add_separate);
}

static void separate8_added(vector_set *set)
{
    lone_corners(set, 8, add_separate);
}

static void separate16_added(vector_set *set)
{
    lone_corners(set, 16, add_separate);
}

#define DOT_OF(name)                                                                               \
    "w0 * " name "0 + w1 * " name "1 + w2 * " name "2 + w3 * " name "3 + w4 * " name               \
    "4 + w5 * " name "5 + w6 * " name "6 + w7 * " name "7"

#define SEPARATE_SUMS                                                                              \
    CORNER_WEIGHTS, {"d0", 1, 'm', "u32", DOT_OF("r")}, {"d1", 1, 'm', "u32", DOT_OF("g")},        \
        {"d2", 1, 'm', "u32", DOT_OF("b")}, SKIPPED,                                               \
    {                                                                                              \
        "o", 1, 'o', "u32", DOT_OF("a")                                                            \
    }

static const vector_field separate8_fields[] = {
    FRACTIONS, ENTRIES("unorm8"),       SEPARATE_SUMS, {"l", 3, 'o', "u32", "hi(256 d[i], 256 o)"},
    A32_OF_8,  {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_separate8 = {
    .name = "separate8",
    .section = "12, 13",
    .title = "colour and opacity of 8-bit storage interpolated apart",
    .rounding = "xyz and l to nearest, ties upwards; a32 is cut",
    .saturation = "none",
    .fields = separate8_fields,
    .columns = VECTOR_COLUMNS(separate_row),
    .seed = 1208,
    .random_rows = 120,
    .edges = separate8_edges,
    .added = separate8_added,
    .draw = separate8_draw,
    .compute = separate8_compute,
};

static const vector_field separate16_fields[] = {FRACTIONS,     ENTRIES("unorm16"),
                                                 SEPARATE_SUMS, {"l", 3, 'o', "u32", "hi(d[i], o)"},
                                                 A32_OF_16,     {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_separate16 = {
    .name = "separate16",
    .section = "12, 13",
    .title = "colour and opacity of 16-bit storage interpolated apart",
    .rounding = "xyz and l to nearest, ties upwards; a32 is cut",
    .saturation = "none",
    .fields = separate16_fields,
    .columns = VECTOR_COLUMNS(separate_row),
    .seed = 1217,
    .random_rows = 120,
    .edges = separate16_edges,
    .added = separate16_added,
    .draw = separate16_draw,
    .compute = separate16_compute,
};
