/*
 * stages_blend.c - blends of slices into states of few bits: sections 48 to 50 and 52.
 */
#include "stages.h"

#include "fx_blend.h"
#include "qvol.h"

/* ---- Light ------------------------------------------------------------------------ */

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

/* ---- Plain blends -------------------------------------------------------------------- */

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

/* ---- Dithered blends ------------------------------------------------------------------ */

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
    .draw = blend24_draw,
    .compute = blend24_compute,
};

/* ---- Front to back ---------------------------------------------------------------------- */

typedef struct front_row {
    uint64_t fraction, state, t, o32, colour, light, u, tn, share, share_n, of_colour, of_light;
} front_row;

static unsigned front_compute(void *columns)
{
    front_row *row = columns;
    const unsigned fraction = (unsigned)row->fraction;
    const uint32_t state = (uint32_t)row->state, colour = (uint32_t)row->colour;
    const uint32_t before = (uint32_t)row->t, after = fx_transmit(before, (uint32_t)row->o32);
    row->tn = after;
    row->share = fx_opaque_share(colour, before, fraction);
    row->share_n = fx_opaque_share(colour, after, fraction);
    row->of_colour = fx_front_colour(state, colour, before, after, fraction);
    row->of_light =
        fx_front_light(state, (uint32_t)row->light, before, after, (uint32_t)row->u, fraction);
    return row->of_light == fx_opaque_share(255, after, fraction) ? VECTOR_SATURATE : 0;
}

static void front_draw(void *columns, vector_random *random)
{
    static const uint8_t fractions[4] = {0, 4, 8, 16};
    front_row *row = columns;
    row->fraction = fractions[vector_bits(random, 2)];
    row->t = vector_any(random, 24);
    row->o32 = vector_any(random, 32);
    row->colour = vector_any(random, 8);
    row->state =
        fx_opaque_share((uint32_t)vector_any(random, 8), (uint32_t)row->t, (unsigned)row->fraction);
    row->light = fx_light_of_colour32((uint32_t)vector_any(random, 8), (uint32_t)row->o32);
    row->u = vector_bits(random, 2) ? vector_any(random, 32) : FX_NO_DITHER;
}

static void front_edges(vector_set *set)
{
    static const uint8_t fractions[4] = {0, 4, 8, 16};
    static const uint64_t rests[] = {0, 1, 12345678, 0x800000, FX_CLEAR_Q24};
    static const uint64_t opacities[] = {0, 1, 0x80000000, 0xFFFFFFFF};
    for (unsigned i = 0; i < 80; i++) {
        const uint64_t o32 = opacities[i / 20], t = rests[i / 4 % 5];
        const front_row row = {.fraction = fractions[i % 4],
                               .state = fx_opaque_share(255, (uint32_t)t, fractions[i % 4]),
                               .t = t,
                               .o32 = o32,
                               .colour = i % 2 ? 255 : 200,
                               .light = fx_light_of_colour32(255, (uint32_t)o32),
                               .u = i % 3 ? UINT32_MAX : 0};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field front_fields[] = {
    {"fraction", 1, 'i', "u5", "f: 0, 4, 8 or 16"},
    {"state", 1, 'i', "u24", "S, at most share(255) of t"},
    {"t", 1, 'i', "u24.24", "T"},
    {"o32", 1, 'i', "u32.32", "opacity of the slice"},
    {"colour", 1, 'i', "u8", "c"},
    {"light", 1, 'i', "u32.23", "C"},
    {"u", 1, 'i', "u32.32", "dither value"},
    {"tn", 1, 'o', "u24.24", "floor((256 t - hi(256 t, o32) + 128) / 256)"},
    {"share", 1, 'm', "u24", "floor((2^fraction colour (2^24 - t) + 2^23) / 2^24)"},
    {"share_n", 1, 'm', "u24", "floor((2^fraction colour (2^24 - tn) + 2^23) / 2^24)"},
    {"of_colour", 1, 'o', "u24", "min(state + share_n - share, share'(255))"},
    {"of_light", 1, 'o', "u24",
     "min(state + floor((hi(light, 256 t) + floor(u / 2^(9+fraction))) / 2^(23-fraction)), "
     "share'(255))"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_blend_front = {
    .name = "blend_front",
    .section = "49",
    .title = "blends front to back",
    .rounding = "to nearest, ties upwards; of light by the dither value",
    .saturation = "states at the share of colour 255",
    .fields = front_fields,
    .columns = VECTOR_COLUMNS(front_row),
    .seed = 49,
    .random_rows = 300,
    .edges = front_edges,
    .draw = front_draw,
    .compute = front_compute,
};

/* ---- Residual ---------------------------------------------------------------------------- */

typedef struct residual_row {
    uint64_t fraction, state, level;
    int64_t residual;
} residual_row;

static unsigned residual_compute(void *columns)
{
    residual_row *row = columns;
    const unsigned fraction = (unsigned)row->fraction;
    row->level = fx_level_of((uint32_t)row->state, fraction);
    row->residual = fx_residual_of((uint32_t)row->state, fraction);
    if (fx_state_of((uint32_t)row->level, (int32_t)row->residual, fraction) != row->state)
        vector_fail("residual", "state", "does not come back");
    return row->residual == -((int64_t)1 << (fraction - 1)) ? VECTOR_TIE : 0;
}

static void residual_draw(void *columns, vector_random *random)
{
    residual_row *row = columns;
    row->fraction = (uint64_t)4 << vector_between(random, 0, 2);
    row->state = vector_any(random, 24) % ((255u << row->fraction) + 1u);
}

static void residual_edges(vector_set *set)
{
    for (unsigned i = 0; i < 48; i++) {
        const unsigned fraction = 4u << i % 3;
        const residual_row row = {.fraction = fraction,
                                  .state = i < 45 ? (i * 5u << fraction) + (1u << (fraction - 1u)) -
                                                        i / 3u % 2u
                                                  : 255u << fraction};
        vector_add(set, &row, VECTOR_EDGE);
    }
}

static const vector_field residual_fields[] = {
    {"fraction", 1, 'i', "u5", "f: 4, 8 or 16"},
    {"state", 1, 'i', "u24", "S, at most 255 * 2^f"},
    {"level", 1, 'o', "u8", "floor((state + 2^(fraction-1)) / 2^fraction)"},
    {"residual", 1, 'o', "s16", "state - 2^fraction level"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_residual = {
    .name = "residual",
    .section = "50",
    .title = "level and residual of a state",
    .rounding = "to nearest, ties upwards",
    .saturation = "none",
    .fields = residual_fields,
    .columns = VECTOR_COLUMNS(residual_row),
    .seed = 50,
    .random_rows = 100,
    .edges = residual_edges,
    .draw = residual_draw,
    .compute = residual_compute,
};

/* ---- Replay ------------------------------------------------------------------------------ */

typedef struct replay_row {
    uint64_t rgba[4], behind[4], front[4], result[4];
} replay_row;

static unsigned replay_compute(void *columns)
{
    replay_row *row = columns;
    uint8_t behind[4], front[4], rgba[4];
    const qv_rect rect = {0, 0, 1, 1};
    const qv_buffer far = {
        .pixels = behind, .bytes = 4, .stride = 4, .blend = &qv_hardware_rgba8888};
    const qv_buffer near = {
        .pixels = front, .bytes = 4, .stride = 4, .blend = &qv_hardware_rgba8888};
    for (unsigned c = 0; c < 4; c++) {
        behind[c] = (uint8_t)row->behind[c];
        front[c] = (uint8_t)row->front[c];
        rgba[c] = (uint8_t)row->rgba[c];
    }
    if (qv_replay(&far, &near, rgba, &rect) != QV_OK)
        vector_fail("replay", "buffers", "refused");
    for (unsigned c = 0; c < 4; c++)
        row->result[c] = behind[c];
    return 0;
}

/* A near image that so many slices have made, by the blend of the stage blend_plain. */
static void stack(uint64_t front[4], const uint64_t rgba[4], unsigned slices)
{
    const uint32_t opacity = (uint32_t)rgba[3];
    for (unsigned i = 0; i < slices; i++)
        for (unsigned c = 0; c < 4; c++) {
            const uint32_t colour = (uint32_t)(c < 3 ? rgba[c] : 255);
            const uint32_t weighted = fx_divide_by_ones(colour * opacity, 8);
            front[c] = fx_blend_associated((uint32_t)front[c], weighted, opacity, 8);
        }
}

static void replay_draw(void *columns, vector_random *random)
{
    replay_row *row = columns;
    for (unsigned c = 0; c < 4; c++) {
        row->rgba[c] = vector_any(random, 8);
        row->behind[c] = vector_bits(random, 8);
    }
    row->rgba[3] = vector_bits(random, 5);
    stack(row->front, row->rgba, (unsigned)vector_bits(random, 5));
    if (vector_bits(random, 3) == 0)
        row->front[1] = vector_bits(random, 8); /* of no number of slices */
}

/* S77. */
static void replay_edges(vector_set *set)
{
    static const replay_row rows[] = {
        {.rgba = {255, 255, 255, 1}, .behind = {100, 100, 100, 100}, .front = {100, 100, 100, 100}},
        {.rgba = {200, 100, 0, 30}, .behind = {90, 46, 255, 200}, .front = {129, 64, 0, 161}},
        {.rgba = {255, 255, 255, 3}, .behind = {255, 0, 0, 255}, .front = {93, 93, 93, 93}},
        {.rgba = {10, 20, 30, 40}, .behind = {77, 77, 77, 77}, .front = {1, 2, 3, 4}},
        {.rgba = {7, 8, 9, 0}, .behind = {1, 2, 3, 4}, .front = {0, 0, 0, 0}}};
    for (unsigned i = 0; i < sizeof rows / sizeof rows[0]; i++)
        vector_add(set, &rows[i], VECTOR_EDGE);
}

static const vector_field replay_fields[] = {
    {"rgba", 4, 'i', "u8", "R, G, B, a of the slices, channel [i]"},
    {"behind", 4, 'i', "u8", "S, channel [i]"},
    {"front", 4, 'i', "u8", "K, channel [i]"},
    {"result", 4, 'o', "u8", "what S becomes by section 52, channel [i]"},
    {NULL, 0, 0, NULL, NULL}};

const vector_stage stage_replay = {
    .name = "replay",
    .section = "52",
    .title = "slices of one colour, played again over another image",
    .rounding = "to nearest; there are no ties",
    .saturation = "colours at the opacity",
    .fields = replay_fields,
    .columns = VECTOR_COLUMNS(replay_row),
    .seed = 52,
    .random_rows = 150,
    .edges = replay_edges,
    .draw = replay_draw,
    .compute = replay_compute,
};
