/*
 * blend_model.h - every blend of slices as tests/SPEC.md has it: states as fields of bits in
 * a pixel's bytes, and rules of exact fractions in 64 bits. It shares nothing with the library's
 * arithmetic.
 */
#ifndef BLEND_MODEL_H
#define BLEND_MODEL_H

#include "blend.h"
#include "qvol.h"

/* The rules of section 59 of tests/SPEC.md. */
typedef enum model_rule {
    RULE_DITHERED,  /* states of 8 to 16 bits */
    RULE_NARROW,    /* of 5 and 6 */
    RULE_WIDE,      /* of 24 */
    RULE_UNDER,     /* front to back */
    RULE_PLAIN,     /* hardware, equation 1 */
    RULE_WEIGHTED,  /* hardware, equations 6 and 7 */
    RULE_WEIGHTED12 /* the same of 12 bits */
} model_rule;

typedef struct blend_model {
    const char *name;
    const qv_blend *blend;
    model_rule rule;
    unsigned channels, fraction, residual_bits;
    unsigned bytes, beside;
} blend_model;

#define MODEL(name, ...)                                                                           \
    {                                                                                              \
#name, &qv_##name, __VA_ARGS__                                                             \
    }

enum { MODELS = 20, MODEL_OVER = 12, MODEL_UNDER = 15 };

/* Back to front up to MODEL_OVER, front to back up to MODEL_UNDER, then hardware's; the last hands
   out. */
static const blend_model models[MODELS] = {
    MODEL(over_rgb888, RULE_DITHERED, 3, 0, 0, 3, 0),
    MODEL(over_rgba8888, RULE_DITHERED, 4, 0, 0, 4, 0),
    MODEL(over_rgb888_residual4, RULE_DITHERED, 3, 4, 4, 3, 2),
    MODEL(over_rgba8888_residual4, RULE_DITHERED, 4, 4, 4, 4, 2),
    MODEL(over_rgb888_residual8, RULE_DITHERED, 3, 8, 8, 3, 3),
    MODEL(over_rgba8888_residual8, RULE_DITHERED, 4, 8, 8, 4, 4),
    MODEL(over_rgb565, RULE_NARROW, 3, 0, 0, 2, 0),
    MODEL(over_rgba12, RULE_DITHERED, 4, 4, 0, 6, 0),
    MODEL(over_rgb16, RULE_DITHERED, 3, 8, 0, 6, 0),
    MODEL(over_rgba16, RULE_DITHERED, 4, 8, 0, 8, 0),
    MODEL(over_rgb24, RULE_WIDE, 3, 16, 0, 9, 0),
    MODEL(over_rgba24, RULE_WIDE, 4, 16, 0, 12, 0),
    MODEL(under_rgb888, RULE_UNDER, 3, 0, 0, 3, 3),
    MODEL(under_rgb16, RULE_UNDER, 3, 8, 0, 6, 3),
    MODEL(under_rgb24, RULE_UNDER, 3, 16, 0, 9, 3),
    MODEL(hardware_rgb888, RULE_PLAIN, 3, 0, 0, 3, 0),
    MODEL(hardware_rgb565, RULE_PLAIN, 3, 0, 0, 2, 0),
    MODEL(hardware_rgba8888, RULE_WEIGHTED, 4, 0, 0, 4, 0),
    MODEL(hardware_rgba12, RULE_WEIGHTED12, 4, 4, 0, 6, 0),
    MODEL(hand_out_rgba8888, RULE_WEIGHTED, 4, 0, 0, 4, 0),
};

/* ---- States ----------------------------------------------------------------- */

/* What a pixel holds; in 565 and 12 bits hardware's units, else levels with fraction bits. */
typedef struct model_pixel {
    uint64_t state[4];
    uint64_t transmittance;
} model_pixel;

static inline int model_is_565(const blend_model *of)
{
    return of->bytes == 2;
}

/* The greatest state of a channel. */
static inline uint64_t model_full(const blend_model *of, unsigned c)
{
    if (model_is_565(of))
        return c == 1 ? 63 : 31;
    return of->rule == RULE_WEIGHTED12 ? 4095 : (uint64_t)255 << of->fraction;
}

static inline uint64_t model_bits(const uint8_t *bytes, unsigned first, unsigned count)
{
    uint64_t v = 0;
    for (unsigned i = 0; i < count; i++)
        v |= (uint64_t)(bytes[(first + i) / 8] >> (first + i) % 8 & 1) << i;
    return v;
}

static inline void model_set_bits(uint8_t *bytes, unsigned first, unsigned count, uint64_t v)
{
    for (unsigned i = 0; i < count; i++) {
        const unsigned at = first + i;
        const unsigned bit = 1u << at % 8;
        bytes[at / 8] = (uint8_t)((bytes[at / 8] & ~bit) | ((v >> i & 1) != 0 ? bit : 0));
    }
}

/* Where the field of a channel lies in the pixel, lowest bit first. */
static inline unsigned model_first_bit(const blend_model *of, unsigned c, unsigned *count)
{
    static const unsigned first[3] = {11, 5, 0}, wide[3] = {5, 6, 5};
    *count = model_is_565(of) ? wide[c] : 8 + of->fraction - of->residual_bits;
    return model_is_565(of) ? first[c] : c * *count;
}

static inline model_pixel model_read(const blend_model *of, const uint8_t *pixel,
                                     const uint8_t *beside)
{
    model_pixel p = {{0, 0, 0, 0}, 0};
    for (unsigned c = 0; c < of->channels; c++) {
        unsigned count;
        const unsigned first = model_first_bit(of, c, &count);
        p.state[c] = model_bits(pixel, first, count);
        if (of->residual_bits != 0) {
            const uint64_t half = (uint64_t)1 << (of->residual_bits - 1);
            const uint64_t v = model_bits(beside, c * of->residual_bits, of->residual_bits);
            p.state[c] = (p.state[c] << of->residual_bits) + (v < half ? v : v - 2 * half);
        }
    }
    if (of->rule == RULE_UNDER)
        p.transmittance = model_bits(beside, 0, 24);
    return p;
}

/* Bits that belong to no channel become 0. */
static inline void model_write(const blend_model *of, uint8_t *pixel, uint8_t *beside,
                               const model_pixel *p)
{
    if (of->beside != 0)
        model_set_bits(beside, 0, 8 * of->beside, 0);
    for (unsigned c = 0; c < of->channels; c++) {
        const unsigned bits = of->residual_bits;
        unsigned count;
        const unsigned first = model_first_bit(of, c, &count);
        const uint64_t half = bits == 0 ? 0 : (uint64_t)1 << (bits - 1);
        model_set_bits(pixel, first, count, (p->state[c] + half) >> bits);
        if (bits != 0)
            model_set_bits(beside, c * bits, bits,
                           p->state[c] - ((p->state[c] + half) >> bits << bits));
    }
    if (of->rule == RULE_UNDER)
        model_set_bits(beside, 0, 24, p->transmittance);
}

/* ---- Arithmetic ------------------------------------------------------------- */

static inline uint64_t model_least(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

/* n / d to nearest, ties upwards. */
static inline uint64_t model_round(uint64_t n, uint64_t d)
{
    return (2 * n + d) / (2 * d);
}

/* hi of section 2. */
static inline uint64_t model_hi(uint64_t a, uint64_t b)
{
    return (a * b + 0x80000000u) >> 32;
}

/* The opacity, Q0.32, of a level with 16 fraction bits. */
static inline uint32_t model_opacity(uint64_t level)
{
    return (uint32_t)(257 * level + (level >> 8) + (level >> 16));
}

/* An opacity on 0 .. full, to nearest. */
static inline uint64_t model_level(uint32_t opacity, uint64_t full)
{
    return (model_hi(opacity, full << 16) + 0x8000) >> 16;
}

/* A fragment's opacity in Q0.23, the light of its opacity, and its own light within that. */
typedef struct model_light {
    uint64_t opacity, opaque, light[4];
} model_light;

static inline model_light model_light_of(const blend_model *of, const qv_fragment *fragment)
{
    model_light l;
    const int wide = of->rule == RULE_WIDE || of->rule == RULE_UNDER;
    l.opacity = ((uint64_t)fragment->opacity + 256) >> 9;
    l.opaque = wide ? model_hi(fragment->opacity, (uint64_t)255 << 23) : 255 * l.opacity;
    for (unsigned c = 0; c < 3; c++)
        l.light[c] = model_least(fragment->light[c], l.opaque);
    l.light[3] = l.opaque;
    return l;
}

/* A colour of `bits` fraction bits that is not weighted. */
static inline uint64_t model_colour(const model_light *l, unsigned c, unsigned bits)
{
    return l->opacity == 0 ? 0 : model_round(l->light[c] << bits, l->opacity);
}

/* ---- Rules ------------------------------------------------------------------ */

static inline uint64_t model_dithered(uint64_t state, uint64_t light, const model_light *l,
                                      uint64_t u, unsigned f)
{
    const uint64_t kept = ((0x800000 - l->opacity) * state) >> f;
    return (light + kept + (u >> (9 + f))) >> (23 - f);
}

static inline uint64_t model_wide(uint64_t state, uint64_t light, uint32_t opacity, uint64_t u)
{
    const uint64_t kept = 256 * state - model_hi(256 * state, opacity);
    return (kept + 2 * light + 2 + 252 * (u >> 24) / 256) >> 8;
}

static inline uint64_t model_share(uint64_t transmittance, unsigned f)
{
    return ((((0x1000000 - transmittance) * 255) << f) + 0x800000) >> 24;
}

static inline void model_under(const blend_model *of, model_pixel *p, const model_light *l,
                               uint32_t opacity, uint64_t u)
{
    const unsigned f = of->fraction;
    const uint64_t before = 256 * p->transmittance;
    p->transmittance = (before - model_hi(before, opacity) + 128) >> 8;
    for (unsigned c = 0; c < 3; c++) {
        const uint64_t shown = model_hi(l->light[c], before) + (u >> (9 + f));
        p->state[c] =
            model_least(p->state[c] + (shown >> (23 - f)), model_share(p->transmittance, f));
    }
}

static inline void model_plain(const blend_model *of, model_pixel *p, const model_light *l,
                               uint64_t opacity)
{
    for (unsigned c = 0; c < 3; c++) {
        const uint64_t colour = model_round(model_colour(l, c, 0) * model_full(of, c), 255);
        p->state[c] = model_round(colour * opacity + (255 - opacity) * p->state[c], 255);
    }
}

static inline void model_weighted(model_pixel *p, const model_light *l, uint64_t opacity)
{
    for (unsigned c = 0; c < 4; c++) {
        const uint64_t colour = c == 3 ? 255 : model_colour(l, c, 0);
        p->state[c] =
            model_round(colour * opacity, 255) + model_round((255 - opacity) * p->state[c], 255);
    }
}

static inline void model_weighted12(model_pixel *p, const model_light *l, uint32_t opacity)
{
    const uint64_t a = model_level(opacity, 4095);
    for (unsigned c = 0; c < 4 && a != 0; c++) {
        const uint64_t colour = c == 3 ? 4095 : model_hi(model_colour(l, c, 8), 269422351);
        p->state[c] = model_round(colour * a, 4095) + model_round((4095 - a) * p->state[c], 4095);
    }
}

/* A slice over, or under, a pixel; `made` is what a technique has made of its opacity. */
static inline void model_blend(const blend_model *of, model_pixel *p, const qv_fragment *fragment,
                               uint32_t u, uint32_t made)
{
    static const uint64_t narrow[3] = {522133279, 1061109568, 522133279};
    const model_light l = model_light_of(of, fragment);
    if (of->blend == &qv_hand_out_rgba8888)
        *p = (model_pixel){{0, 0, 0, 0}, 0};
    if (of->rule == RULE_UNDER)
        model_under(of, p, &l, fragment->opacity, u);
    if (of->rule == RULE_PLAIN)
        model_plain(of, p, &l, made);
    if (of->rule == RULE_WEIGHTED)
        model_weighted(p, &l, made);
    if (of->rule == RULE_WEIGHTED12)
        model_weighted12(p, &l, fragment->opacity);
    for (unsigned c = 0; c < of->channels; c++) {
        if (of->rule == RULE_DITHERED)
            p->state[c] = model_dithered(p->state[c], l.light[c], &l, u, of->fraction);
        if (of->rule == RULE_NARROW)
            p->state[c] = model_dithered(p->state[c], model_hi(l.light[c], narrow[c]), &l, u, 0);
        if (of->rule == RULE_WIDE)
            p->state[c] = model_wide(p->state[c], l.light[c], fragment->opacity, u);
    }
}

/* The background over nothing. */
static inline model_pixel model_clear(const blend_model *of, const qv_fragment *background)
{
    model_pixel p = {{0, 0, 0, 0}, 0};
    if (of->rule == RULE_UNDER)
        p.transmittance = 0xFFFFFF;
    else if (of->rule == RULE_DITHERED || of->rule == RULE_NARROW || of->rule == RULE_WIDE)
        model_blend(of, &p, background, 0x80000000u, 0);
    else
        for (unsigned c = 0; c < 3; c++)
            p.state[c] = model_round((uint64_t)background->light[c] * model_full(of, c),
                                     (uint64_t)255 << 23);
    if (of->channels == 4 && of->blend->look != 0)
        p.state[3] = model_level(background->opacity, 255);
    if (of->rule == RULE_WEIGHTED12)
        p.state[3] = model_level(background->opacity, 4095);
    return p;
}

/* What a pixel shows. */
static inline qv_fragment model_shown(const blend_model *of, const model_pixel *p)
{
    qv_fragment shown = {{0, 0, 0}, 0xFFFFFFFFu};
    for (unsigned c = 0; c < 3; c++)
        shown.light[c] = (uint32_t)model_round(p->state[c] * 255 << 23, model_full(of, c));
    if (of->rule == RULE_WEIGHTED12)
        shown.opacity = (uint32_t)((p->state[3] << 20) + (p->state[3] << 8) + (p->state[3] >> 4));
    else if (of->channels == 4)
        shown.opacity = model_opacity(p->state[3] << (16 - of->fraction));
    else if (of->rule == RULE_UNDER)
        shown.opacity =
            p->transmittance == 0xFFFFFF ? 0 : model_opacity(model_share(p->transmittance, 16));
    return shown;
}

#endif /* BLEND_MODEL_H */
