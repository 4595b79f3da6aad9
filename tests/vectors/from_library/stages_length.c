/*
 * stages_length.c - samples weighted by length: sections 42 to 44.
 */
#include "stages.h"

#include "correct.h"
#include "march_levels.h"

/* ---- Corrected opacity ------------------------------------------------------ */

typedef struct corrected_row {
    uint64_t wide, o, l[3], depth, light, b;
    uint64_t a32, stored, new_depth, x, factor, la[3], a32a;
} corrected_row;

static unsigned storage_of(uint64_t wide)
{
    return wide ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBA8;
}

static qv_medium medium_of(uint64_t depth, uint64_t light, uint64_t b)
{
    const qv_medium medium = {depth, (uint32_t)light, (uint32_t)b};
    return medium;
}

static qv_sample sample_of(uint64_t o, const uint64_t l[3], uint64_t s)
{
    const qv_sample sample = {
        .light = {fx_sum_of((uint32_t)l[0]), fx_sum_of((uint32_t)l[1]), fx_sum_of((uint32_t)l[2])},
        .opacity = fx_share_of((uint32_t)o),
        .scale = (unsigned)s};
    return sample;
}

static unsigned corrected_compute(void *columns)
{
    corrected_row *row = columns;
    const unsigned storage = storage_of(row->wide);
    const qv_medium medium = medium_of(row->depth, row->light, row->b);
    const qv_sample sample = sample_of(row->o, row->l, 0);
    uint32_t colour[3];
    row->a32a = qv_correct(colour, &sample, &medium, storage);
    for (unsigned c = 0; c < 3; c++)
        row->la[c] = colour[c];
    row->a32 = qv_opacity_q32(sample.opacity, storage);
    row->stored = fx_depth_of_opacity((uint32_t)row->a32);
    row->new_depth = fx_depth_times(row->stored, row->depth);
    row->x = fx_opacity(row->new_depth);
    row->factor = qv_correction(row->stored, row->new_depth, &medium);
    return row->stored >> 32 >= 23 ? VECTOR_SATURATE : 0;
}

static void draw_sample(uint64_t *o, uint64_t l[3], vector_random *random, uint64_t wide)
{
    uint64_t full = wide ? 65535 : 255;
    *o = vector_any(random, 32) % (65536u * full + 1u);
    for (unsigned c = 0; c < 3; c++) {
        uint64_t colour = vector_any(random, wide ? 16 : 8);
        l[c] = wide ? *o * colour >> 16 : *o * colour;
    }
}

/* The medium of a ratio of length to unit distance below 2^11. */
static void set_ratio(corrected_row *row, uint64_t ratio)
{
    row->depth = ratio;
    row->b = 1;
    while (ratio >> row->b >> 32 != 0)
        row->b++;
    row->light = ratio >> row->b;
}

static void corrected_draw(void *columns, vector_random *random)
{
    corrected_row *row = columns;
    row->wide = vector_bits(random, 1);
    draw_sample(&row->o, row->l, random, row->wide);
    set_ratio(row,
              vector_bits(random, 2) ? vector_any(random, 33) + 1u : vector_bits(random, 42) + 1u);
}

static void corrected_edges(vector_set *set)
{
    static const uint64_t ratios[] = {1,           0x80000000,  0xFFFFFFFF,       0x100000000,
                                      0x100000001, 0x180000000, (uint64_t)1 << 43};
    static const uint64_t parts[] = {0, 1, 2, 127, 254, 255};
    for (unsigned i = 0; i < 2 * 42; i++) {
        corrected_row row = {.wide = i / 42};
        uint64_t full = row.wide ? 65535 : 255;
        row.o = 65536 * full / 255 * parts[i % 6];
        for (unsigned c = 0; c < 3; c++)
            row.l[c] = row.wide ? row.o * (c * 32767) >> 16 : row.o * (c * 127);
        set_ratio(&row, ratios[i / 6 % 7]);
        vector_add(set, &row, VECTOR_EDGE);
    }
    for (uint64_t near = 0; near < 600; near += 40) { /* depths next to 23 */
        corrected_row row = {.wide = 1, .o = 4294901760u - near, .l = {4294901760u - near, 1, 0}};
        set_ratio(&row, 0x30000000);
        vector_add(set, &row, VECTOR_EDGE);
    }
}

#define SAMPLE_FIELDS                                                                              \
    {"o", 1, 'i', "u32", "O of the sample"},                                                       \
    {                                                                                              \
        "l", 3, 'i', "u32", "L of the sample, colour [i]"                                          \
    }
#define PIECE_FIELDS                                                                               \
    {"depth", 1, 'i', "u64.32", "depth of the piece, section 39"},                                 \
        {"light", 1, 'i', "u32", "light of the piece, 32 - b fraction bits"},                      \
    {                                                                                              \
        "b", 1, 'i', "u5", "b of the medium"                                                       \
    }

static const vector_field corrected_fields[] = {
    {"wide", 1, 'i', "u1", "storage: 0 of 8 bits, 1 of 16 bits"},
    SAMPLE_FIELDS,
    PIECE_FIELDS,
    {"a32", 1, 'm', "u32.32", "a32 of section 13"},
    {"stored", 1, 'm', "u64.32", "D(2^32 - 1 - a32)"},
    {"new_depth", 1, 'm', "u64.32", "floor(stored * depth / 2^32)"},
    {"x", 1, 'm', "u32.31", "2^31 - T(new_depth)"},
    {"factor", 1, 'm', "u32",
     "floor(hi(2 recip(phi(stored)), phi(new_depth)) * light / 2^27), but floor(x / 2^(b-1)) where "
     "stored >= 23 * 2^32"},
    {"la", 3, 'o', "u32", "floor(l[i] * factor / 2^(32-b)), l[i] where depth = 2^32"},
    {"a32a", 1, 'o', "u32.32", "2 x - floor(x / 2^31), a32 where depth = 2^32"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_corrected = {
    .name = "corrected",
    .section = "42",
    .title = "a sample's opacity and light for a length",
    .rounding = "hi to nearest, ties upwards; all else is cut",
    .saturation = "phi's share from a depth of 23 on",
    .fields = corrected_fields,
    .columns = VECTOR_COLUMNS(corrected_row),
    .seed = 42,
    .random_rows = 400,
    .edges = corrected_edges,
    .draw = corrected_draw,
    .compute = corrected_compute,
};

/* ---- Extinction ------------------------------------------------------------- */

typedef struct extinction_inputs {
    uint64_t o, l[3], s, depth, light, b;
} extinction_inputs;

typedef struct extinction_under_row {
    extinction_inputs in;
    uint64_t x, t, g[3], d, phi, factor, xn, tn, gn[3], en[3];
} extinction_under_row;

static unsigned extinction_under_compute(void *columns)
{
    extinction_under_row *row = columns;
    const qv_medium medium = medium_of(row->in.depth, row->in.light, row->in.b);
    const qv_sample sample = sample_of(row->in.o, row->in.l, row->in.s);
    qv_light light = {{0, 0, 0}, (uint32_t)row->t, 0, 0};
    qv_gathered gathered = {{row->g[0], row->g[1], row->g[2]}, row->x};
    row->d = qv_sample_depth(&sample, &medium);
    row->phi = fx_phi(row->d);
    row->factor = qv_light_factor((uint32_t)row->t, row->d, &medium);
    qv_extinction_under(&light, &gathered, &sample, &medium, QV_STORAGE_RGBT8);
    qv_gathered_light(&light, &gathered, &medium);
    row->xn = gathered.depth;
    row->tn = light.transmittance;
    for (unsigned c = 0; c < 3; c++) {
        row->gn[c] = gathered.light[c];
        row->en[c] = light.colour[c];
    }
    return row->tn == 0 ? VECTOR_SATURATE : 0;
}

/* A medium whose full value has a depth below 2^20 for the piece; s only with stored opacity. */
static void draw_medium(extinction_inputs *in, vector_random *random)
{
    in->s = vector_bits(random, 1) ? (uint64_t)vector_between(random, 0, 21) : 0;
    in->o = in->s ? vector_bits(random, 31) : vector_any(random, 32) % 4294901761u;
    for (unsigned c = 0; c < 3; c++)
        in->l[c] = in->o * vector_any(random, 16) >> 16;
    in->depth = vector_bits(random, 1) ? vector_bits(random, 34) : vector_any(random, 52);
    in->depth += 1u;
    uint64_t light = in->depth / 3 * 2; /* about ln 2 of it */
    in->b = 1;
    while (light >> in->b >> 32 != 0)
        in->b++;
    in->light = light >> in->b;
}

static void draw_gathered(extinction_under_row *row, vector_random *random)
{
    row->x = vector_bits(random, 1) ? vector_bits(random, 34) : vector_bits(random, 36);
    row->t = fx_transmittance(row->x);
    for (unsigned c = 0; c < 3; c++)
        row->g[c] = (0x80000000u - row->t) * vector_any(random, 16) >> 16 << (32u - row->in.b);
}

static void extinction_under_draw(void *columns, vector_random *random)
{
    extinction_under_row *row = columns;
    draw_medium(&row->in, random);
    draw_gathered(row, random);
}

/* Nothing, all and half of the full value, of thin media and dense ones. */
static extinction_inputs edge_medium(unsigned number)
{
    static const uint64_t sums[] = {0, 1, 0x80000000, 4294901760u};
    static const uint64_t depths[] = {1, 0x100000000, 0x16B1B1B1B19, (uint64_t)1 << 50};
    extinction_inputs in = {.o = sums[number % 4], .depth = depths[number / 4 % 4]};
    for (unsigned c = 0; c < 3; c++)
        in.l[c] = in.o >> c;
    in.s = number / 16 % 2 * 21;
    in.o = in.s ? in.o / 2 : in.o;
    uint64_t light = in.depth / 3 * 2;
    for (in.b = 1; light >> in.b >> 32 != 0;)
        in.b++;
    in.light = light >> in.b;
    return in;
}

static void extinction_under_edges(vector_set *set)
{
    for (unsigned i = 0; i < 64; i++) {
        extinction_under_row row = {.in = edge_medium(i), .x = i / 32 ? (uint64_t)31 << 32 : 0};
        row.t = fx_transmittance(row.x);
        vector_add(set, &row, VECTOR_EDGE);
    }
}

#define SCALE_FIELD                                                                                \
    {                                                                                              \
        "s", 1, 'i', "u5", "s of section 41; 0 with stored extinction"                             \
    }

static const vector_field extinction_under_fields[] = {
    SAMPLE_FIELDS,
    SCALE_FIELD,
    PIECE_FIELDS,
    {"x", 1, 'i', "u64.32", "depth of the ray before"},
    {"t", 1, 'i', "u32.31", "its transmittance, T(x)"},
    {"g", 3, 'i', "u64", "its sums G, colour [i]"},
    {"d", 1, 'm', "u64.32", "floor(o * depth / 2^(32+s))"},
    {"phi", 1, 'm', "u32.31", "phi(d)"},
    {"factor", 1, 'm', "u32", "floor(2 floor(t * phi / 2^32) * light / 2^32)"},
    {"xn", 1, 'o', "u64.32", "x + d"},
    {"tn", 1, 'o', "u32.31", "T(xn)"},
    {"gn", 3, 'o', "u64", "g[i] + floor(l[i] * factor / 2^s)"},
    {"en", 3, 'o', "u32", "floor(gn[i] / 2^(32-b)), where the ray ends here"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_extinction_under = {
    .name = "extinction_under",
    .section = "43",
    .title = "a sample of extinction behind what a ray has gathered: front to back",
    .rounding = "cut, but in phi and T",
    .saturation = "T is 0 from depth 32 on",
    .fields = extinction_under_fields,
    .columns = VECTOR_COLUMNS(extinction_under_row),
    .seed = 43,
    .random_rows = 400,
    .edges = extinction_under_edges,
    .draw = extinction_under_draw,
    .compute = extinction_under_compute,
};

typedef struct extinction_over_row {
    extinction_inputs in;
    uint64_t x, e[3], d, opacity, a32, factor, xn, tn, en[3];
} extinction_over_row;

static unsigned extinction_over_compute(void *columns)
{
    extinction_over_row *row = columns;
    const qv_medium medium = medium_of(row->in.depth, row->in.light, row->in.b);
    const qv_sample sample = sample_of(row->in.o, row->in.l, row->in.s);
    qv_light light = {
        {(uint32_t)row->e[0], (uint32_t)row->e[1], (uint32_t)row->e[2]}, QV_CLEAR, 0, 0};
    qv_gathered gathered = {{0, 0, 0}, row->x};
    row->d = qv_sample_depth(&sample, &medium);
    row->opacity = fx_opacity(row->d);
    row->a32 = qv_opacity_of_q31((uint32_t)row->opacity);
    row->factor = qv_light_factor(QV_CLEAR, row->d, &medium);
    qv_extinction_over(&light, &gathered, &sample, &medium, QV_STORAGE_RGBT8);
    row->xn = gathered.depth;
    row->tn = light.transmittance;
    for (unsigned c = 0; c < 3; c++)
        row->en[c] = light.colour[c];
    return row->x >= FX_OPAQUE_DEPTH ? VECTOR_SATURATE : 0;
}

static void extinction_over_draw(void *columns, vector_random *random)
{
    extinction_over_row *row = columns;
    draw_medium(&row->in, random);
    row->x = vector_bits(random, 1) ? vector_bits(random, 34) : vector_bits(random, 39);
    for (unsigned c = 0; c < 3; c++)
        row->e[c] = vector_any(random, 31);
}

static void extinction_over_edges(vector_set *set)
{
    for (unsigned i = 0; i < 64; i++) {
        const extinction_over_row row = {.in = edge_medium(i),
                                         .x = i / 32 ? FX_OPAQUE_DEPTH - (i % 2) : 0,
                                         .e = {0, 0x40000000, 0x7FFFFFFF}};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field extinction_over_fields[] = {
    SAMPLE_FIELDS,
    SCALE_FIELD,
    PIECE_FIELDS,
    {"x", 1, 'i', "u64.32", "depth of the ray before"},
    {"e", 3, 'i', "u32", "its light, colour [i]"},
    {"d", 1, 'm', "u64.32", "floor(o * depth / 2^(32+s))"},
    {"opacity", 1, 'm', "u32.31", "2^31 - T(d)"},
    {"a32", 1, 'm', "u32.32", "2 opacity - floor(opacity / 2^31)"},
    {"factor", 1, 'm', "u32", "floor(2 floor(2^31 phi(d) / 2^32) * light / 2^32)"},
    {"xn", 1, 'o', "u64.32", "x + d where x < 2^38, else x"},
    {"tn", 1, 'o', "u32.31", "T(xn)"},
    {"en", 3, 'o', "u32", "e[i] - hi(e[i], a32) + floor(l[i] * factor / 2^(s+32-b))"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_extinction_over = {
    .name = "extinction_over",
    .section = "43",
    .title = "a sample of extinction before what a ray has gathered: back to front",
    .rounding = "hi to nearest, ties upwards; all else is cut, but in phi and T",
    .saturation = "the depth from 2^38 on",
    .fields = extinction_over_fields,
    .columns = VECTOR_COLUMNS(extinction_over_row),
    .seed = 4308,
    .random_rows = 300,
    .edges = extinction_over_edges,
    .draw = extinction_over_draw,
    .compute = extinction_over_compute,
};

/* ---- Two levels ------------------------------------------------------------- */

typedef struct level_row {
    uint64_t o, l[3], s, oc, lc[3], sc, share, sb, ob, lb[3];
} level_row;

static unsigned level_compute(void *columns)
{
    level_row *row = columns;
    qv_sample finer = sample_of(row->o, row->l, row->s);
    const qv_sample coarser = sample_of(row->oc, row->lc, row->sc);
    qv_blend_samples(&finer, &coarser, (uint32_t)row->share);
    row->sb = finer.scale;
    row->ob = fx_share_bits(finer.opacity);
    for (unsigned c = 0; c < 3; c++)
        row->lb[c] = fx_sum_bits(finer.light[c]);
    return 0;
}

static void level_draw(void *columns, vector_random *random)
{
    level_row *row = columns;
    if (vector_bits(random, 1)) {
        row->s = (uint64_t)vector_between(random, 0, 21);
        row->sc = (uint64_t)vector_between(random, 0, 21);
    }
    row->o = vector_any(random, 32) % 4294901761u;
    row->oc = vector_any(random, 32) % 4294901761u;
    for (unsigned c = 0; c < 3; c++) {
        row->l[c] = row->o * vector_any(random, 16) >> 16;
        row->lc[c] = row->oc * vector_any(random, 16) >> 16;
    }
    row->share = vector_any(random, 32);
    row->share += row->share == 0;
}

static void level_edges(vector_set *set)
{
    static const uint64_t shares[] = {1, 0x8000, 0x80000000, 0xFFFFFFFF};
    for (unsigned i = 0; i < 32; i++) {
        const level_row row = {.o = i % 2 ? 16711680 : 1,
                               .l = {4261478400u, 1, 0},
                               .s = i / 2 % 2 * 4,
                               .oc = i / 4 % 2 ? 16711680 : 0,
                               .lc = {4261478400u, 0, 3},
                               .sc = i % 3 * 2,
                               .share = shares[i / 8]};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field level_fields[] = {
    {"o", 1, 'i', "u32", "O of the finer level"},
    {"l", 3, 'i', "u32", "L of the finer level, colour [i]"},
    {"s", 1, 'i', "u5", "s of the finer level"},
    {"oc", 1, 'i', "u32", "O of the coarser level"},
    {"lc", 3, 'i', "u32", "L of the coarser level, colour [i]"},
    {"sc", 1, 'i', "u5", "s of the coarser level"},
    {"share", 1, 'i', "u32.32", "of the coarser level, not 0"},
    {"sb", 1, 'o', "u5", "min(s, sc)"},
    {"ob", 1, 'o', "u32",
     "floor((floor(o / 2^(s-sb)) (2^32 - share) + floor(oc / 2^(sc-sb)) share + 2^31) / 2^32)"},
    {"lb", 3, 'o', "u32", "the same of l[i] and lc[i]"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_level_blend = {
    .name = "level_blend",
    .section = "44",
    .title = "samples of two levels in one",
    .rounding = "to nearest, ties upwards",
    .saturation = "none",
    .fields = level_fields,
    .columns = VECTOR_COLUMNS(level_row),
    .seed = 44,
    .random_rows = 200,
    .edges = level_edges,
    .draw = level_draw,
    .compute = level_compute,
};
