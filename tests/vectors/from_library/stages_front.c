/*
 * stages_front.c - blends front to back, residuals, replay: sections 49, 50 and 52.
 */
#include "stages.h"

#include "fx_blend.h"
#include "qvol.h"

/* ---- Front to back ---------------------------------------------------------- */

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

/* ---- Residual --------------------------------------------------------------- */

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

/* ---- Replay ----------------------------------------------------------------- */

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
