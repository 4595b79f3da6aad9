/*
 * stages_dither.c - dither values and alpha dithering: sections 45, 46, 51 and 57.
 */
#include "stages.h"

#include "blend.h"
#include "fx_alpha.h"
#include "fx_dither.h"

/* ---- Dither values ---------------------------------------------------------- */

typedef struct dither_row {
    uint64_t n, u, x, y, frame, hash, golden, hashed, blocks, at;
} dither_row;

static unsigned dither_compute(void *columns)
{
    dither_row *row = columns;
    row->hash = fx_hash((uint32_t)row->n);
    row->golden = fx_dither_golden((uint32_t)row->n);
    row->hashed = fx_dither_hash((uint32_t)row->n);
    row->blocks = fx_dither_blocks((uint32_t)row->n);
    row->at =
        fx_dither_at((uint32_t)row->u, (uint32_t)row->x, (uint32_t)row->y, (uint32_t)row->frame);
    return 0;
}

static void dither_draw(void *columns, vector_random *random)
{
    dither_row *row = columns;
    row->n = vector_bits(random, 1) ? vector_bits(random, 23) : vector_any(random, 32);
    row->u = vector_any(random, 32);
    row->x = vector_any(random, 32);
    row->y = vector_any(random, 32);
    row->frame = vector_any(random, 32);
}

static void dither_edges(vector_set *set)
{
    for (uint64_t i = 0; i < 40; i++) {
        const dither_row row = {.n = i < 20 ? i : UINT32_MAX - (i - 20) * 37,
                                .x = i == 1,
                                .y = i == 2,
                                .frame = i == 3};
        vector_add(set, &row, VECTOR_EDGE);
    }
    for (unsigned bit = 5; bit < 32; bit++) {
        const dither_row row = {.n = (uint64_t)1 << bit, .x = (uint64_t)1 << bit};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field dither_fields[] = {
    {"n", 1, 'i', "u32", "number of the slice"},
    {"u", 1, 'i', "u32.32", "a dither value"},
    {"x", 1, 'i', "u32", "column of the pixel"},
    {"y", 1, 'i', "u32", "line of the pixel"},
    {"frame", 1, 'i', "u32", "number of the frame"},
    {"hash", 1, 'm', "u32", "hash(n) of section 45"},
    {"golden", 1, 'o', "u32.32", "(2654435769 n) mod 2^32"},
    {"hashed", 1, 'o', "u32.32", "hash((2 n + 1) mod 2^32)"},
    {"blocks", 1, 'o', "u32.32", "blocks(n) of section 45"},
    {"at", 1, 'o', "u32.32", "(u + 3242174889 x + 2447445414 y + 2654435769 frame) mod 2^32"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_dither = {
    .name = "dither",
    .section = "45",
    .title = "dither values of slices, pixels and frames",
    .rounding = "none: exact",
    .saturation = "none: modulo 2^32",
    .fields = dither_fields,
    .columns = VECTOR_COLUMNS(dither_row),
    .seed = 45,
    .random_rows = 250,
    .edges = dither_edges,
    .draw = dither_draw,
    .compute = dither_compute,
};

/* ---- Hits of a period ------------------------------------------------------- */

typedef struct hits_row {
    uint64_t period, o, base, bump, n, u, hits, k, ordered, random;
} hits_row;

static unsigned hits_compute(void *columns)
{
    hits_row *row = columns;
    const fx_period period = fx_period_of((uint32_t)row->period);
    const uint32_t hits =
        fx_hits(&period, (uint32_t)row->o, (uint32_t)row->base, (uint32_t)row->bump);
    row->hits = hits;
    row->k = fx_phase(&period, (uint32_t)row->n);
    row->ordered = fx_hit_ordered(&period, hits, (uint32_t)row->k);
    row->random = fx_hit_random(&period, hits, (uint32_t)row->u);
    return hits == row->period ? VECTOR_SATURATE : 0;
}

static void hits_draw(void *columns, vector_random *random)
{
    hits_row *row = columns;
    row->period = (uint64_t)vector_between(random, 2, 64);
    row->o = vector_any(random, 24) % 16711681u;
    row->base = row->o >> 16;
    if (vector_bits(random, 2) == 0)
        row->base = (uint64_t)vector_between(random, 0, (int64_t)row->base);
    row->bump = ((uint64_t)2 << vector_between(random, 0, 7)) - 1u;
    row->n = vector_any(random, 32);
    row->u = vector_any(random, 32);
}

/* Opacities at which hits step by a tie, and each phase of short periods. */
static void hits_edges(vector_set *set)
{
    for (uint64_t period = 2; period < 65; period++) {
        const uint64_t half = (65536 + period) / (2 * period); /* about 1/2 hit */
        const hits_row row = {.period = period,
                              .o = 65536 * 3 + half - 1 + period % 3,
                              .base = 3,
                              .bump = 1,
                              .n = period - 1,
                              .u = 0xFFFFFFFF / period};
        vector_add(set, &row, VECTOR_EDGE);
    }
    for (uint64_t n = 0; n < 32; n++) {
        const hits_row row = {
            .period = 16, .o = 150733, .base = 2, .bump = 1, .n = n, .u = n << 27};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field hits_fields[] = {
    {"period", 1, 'i', "u7", "P, 2 .. 64 slices"},
    {"o", 1, 'i', "u32.16", "opacity, levels, at most 16711680"},
    {"base", 1, 'i', "u8", "at most floor(o / 65536)"},
    {"bump", 1, 'i', "u8", "not 0"},
    {"n", 1, 'i', "u32", "number of the slice"},
    {"u", 1, 'i', "u32.32", "its dither value"},
    {"hits", 1, 'm', "u7",
     "min(period, floor((2 period (o - 65536 base) + 65536 bump) / (131072 bump)))"},
    {"k", 1, 'm', "u6", "n mod period"},
    {"ordered", 1, 'o', "u1", "1 where floor((k + 1) hits / period) > floor(k hits / period)"},
    {"random", 1, 'o', "u1", "1 where floor(floor(u / 65536) period / 65536) < hits"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_hits = {
    .name = "hits",
    .section = "46",
    .title = "which slices of a period have the higher opacity",
    .rounding = "hits to nearest, ties upwards",
    .saturation = "hits at the period",
    .fields = hits_fields,
    .columns = VECTOR_COLUMNS(hits_row),
    .seed = 46,
    .random_rows = 300,
    .edges = hits_edges,
    .draw = hits_draw,
    .compute = hits_compute,
};

/* ---- Plateaus and bumps ----------------------------------------------------- */

typedef struct plateau_row {
    uint64_t bits, o, v, base, plateau, over, bump;
} plateau_row;

static unsigned plateau_compute(void *columns)
{
    plateau_row *row = columns;
    const uint32_t full = ((uint32_t)1 << row->bits) - 1u;
    row->plateau = fx_plateau((uint32_t)row->o, full);
    row->over = fx_overcoming((uint32_t)row->v, full);
    row->bump = fx_bump((uint32_t)row->v & 255u, (uint32_t)row->base);
    return 0;
}

static void plateau_draw(void *columns, vector_random *random)
{
    plateau_row *row = columns;
    row->bits = (uint64_t)vector_between(random, 5, 16);
    row->o = vector_any(random, (unsigned)row->bits);
    row->v = vector_any(random, (unsigned)row->bits);
    row->base = vector_any(random, 8);
}

static void plateau_edges(vector_set *set)
{
    for (uint64_t v = 0; v < 256; v++) {
        const plateau_row row = {.bits = 8, .o = v, .v = v, .base = v % 5 ? 0 : 255 - v / 5};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field plateau_fields[] = {
    {"bits", 1, 'i', "u5", "n, 5 .. 16; F is 2^n - 1"},
    {"o", 1, 'i', "u16", "opacity of n bits"},
    {"v", 1, 'i', "u16", "value of n bits; of bump its lowest 8 bits"},
    {"base", 1, 'i', "u8", "of bump"},
    {"plateau", 1, 'o', "u16", "plateau(o) of section 46"},
    {"over", 1, 'o', "u17", "over(v)"},
    {"bump", 1, 'o', "u8", "bump(v mod 256, base)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_plateau = {
    .name = "plateau",
    .section = "46",
    .title = "where a rounded blend stops, and what goes on",
    .rounding = "quotients are cut",
    .saturation = "bump at 255 - base",
    .fields = plateau_fields,
    .columns = VECTOR_COLUMNS(plateau_row),
    .seed = 4610,
    .random_rows = 200,
    .edges = plateau_edges,
    .draw = plateau_draw,
    .compute = plateau_compute,
};

/* ---- Opacities for blends of 8 bits ----------------------------------------- */

typedef struct alpha_row {
    uint64_t o, period, slope[2], cutoff, k, u, v, colour;
    uint64_t rounded, ordered, random, bumped, bumped_random, corrected;
} alpha_row;

static unsigned alpha_compute(void *columns)
{
    alpha_row *row = columns;
    const uint32_t o = (uint32_t)row->o, k = (uint32_t)row->k, u = (uint32_t)row->u;
    const uint32_t v = (uint32_t)row->v;
    const fx_alpha of = {fx_period_of((uint32_t)row->period),
                         {(uint32_t)row->slope[0], (uint32_t)row->slope[1]},
                         (uint32_t)row->cutoff};
    row->rounded = fx_alpha_rounded(o);
    row->ordered = fx_alpha_ordered(&of, o, k);
    row->random = fx_alpha_random(&of, o, u);
    row->bumped = fx_alpha_bumped(&of, o, k, v);
    row->bumped_random = fx_alpha_bumped_random(&of, o, u, v);
    row->corrected = fx_alpha_corrected(o, (uint32_t)row->colour, v, u);
    return row->o >> 16 > row->cutoff ? VECTOR_SATURATE : 0;
}

static void alpha_draw(void *columns, vector_random *random)
{
    static const uint32_t slopes[] = {65536, 49152, 32768, 98304, 1048576};
    alpha_row *row = columns;
    row->o = vector_bits(random, 1) ? vector_bits(random, 20) : vector_any(random, 24) % 16711681u;
    row->period = (uint64_t)vector_between(random, 2, 64);
    row->slope[0] = slopes[vector_between(random, 0, 4)];
    row->slope[1] = slopes[vector_between(random, 0, 4)];
    row->cutoff = vector_bits(random, 1) ? 255 : vector_any(random, 8);
    row->k = (uint64_t)vector_between(random, 0, (int64_t)row->period - 1);
    row->u = vector_bits(random, 32);
    row->v = vector_any(random, 8);
    row->colour = vector_any(random, 8);
}

/* S75 and S76. */
static void alpha_edges(vector_set *set)
{
    static const uint64_t values[] = {0, 127, 128, 213, 250, 255};
    static const uint64_t opacities[] = {0,      32767,  32768,  65536,   150733,
                                         163840, 226608, 236608, 16711680};
    for (unsigned i = 0; i < 6 * 9 * 3; i++) {
        const alpha_row row = {.o = opacities[i / 6 % 9],
                               .period = i / 54 ? 16 : 32,
                               .slope = {i / 54 ? 65536 : 49152, 65536},
                               .cutoff = i / 108 ? 3 : 255,
                               .k = i % 16,
                               .u = (uint64_t)(i % 128) << 25,
                               .v = values[i % 6],
                               .colour = i % 2 ? 255 : 100};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Fractions that are a 65536th of a hit below one half, of odd periods; each slice of a period. */
static void add_near_hits(vector_set *set)
{
    static const uint64_t near[][2] = {{3, 54613}, {5, 45875}, {7, 4681}};
    for (unsigned i = 0; i < 3; i++)
        for (uint64_t k = 0; k < near[i][0]; k++) {
            const alpha_row row = {.o = (3 << 16) + near[i][1],
                                   .period = near[i][0],
                                   .slope = {65536, 65536},
                                   .cutoff = 255,
                                   .k = k,
                                   .u = (k << 32) / near[i][0] + 65536};
            vector_add(set, &row, VECTOR_EDGE);
        }
}

/* Found by search: here corrected changes with a bound that is off by 1. */
static void alpha_added(vector_set *set)
{
    static const alpha_row rows[] = {{.o = 831295, .v = 210, .colour = 161, .u = 531830313},
                                     {.o = 937379, .v = 75, .colour = 248, .u = 3554610623},
                                     {.o = 828484, .v = 20, .colour = 12, .u = 179229414},
                                     {.o = 887328, .v = 134, .colour = 52, .u = 3993653783},
                                     {.o = 12379943, .v = 140, .colour = 139, .u = 3883510685}};
    for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        alpha_row row = rows[i];
        row.period = 2 + i;
        row.slope[0] = row.slope[1] = 65536;
        row.cutoff = 255;
        vector_add(set, &row, VECTOR_EDGE);
    }
    add_near_hits(set);
}

static const vector_field alpha_fields[] = {
    {"o", 1, 'i', "u32.16", "opacity, levels, at most 16711680"},
    {"period", 1, 'i', "u7", "P, 2 .. 64"},
    {"slope", 2, 'i', "u24.16", "s[i], at most 2^20"},
    {"cutoff", 1, 'i', "u8", "level"},
    {"k", 1, 'i', "u6", "phase of the slice, below the period"},
    {"u", 1, 'i', "u32.32", "its dither value"},
    {"v", 1, 'i', "u8", "value that the pixel holds"},
    {"colour", 1, 'i', "u8", "c, of corrected"},
    {"rounded", 1, 'o', "u8", "floor((o + 32768) / 65536)"},
    {"ordered", 1, 'o', "u8", "simple, in order"},
    {"random", 1, 'o', "u8", "simple, at random"},
    {"bumped", 1, 'o', "u8", "bumped, in order"},
    {"bumped_random", 1, 'o', "u8", "bumped, at random"},
    {"corrected", 1, 'o', "u8", "corrected"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_alpha = {
    .name = "alpha",
    .section = "51",
    .title = "opacities for blends of 8 bits, by each technique",
    .rounding = "to nearest, ties upwards",
    .saturation = "w at 255 * 65536",
    .fields = alpha_fields,
    .columns = VECTOR_COLUMNS(alpha_row),
    .seed = 51,
    .random_rows = 400,
    .edges = alpha_edges,
    .added = alpha_added,
    .draw = alpha_draw,
    .compute = alpha_compute,
};

/* ---- Dither of a slice ------------------------------------------------------ */

typedef struct slice_row {
    int64_t slice;
    uint64_t backwards, period, frame, still, sequence;
    int64_t x, y;
    uint64_t u, phase;
} slice_row;

static qv_sequence *const sequences[4] = {qv_sequence_rounded, qv_sequence_golden, qv_sequence_hash,
                                          qv_sequence_blocks};

static unsigned slice_compute(void *columns)
{
    slice_row *row = columns;
    const qv_dither dither = {.sequence = sequences[row->sequence],
                              .technique = row->backwards ? &qv_technique_bumped : 0,
                              .frame = (uint32_t)row->frame,
                              .period = (uint8_t)row->period,
                              .still = (uint8_t)row->still};
    const qv_blend *blend = row->backwards ? &qv_hardware_rgb888 : &qv_under_rgb888;
    qv_moment moment;
    if (qv_moment_of(&moment, &dither, blend, (int32_t)row->slice) != QV_OK)
        vector_fail("slice_dither", "dither", "refused");
    const uint32_t shift = qv_dither_shift(moment.spread, (int32_t)row->x, (int32_t)row->y);
    qv_moment_at(&moment, moment.slice_u + shift);
    row->u = moment.u;
    row->phase = row->backwards ? moment.phase : 0;
    return 0;
}

static void slice_draw(void *columns, vector_random *random)
{
    slice_row *row = columns;
    row->slice = vector_between(random, -4194304, 4194303);
    row->backwards = vector_bits(random, 1);
    row->period = (uint64_t)vector_between(random, 2, 64);
    row->frame = vector_any(random, 32);
    row->still = vector_bits(random, 2) == 0;
    row->sequence = vector_bits(random, 2);
    row->x = vector_between(random, -32767, 32766);
    row->y = vector_between(random, -32767, 32766);
}

static void slice_edges(vector_set *set)
{
    for (unsigned i = 0; i < 32; i++) {
        const slice_row row = {.slice = i % 4 == 0   ? -4194304
                                        : i % 4 == 1 ? 4194303
                                                     : (int)i - 9,
                               .backwards = i / 4 % 2,
                               .period = 2 + i,
                               .frame = i / 8 % 2 ? UINT32_MAX : 0,
                               .still = i / 16,
                               .sequence = i % 4,
                               .x = -1,
                               .y = 7};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field slice_fields[] = {
    {"slice", 1, 'i', "s23", "k"},
    {"backwards", 1, 'i', "u1", "1 for hardware_rgb888, bumped; 0 for under_rgb888"},
    {"period", 1, 'i', "u7", "P, 2 .. 64"},
    {"frame", 1, 'i', "u32", "f"},
    {"still", 1, 'i', "u1", "1 where pixels are still"},
    {"sequence", 1, 'i', "u2", "0 rounded, 1 golden, 2 hashed, 3 blocks"},
    {"x", 1, 'i', "s16", "absolute column"},
    {"y", 1, 'i', "s16", "absolute line"},
    {"u", 1, 'o', "u32.32", "u of section 57"},
    {"phase", 1, 'o', "u6", "its phase; 0 where backwards = 0"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_slice_dither = {
    .name = "slice_dither",
    .section = "57",
    .title = "the dither of a slice in a pixel",
    .rounding = "none: exact",
    .saturation = "none: modulo 2^32",
    .fields = slice_fields,
    .columns = VECTOR_COLUMNS(slice_row),
    .seed = 57,
    .random_rows = 200,
    .edges = slice_edges,
    .draw = slice_draw,
    .compute = slice_compute,
};
