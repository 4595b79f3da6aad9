/*
 * stages_blend.c - blends of slices back to front, into states of few bits: section 48.
 */
#include "stages.h"

#include "fx_blend.h"

/* ---- Light ------------------------------------------------------------------ */

typedef struct light_row {
    uint64_t o32, colour, e, factor, level, a, light, light32, opacity, shown, of_level;
} light_row;

static const uint32_t light_factors[4] = {2155905153u, 2139160321u, 4278255361u, 2147483649u};

static unsigned light_compute(void *columns)
{
    light_row *row = columns;
    const uint32_t o32 = (uint32_t)row->o32, colour = (uint32_t)row->colour;
    const uint32_t light = fx_light_of((uint32_t)row->e, light_factors[row->factor]);
    row->a = fx_opacity_q23(o32);
    row->light = fx_light_of_colour(colour, (uint32_t)row->a);
    row->light32 = fx_light_of_colour32(colour, o32);
    row->opacity = fx_light_of_colour32(255, o32);
    row->shown = fx_light_within(light, (uint32_t)row->opacity);
    row->of_level = fx_opacity_of_level((uint32_t)row->level);
    return light > row->opacity ? VECTOR_SATURATE : 0;
}

static void light_draw(void *columns, vector_random *random)
{
    light_row *row = columns;
    row->o32 = vector_any(random, 32);
    row->colour = vector_any(random, 8);
    row->factor = vector_bits(random, 2);
    row->e = vector_any(random, 32) % 0x80000000u;
    if (vector_bits(random, 1))
        row->e = row->o32 * row->colour / 512u;
    row->level = vector_any(random, 24) % 16711681u;
}

static void light_edges(vector_set *set)
{
    static const uint64_t opacities[] = {0, 255, 256, 257, 50529, 0x80000000, 0xFFFFFFFF};
    static const uint64_t levels[] = {0, 1, 65535, 65536, 8355840, 16711679, 16711680};
    for (unsigned i = 0; i < 56; i++) {
        const light_row row = {.o32 = opacities[i % 7],
                               .colour = i / 14 * 85,
                               .e = i % 2 ? 0x7FFFFFFF : opacities[i % 7] / 2,
                               .factor = i / 14,
                               .level = levels[i / 8]};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field light_fields[] = {
    {"o32", 1, 'i', "u32.32", "opacity of the slice"},
    {"colour", 1, 'i', "u8", "c, a level"},
    {"e", 1, 'i', "u32", "light E of section 14"},
    {"factor", 1, 'i', "u2",
     "of section 48: 0 2155905153, 1 2139160321, 2 4278255361, 3 2147483649"},
    {"level", 1, 'i', "u24.16", "levels, at most 16711680"},
    {"a", 1, 'o', "u32.23", "floor((o32 + 256) / 512)"},
    {"light", 1, 'o', "u32.23", "colour * a"},
    {"light32", 1, 'o', "u32.23", "hi(o32, 8388608 colour)"},
    {"opacity", 1, 'o', "u32.23", "hi(o32, 2139095040)"},
    {"shown", 1, 'o', "u32.23", "min(2 hi(e, factor), opacity)"},
    {"of_level", 1, 'o', "u32.32", "257 level + floor(level / 256) + floor(level / 65536)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_light = {
    .name = "light",
    .section = "48",
    .title = "opacity and light of a slice",
    .rounding = "products and a to nearest, ties upwards; of_level is cut",
    .saturation = "shown at the light of the opacity",
    .fields = light_fields,
    .columns = VECTOR_COLUMNS(light_row),
    .seed = 48,
    .random_rows = 200,
    .edges = light_edges,
    .draw = light_draw,
    .compute = light_compute,
};

/* ---- Plain blends ----------------------------------------------------------- */

typedef struct plain_row {
    uint64_t bits, state, colour, opacity, plain, weighted, associated;
} plain_row;

static unsigned plain_compute(void *columns)
{
    plain_row *row = columns;
    const unsigned bits = (unsigned)row->bits;
    const uint32_t state = (uint32_t)row->state, colour = (uint32_t)row->colour;
    const uint32_t opacity = (uint32_t)row->opacity;
    row->weighted = fx_divide_by_ones(colour * opacity, bits);
    row->plain = fx_blend_plain(state, colour, opacity, bits);
    row->associated = fx_blend_associated(state, (uint32_t)row->weighted, opacity, bits);
    return 0;
}

static void plain_draw(void *columns, vector_random *random)
{
    static const uint8_t widths[4] = {5, 6, 8, 12};
    plain_row *row = columns;
    row->bits = widths[vector_bits(random, 2)];
    row->state = vector_any(random, (unsigned)row->bits);
    row->colour = vector_any(random, (unsigned)row->bits);
    row->opacity = vector_any(random, (unsigned)row->bits);
}

/* Products on both sides of a half: 255 v + 127 and one more. */
static void plain_edges(vector_set *set)
{
    for (uint64_t v = 1; v < 256; v++) {
        const plain_row row = {
            .bits = 8, .state = v, .colour = 255 - v / 2, .opacity = v * 37 % 256};
        vector_add(set, &row, VECTOR_EDGE);
    }
    static const uint8_t widths[4] = {5, 6, 8, 12};
    for (unsigned i = 0; i < 4 * 27; i++) {
        const uint64_t full = ((uint64_t)1 << widths[i / 27]) - 1u;
        const uint64_t values[3] = {0, full / 2, full};
        const plain_row row = {.bits = widths[i / 27],
                               .state = values[i % 3],
                               .colour = values[i / 3 % 3],
                               .opacity = values[i / 9 % 3]};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field plain_fields[] = {
    {"bits", 1, 'i', "u4", "n: 5, 6, 8 or 12; F is 2^n - 1"},
    {"state", 1, 'i', "u12", "S, of n bits"},
    {"colour", 1, 'i', "u12", "c, of n bits"},
    {"opacity", 1, 'i', "u12", "a, of n bits"},
    {"plain", 1, 'o', "u12", "div(colour * opacity + (F - opacity) state)"},
    {"weighted", 1, 'm', "u12", "div(colour * opacity)"},
    {"associated", 1, 'o', "u12", "weighted + div((F - opacity) state)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_blend_plain = {
    .name = "blend_plain",
    .section = "48",
    .title = "rounded blends of few bits",
    .rounding = "to nearest; there are no ties",
    .saturation = "none",
    .fields = plain_fields,
    .columns = VECTOR_COLUMNS(plain_row),
    .seed = 4801,
    .random_rows = 300,
    .edges = plain_edges,
    .draw = plain_draw,
    .compute = plain_compute,
};

/* ---- Dithered blends -------------------------------------------------------- */

typedef struct dithered_row {
    uint64_t fraction, state, light, a, u, light5, light6, result;
} dithered_row;

static unsigned dithered_compute(void *columns)
{
    dithered_row *row = columns;
    const uint32_t light = (uint32_t)row->light;
    row->light5 = fx_light_narrow(light, FX_FACTOR_5);
    row->light6 = fx_light_narrow(light, FX_FACTOR_6);
    row->result = fx_blend_dithered((uint32_t)row->state, light, (uint32_t)row->a, (uint32_t)row->u,
                                    (unsigned)row->fraction);
    return row->result == 255u << row->fraction ? VECTOR_OVERFLOW : 0;
}

static void dithered_draw(void *columns, vector_random *random)
{
    dithered_row *row = columns;
    row->fraction = (uint64_t)(4 * vector_between(random, 0, 2));
    row->state = vector_any(random, 16) % ((255u << row->fraction) + 1u);
    row->a = vector_any(random, 23);
    row->light = row->a * vector_any(random, 8);
    if (vector_bits(random, 1))
        row->light = (uint64_t)vector_between(random, 0, (int64_t)(255u * row->a));
    row->u = vector_any(random, 32);
}

static void dithered_edges(vector_set *set)
{
    static const uint64_t opacities[] = {0, 1, 4194304, 8388607, 8388608};
    static const uint64_t dithers[] = {0, 1, 0x80000000, 0xFFFFFFFF};
    for (unsigned i = 0; i < 3 * 5 * 4 * 3; i++) {
        const unsigned fraction = i % 3 * 4;
        const uint64_t states[3] = {0, 100u << fraction | 1u, 255u << fraction};
        const uint64_t a = opacities[i / 3 % 5];
        const dithered_row row = {.fraction = fraction,
                                  .state = states[i / 60],
                                  .light = i % 2 ? 255 * a : 100 * a,
                                  .a = a,
                                  .u = dithers[i / 15 % 4]};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field dithered_fields[] = {
    {"fraction", 1, 'i', "u4", "f: 0, 4 or 8"},
    {"state", 1, 'i', "u16", "S, at most 255 * 2^f"},
    {"light", 1, 'i', "u32.23", "C, at most 255 a"},
    {"a", 1, 'i', "u32.23", "A, at most 2^23"},
    {"u", 1, 'i', "u32.32", "dither value"},
    {"light5", 1, 'm', "u32", "hi(light, 522133279)"},
    {"light6", 1, 'm', "u32", "hi(light, 1061109568)"},
    {"result", 1, 'o', "u16",
     "floor((light + floor((8388608 - a) state / 2^fraction) + floor(u / 2^(9+fraction))) / "
     "2^(23-fraction))"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_blend_dithered = {
    .name = "blend_dithered",
    .section = "48",
    .title = "a dithered blend back to front",
    .rounding = "by the dither value",
    .saturation = "none",
    .fields = dithered_fields,
    .columns = VECTOR_COLUMNS(dithered_row),
    .seed = 4802,
    .random_rows = 350,
    .edges = dithered_edges,
    .draw = dithered_draw,
    .compute = dithered_compute,
};

typedef struct blend24_row {
    uint64_t state, light, o32, u, kept, result;
} blend24_row;

static unsigned blend24_compute(void *columns)
{
    blend24_row *row = columns;
    const uint32_t state = (uint32_t)row->state, o32 = (uint32_t)row->o32;
    row->kept = (state << 8) - fx_high_product(state << 8, o32);
    row->result = fx_blend_8_16(state, (uint32_t)row->light, o32, (uint32_t)row->u);
    return row->result == 16711680u ? VECTOR_OVERFLOW : 0;
}

static void blend24_draw(void *columns, vector_random *random)
{
    blend24_row *row = columns;
    row->state = vector_any(random, 24) % 16711681u;
    row->o32 = vector_any(random, 32);
    row->light = fx_light_of_colour32((uint32_t)vector_any(random, 8), (uint32_t)row->o32);
    row->u = vector_bits(random, 1) ? FX_NO_DITHER : vector_any(random, 32);
}

static void blend24_edges(vector_set *set)
{
    static const uint64_t opacities[] = {0, 1, 50529, 0x80000000, 0xFFFFFFFF};
    static const uint64_t states[] = {0, 1, 5, 1234567, 16711679, 16711680};
    static const uint64_t dithers[] = {0, FX_NO_DITHER, 0xFFFFFFFF};
    for (unsigned i = 0; i < 90; i++) {
        const uint64_t o32 = opacities[i % 5];
        const blend24_row row = {.state = states[i / 5 % 6],
                                 .light = fx_light_of_colour32(i % 2 ? 255 : 3, (uint32_t)o32),
                                 .o32 = o32,
                                 .u = dithers[i / 30]};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

/* Found by search: here a dither value's part that is off by 1 shows. */
static void blend24_added(vector_set *set)
{
    static const blend24_row rows[] = {
        {.state = 4178544, .light = 435845513, .o32 = 1957481601, .u = 1063078446},
        {.state = 4689305, .light = 7718879, .o32 = 52000871, .u = 2287065962},
        {.state = 11652300, .light = 319526, .o32 = 1319333, .u = 281038756},
        {.state = 16553398, .light = 1109837717, .o32 = 2667778926, .u = 3462049020},
        {.state = 9789937, .light = 7543104, .o32 = 16504570, .u = 4213109029}};
    for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++)
        vector_add(set, &rows[i], VECTOR_EDGE);
}

static const vector_field blend24_fields[] = {
    {"state", 1, 'i', "u24.16", "S, at most 16711680"},
    {"light", 1, 'i', "u32.23", "C"},
    {"o32", 1, 'i', "u32.32", "opacity of the slice"},
    {"u", 1, 'i', "u32.32", "dither value; 2^31 rounds to nearest"},
    {"kept", 1, 'm', "u32.24", "256 state - hi(256 state, o32)"},
    {"result", 1, 'o', "u24.16",
     "floor((kept + 2 light + 2 + floor(252 floor(u / 2^24) / 256)) / 256)"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_blend24 = {
    .name = "blend24",
    .section = "48",
    .title = "a blend of 24 bits back to front",
    .rounding = "by the dither value; hi to nearest, ties upwards",
    .saturation = "none",
    .fields = blend24_fields,
    .columns = VECTOR_COLUMNS(blend24_row),
    .seed = 4824,
    .random_rows = 250,
    .edges = blend24_edges,
    .added = blend24_added,
    .draw = blend24_draw,
    .compute = blend24_compute,
};
