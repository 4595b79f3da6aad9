#include "blend.h"

#define ONE_IN_272 15790321u  /* 15 / 4080, Q0.32 */
#define COLOUR12   269422351u /* 4095 * 2^32 / 65280, to nearest */

/*
 * The colour that, weighted by an opacity in Q0.23 above 0, is a light: 8 bits and a fraction
 * of up to 8, to nearest, ties upwards, by shift and subtract; at most 255. light <= 255 *
 * opacity: so rest stays below twice the divisor, that is 2^31.
 */
static uint32_t colour_of(uint32_t light, uint32_t opacity, unsigned fraction)
{
    uint32_t rest = light, divisor = opacity << 7, colour = 0;
    for (unsigned bits = 9 + fraction; bits != 0; bits--) { /* the last to round by */
        colour <<= 1;
        if (rest >= divisor) {
            rest -= divisor;
            colour |= 1u;
        }
        rest <<= 1;
    }
    return (colour + 1u) >> 1;
}

/* The slice's colours. */
static void colours_of(uint32_t colour[3], const qv_fragment *fragment, unsigned fraction)
{
    uint32_t opacity = fx_opacity_q23(fragment->opacity);
    uint32_t most = fx_light_of_colour(255, opacity);
    for (unsigned c = 0; c < 3; c++) {
        uint32_t light = fx_light_within(fragment->light[c], most);
        colour[c] = opacity == 0 ? 0 : colour_of(light, opacity, fraction);
    }
}

/* The largest of the slice's colours, and the level that stands there. */
static void look_at_colours(uint32_t *value, uint32_t *colour, const uint32_t level[3],
                            const qv_fragment *fragment)
{
    uint32_t all[3];
    unsigned largest = 0;
    colours_of(all, fragment, 0);
    for (unsigned c = 1; c < 3; c++)
        if (all[c] > all[largest])
            largest = c;
    *value = level[largest];
    *colour = all[largest];
}

/* Section 5: a colour weighted by the dithered opacity. */
static uint32_t associated(uint32_t colour, uint32_t opacity)
{
    return fx_divide_by_ones(colour * opacity, 8);
}

/* A picture of bytes: R, G, B, and where there are four channels the opacity. */
FX_INLINE void read_levels(qv_fragment *fragment, const uint8_t *pixel, unsigned channels)
{
    for (unsigned c = 0; c < 3; c++)
        fragment->light[c] = (uint32_t)pixel[c] << 23;
    fragment->opacity = channels == 4 ? fx_opacity_of_level((uint32_t)pixel[3] << 16) : 0xFFFFFFFFu;
}

/* ---- 8 bits --------------------------------------------------------------- */

static void look_rgb888(uint32_t *value, uint32_t *colour, const uint8_t *pixel,
                        const qv_fragment *fragment)
{
    const uint32_t level[3] = {pixel[0], pixel[1], pixel[2]};
    look_at_colours(value, colour, level, fragment);
}

/* Equation 1. */
static void blend_rgb888(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                         const qv_moment *moment)
{
    uint32_t colour[3];
    (void)beside;
    if (moment->opacity == 0)
        return;
    colours_of(colour, fragment, 0);
    for (unsigned c = 0; c < 3; c++)
        pixel[c] = (uint8_t)fx_blend_plain(pixel[c], colour[c], moment->opacity, 8);
}

/* The opacity is what has accumulated; where it is full, as over an opaque background, the
   colours tell. */
static void look_rgba8888(uint32_t *value, uint32_t *colour, const uint8_t *pixel,
                          const qv_fragment *fragment)
{
    *value = pixel[3];
    *colour = 255;
    if (pixel[3] == 255)
        look_rgb888(value, colour, pixel, fragment);
}

/* Equations 6 and 7. */
static void blend_rgba8888(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                           const qv_moment *moment)
{
    uint32_t colour[4], opacity = moment->opacity;
    (void)beside;
    if (opacity == 0)
        return;
    colours_of(colour, fragment, 0);
    colour[3] = 255;
    for (unsigned c = 0; c < 4; c++)
        pixel[c] =
            (uint8_t)fx_blend_associated(pixel[c], associated(colour[c], opacity), opacity, 8);
}

/* No pixel's value is known: that of nothing. */
static void look_nowhere(uint32_t *value, uint32_t *colour, const uint8_t *pixel,
                         const qv_fragment *fragment)
{
    (void)pixel;
    (void)fragment;
    *value = 0;
    *colour = 255;
}

/* The slice itself. */
static void hand_out(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                     const qv_moment *moment)
{
    uint32_t colour[3];
    (void)beside;
    colours_of(colour, fragment, 0);
    for (unsigned c = 0; c < 3; c++)
        pixel[c] = (uint8_t)associated(colour[c], moment->opacity);
    pixel[3] = (uint8_t)moment->opacity;
}

/* An opacity on 0 .. full, to nearest. */
static uint32_t level_of(uint32_t opacity, uint32_t full)
{
    return (fx_high_product(opacity, full << 16) + 0x8000u) >> 16;
}

static void round_light(uint8_t *pixel, const qv_fragment *background, unsigned channels)
{
    for (unsigned c = 0; c < 3; c++)
        pixel[c] = (uint8_t)((background->light[c] + FX_ONE_Q23 / 2) >> 23);
    if (channels == 4)
        pixel[3] = (uint8_t)level_of(background->opacity, 255);
}

static void clear_rgb888(uint8_t *pixel, uint8_t *beside, const qv_fragment *background)
{
    (void)beside;
    round_light(pixel, background, 3);
}

static void clear_rgba8888(uint8_t *pixel, uint8_t *beside, const qv_fragment *background)
{
    (void)beside;
    round_light(pixel, background, 4);
}

static void read_rgb888(qv_fragment *fragment, const uint8_t *pixel, const uint8_t *beside)
{
    (void)beside;
    read_levels(fragment, pixel, 3);
}

static void read_rgba8888(qv_fragment *fragment, const uint8_t *pixel, const uint8_t *beside)
{
    (void)beside;
    read_levels(fragment, pixel, 4);
}

QV_DESCRIPTOR qv_blend qv_hardware_rgb888 = {
    blend_rgb888, clear_rgb888, read_rgb888, look_rgb888, 3, 0, QV_HARDWARE};
QV_DESCRIPTOR qv_blend qv_hardware_rgba8888 = {
    blend_rgba8888, clear_rgba8888, read_rgba8888, look_rgba8888, 4, 0, QV_HARDWARE};
QV_DESCRIPTOR qv_blend qv_hand_out_rgba8888 = {
    hand_out, clear_rgba8888, read_rgba8888, look_nowhere, 4, 0, QV_HAND_OUT};

/* ---- 5 and 6 bits, and 12 ------------------------------------------------- */

static const qv_states states_12 = {4, 4, QV_PACKED};

/* 8 bits to 5 or 6, to nearest. */
static uint32_t narrowed(uint32_t colour, uint32_t full)
{
    return fx_divide_by_ones(colour * full, 8);
}

/* As displays widen them: the highest bits again below. */
static void look_565(uint32_t *value, uint32_t *colour, const uint8_t *pixel,
                     const qv_fragment *fragment)
{
    uint32_t state[4];
    qv_states_read(state, pixel, 0, &qv_states_565);
    const uint32_t level[3] = {state[0] << 3 | state[0] >> 2, state[1] << 2 | state[1] >> 4,
                               state[2] << 3 | state[2] >> 2};
    look_at_colours(value, colour, level, fragment);
}

/* Equation 1, of opacities of 8 bits. */
static void blend_565(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                      const qv_moment *moment)
{
    uint32_t state[4], colour[3];
    (void)beside;
    if (moment->opacity == 0)
        return;
    qv_states_read(state, pixel, 0, &qv_states_565);
    colours_of(colour, fragment, 0);
    for (unsigned c = 0; c < 3; c++)
        state[c] =
            fx_blend_plain(state[c], narrowed(colour[c], c == 1 ? 63 : 31), moment->opacity, 8);
    qv_states_write(pixel, 0, state, &qv_states_565);
}

static void clear_565(uint8_t *pixel, uint8_t *beside, const qv_fragment *background)
{
    uint32_t state[4];
    (void)beside;
    for (unsigned c = 0; c < 3; c++) {
        uint32_t factor = c == 1 ? FX_FACTOR_6 : FX_FACTOR_5;
        state[c] = (fx_light_narrow(background->light[c], factor) + FX_ONE_Q23 / 2) >> 23;
    }
    qv_states_write(pixel, 0, state, &qv_states_565);
}

static void read_565(qv_fragment *fragment, const uint8_t *pixel, const uint8_t *beside)
{
    (void)beside;
    qv_565_read(fragment, pixel);
}

QV_DESCRIPTOR qv_blend qv_hardware_rgb565 = {blend_565, clear_565, read_565,   look_565,
                                             2,         0,         QV_HARDWARE};

/* Levels with 8 fraction bits, at most 65280, to 4095, to nearest. */
static uint32_t unorm12(uint32_t level)
{
    return fx_high_product(level, COLOUR12);
}

/* Equations 6 and 7 with opacities of 12 bits. */
static void blend_12(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                     const qv_moment *moment)
{
    uint32_t opacity = level_of(fragment->opacity, 4095);
    uint32_t state[4], colour[3];
    (void)beside;
    (void)moment;
    if (opacity == 0)
        return;
    qv_states_read(state, pixel, 0, &states_12);
    colours_of(colour, fragment, 8);
    for (unsigned c = 0; c < 3; c++) {
        uint32_t weighted = fx_divide_by_ones(unorm12(colour[c]) * opacity, 12);
        state[c] = fx_blend_associated(state[c], weighted, opacity, 12);
    }
    state[3] = fx_blend_associated(state[3], opacity, opacity, 12);
    qv_states_write(pixel, 0, state, &states_12);
}

static void clear_12(uint8_t *pixel, uint8_t *beside, const qv_fragment *background)
{
    uint32_t state[4];
    (void)beside;
    for (unsigned c = 0; c < 3; c++) {
        /* 4095 / 255 = 16 + 16 * 15 / 4080: in 2^-19 of a unit, at most 4095 * 2^19 */
        uint32_t light = background->light[c];
        state[c] = (light + fx_high_product(light, ONE_IN_272) + ((uint32_t)1 << 18)) >> 19;
    }
    state[3] = level_of(background->opacity, 4095);
    qv_states_write(pixel, 0, state, &states_12);
}

static void read_12(qv_fragment *fragment, const uint8_t *pixel, const uint8_t *beside)
{
    uint32_t state[4];
    (void)beside;
    qv_states_read(state, pixel, 0, &states_12);
    for (unsigned c = 0; c < 3; c++)
        fragment->light[c] = qv_light_of_narrow(state[c], 4095);
    fragment->opacity =
        (state[3] << 20) + (state[3] << 8) + (state[3] >> 4); /* 2^32 / 4095, at most 1 low */
}

QV_DESCRIPTOR qv_blend qv_hardware_rgba12 = {blend_12, clear_12, read_12, 0, 6, 0, QV_HARDWARE};
