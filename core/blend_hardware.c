#include "blend.h"

#define COLOUR12 269422351u /* 4095 * 2^32 / 65280, to nearest */

/* A slice as hardware is given it: 0 .. 255 each. */
typedef struct {
    uint32_t colour[3]; /* not weighted */
    uint32_t opacity;   /* of the technique */
} ready;

/*
 * The colour that, weighted by an opacity in Q0.23 above 0, is a light: 8 bits and a fraction
 * of up to 8, to nearest, ties upwards, by shift and subtract; at most 255. light <= 255 *
 * opacity: so rest stays below opacity << bit + 1 <= 2^31, and later below 2^24.
 */
static uint32_t colour_of(uint32_t light, uint32_t opacity, unsigned fraction)
{
    uint32_t rest = light, colour = 0;
    for (unsigned bit = 8; bit-- != 0;) {
        colour <<= 1;
        if (rest >= opacity << bit) {
            rest -= opacity << bit;
            colour |= 1u;
        }
    }
    for (unsigned i = 0; i <= fraction; i++) { /* a bit more than asked for, to round by */
        rest <<= 1;
        colour <<= 1;
        if (rest >= opacity) {
            rest -= opacity;
            colour |= 1u;
        }
    }
    return (colour + 1u) >> 1;
}

/* The slice's colours, of which the largest is returned. */
static unsigned colours_of(uint32_t colour[3], const qv_fragment *fragment, uint32_t opacity,
                           unsigned fraction)
{
    uint32_t most = fx_light_of_colour(255, opacity);
    unsigned largest = 0;
    for (unsigned c = 0; c < 3; c++) {
        uint32_t light = fragment->light[c] < most ? fragment->light[c] : most;
        colour[c] = colour_of(light, opacity, fraction);
        if (colour[c] > colour[largest])
            largest = c;
    }
    return largest;
}

/* The opacity in levels with 16 fraction bits: 2^32 - 1 is 255 * 65536. */
static uint32_t level_of(uint32_t opacity)
{
    return fx_high_product(opacity, (uint32_t)255 << 16);
}

/*
 * Makes the slice ready; the states, of 8 bits, tell the technique what a pixel has
 * accumulated. Returns 0 where it adds nothing.
 */
static int make_ready(ready *slice, const qv_fragment *fragment, const qv_moment *moment,
                      const uint32_t state[], unsigned channels)
{
    uint32_t opacity = fx_opacity_q23(fragment->opacity);
    if (opacity == 0)
        return 0;
    unsigned largest = colours_of(slice->colour, fragment, opacity, 0);
    uint32_t value = channels == 4 ? state[3] : state[largest];
    uint32_t colour = channels == 4 ? 255u : slice->colour[largest];
    slice->opacity = moment->technique(moment, level_of(fragment->opacity), value, colour);
    return slice->opacity != 0;
}

/* Section 5: colours weighted by the dithered opacity. */
static uint32_t associated(const ready *slice, unsigned c)
{
    return fx_divide_by_ones(slice->colour[c] * slice->opacity, 8);
}

/* A picture of bytes: R, G, B, and where there are four channels the opacity. */
FX_INLINE void read_levels(qv_fragment *fragment, const uint8_t *pixel, unsigned channels)
{
    for (unsigned c = 0; c < 3; c++)
        fragment->light[c] = (uint32_t)pixel[c] << 23;
    fragment->opacity = channels == 4 ? fx_opacity_of_level((uint32_t)pixel[3] << 16) : 0xFFFFFFFFu;
}

/* ---- 8 bits --------------------------------------------------------------- */

/* Equation 1. */
static void blend_rgb888(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                         const qv_moment *moment)
{
    uint32_t state[3] = {pixel[0], pixel[1], pixel[2]};
    ready slice;
    (void)beside;
    if (!make_ready(&slice, fragment, moment, state, 3))
        return;
    for (unsigned c = 0; c < 3; c++)
        pixel[c] = (uint8_t)fx_blend_plain(state[c], slice.colour[c], slice.opacity, 8);
}

/* Equations 6 and 7. */
static void blend_rgba8888(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                           const qv_moment *moment)
{
    uint32_t state[4] = {pixel[0], pixel[1], pixel[2], pixel[3]};
    ready slice;
    (void)beside;
    if (!make_ready(&slice, fragment, moment, state, 4))
        return;
    for (unsigned c = 0; c < 3; c++)
        pixel[c] = (uint8_t)fx_blend_associated(state[c], associated(&slice, c), slice.opacity, 8);
    pixel[3] = (uint8_t)fx_blend_associated(state[3], slice.opacity, slice.opacity, 8);
}

/* The slice itself; no pixel's value is known. */
static void hand_out(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                     const qv_moment *moment)
{
    static const uint32_t unknown[4] = {0, 0, 0, 0};
    ready slice = {{0, 0, 0}, 0};
    (void)beside;
    make_ready(&slice, fragment, moment, unknown, 4);
    for (unsigned c = 0; c < 3; c++)
        pixel[c] = (uint8_t)associated(&slice, c);
    pixel[3] = (uint8_t)slice.opacity;
}

static void round_light(uint8_t *pixel, const qv_fragment *background, unsigned channels)
{
    for (unsigned c = 0; c < 3; c++)
        pixel[c] = (uint8_t)((background->light[c] + FX_ONE_Q23 / 2) >> 23);
    if (channels == 4)
        pixel[3] = (uint8_t)fx_alpha_rounded(level_of(background->opacity));
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

const qv_blend qv_hardware_rgb888 = {blend_rgb888, clear_rgb888, read_rgb888, 3, 0, QV_HARDWARE};
const qv_blend qv_hardware_rgba8888 = {blend_rgba8888, clear_rgba8888, read_rgba8888, 4, 0,
                                       QV_HARDWARE};
const qv_blend qv_hand_out_rgba8888 = {hand_out, clear_rgba8888, read_rgba8888, 4, 0, QV_HAND_OUT};

/* ---- 5 and 6 bits, and 12 ------------------------------------------------- */

static const qv_states states_565 = {3, 0, QV_565};
static const qv_states states_12 = {4, 4, QV_PACKED};

/* 8 bits to 5 or 6, to nearest. */
static uint32_t narrowed(uint32_t colour, uint32_t full)
{
    return fx_divide_by_ones(colour * full, 8);
}

/* Equation 1, of opacities of 8 bits. */
static void blend_565(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                      const qv_moment *moment)
{
    static const uint32_t full[3] = {31, 63, 31};
    uint32_t state[4], level[3];
    ready slice;
    (void)beside;
    qv_states_read(state, pixel, 0, &states_565);
    for (unsigned c = 0; c < 3; c++) /* as displays do: the highest bits again below */
        level[c] = full[c] == 31 ? state[c] << 3 | state[c] >> 2 : state[c] << 2 | state[c] >> 4;
    if (!make_ready(&slice, fragment, moment, level, 3))
        return;
    for (unsigned c = 0; c < 3; c++)
        state[c] = fx_blend_plain(state[c], narrowed(slice.colour[c], full[c]), slice.opacity, 8);
    qv_states_write(pixel, 0, state, &states_565);
}

static void clear_565(uint8_t *pixel, uint8_t *beside, const qv_fragment *background)
{
    uint8_t level[3];
    (void)beside;
    round_light(level, background, 3);
    const uint32_t state[4] = {narrowed(level[0], 31), narrowed(level[1], 63),
                               narrowed(level[2], 31), 0};
    qv_states_write(pixel, 0, state, &states_565);
}

static void read_565(qv_fragment *fragment, const uint8_t *pixel, const uint8_t *beside)
{
    uint32_t state[4];
    (void)beside;
    qv_states_read(state, pixel, 0, &states_565);
    qv_fragment_of_565(fragment, state);
}

const qv_blend qv_hardware_rgb565 = {blend_565, clear_565, read_565, 2, 0, QV_HARDWARE};

/* Levels with 8 fraction bits, at most 65280, to 4095, to nearest. */
static uint32_t unorm12(uint32_t level)
{
    return fx_high_product(level, COLOUR12);
}

/* Equations 6 and 7 with opacities of 12 bits. */
static void blend_12(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                     const qv_moment *moment)
{
    uint32_t wide = fx_high_product(fragment->opacity, (uint32_t)4095 << 16);
    uint32_t opacity = (wide + 32768u) >> 16, part = fx_opacity_q23(fragment->opacity);
    uint32_t state[4], colour[3];
    (void)beside;
    (void)moment;
    if (opacity == 0)
        return;
    qv_states_read(state, pixel, 0, &states_12);
    colours_of(colour, fragment, part, 8);
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
    for (unsigned c = 0; c < 3; c++)
        state[c] = unorm12((background->light[c] + 0x4000u) >> 15);
    state[3] = unorm12((level_of(background->opacity) + 128u) >> 8);
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

const qv_blend qv_hardware_rgba12 = {blend_12, clear_12, read_12, 6, 0, QV_HARDWARE};
