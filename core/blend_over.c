#include "blend.h"

/* How a slice meets a pixel. */
typedef struct {
    uint32_t opacity; /* Q0.32 for states of 24 bits, else Q0.23 */
    uint32_t most;    /* light of the opacity, which no colour's passes */
    uint32_t u;
} meeting;

/* A blend is dithered, or rounded, by what its states have left. */
FX_INLINE uint32_t blended(uint32_t state, uint32_t light, const meeting *slice, unsigned fraction)
{
    light = fx_light_within(light, slice->most);
    if (fraction == 16)
        return fx_blend_8_16(state, light, slice->opacity, slice->u);
    return fx_blend_dithered(state, light, slice->opacity, slice->u, fraction);
}

/* Equations 6 and 7, 4 and 8. */
FX_INLINE void over(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment, uint32_t u,
                    const qv_states *of)
{
    int wide = of->fraction == 16;
    uint32_t opacity = wide ? fragment->opacity : fx_opacity_q23(fragment->opacity);
    uint32_t most = wide ? fx_light_of_colour32(255, opacity) : fx_light_of_colour(255, opacity);
    const meeting slice = {opacity, most, u};
    uint32_t state[4];
    qv_states_read(state, pixel, beside, of);
    state[0] = blended(state[0], fragment->light[0], &slice, of->fraction);
    state[1] = blended(state[1], fragment->light[1], &slice, of->fraction);
    state[2] = blended(state[2], fragment->light[2], &slice, of->fraction);
    if (of->channels == 4)
        state[3] = blended(state[3], most, &slice, of->fraction);
    qv_states_write(pixel, beside, state, of);
}

FX_INLINE void clear(uint8_t *pixel, uint8_t *beside, const qv_fragment *background,
                     const qv_states *of)
{
    static const uint32_t nothing[4] = {0, 0, 0, 0};
    qv_states_write(pixel, beside, nothing, of);
    over(pixel, beside, background, FX_NO_DITHER, of);
}

/* Defines a blend of states. A macro because the descriptors are public names. */
#define DEFINE_OVER(name, number, bits, packed, pixel_bytes, beside_bytes)                         \
    static const qv_states name##_states = {number, bits, packed};                                 \
    static void blend_##name(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,         \
                             const qv_moment *moment)                                              \
    {                                                                                              \
        over(pixel, beside, fragment, moment->u, &name##_states);                                  \
    }                                                                                              \
    static void clear_##name(uint8_t *pixel, uint8_t *beside, const qv_fragment *background)       \
    {                                                                                              \
        clear(pixel, beside, background, &name##_states);                                          \
    }                                                                                              \
    static void read_##name(qv_fragment *fragment, const uint8_t *pixel, const uint8_t *beside)    \
    {                                                                                              \
        uint32_t state[4];                                                                         \
        qv_states_read(state, pixel, beside, &name##_states);                                      \
        qv_states_fragment(fragment, state, &name##_states);                                       \
    }                                                                                              \
    QV_DESCRIPTOR qv_blend qv_over_##name = {blend_##name, clear_##name, read_##name, 0,           \
                                             pixel_bytes,  beside_bytes, QV_OVER};

DEFINE_OVER(rgb888, 3, 0, QV_PLAIN, 3, 0)
DEFINE_OVER(rgba8888, 4, 0, QV_PLAIN, 4, 0)
DEFINE_OVER(rgb888_residual4, 3, 4, QV_RESIDUALS, 3, 2)
DEFINE_OVER(rgba8888_residual4, 4, 4, QV_RESIDUALS, 4, 2)
DEFINE_OVER(rgb888_residual8, 3, 8, QV_RESIDUALS, 3, 3)
DEFINE_OVER(rgba8888_residual8, 4, 8, QV_RESIDUALS, 4, 4)
DEFINE_OVER(rgba12, 4, 4, QV_PACKED, 6, 0)
DEFINE_OVER(rgb16, 3, 8, QV_PLAIN, 6, 0)
DEFINE_OVER(rgba16, 4, 8, QV_PLAIN, 8, 0)
DEFINE_OVER(rgb24, 3, 16, QV_PLAIN, 9, 0)
DEFINE_OVER(rgba24, 4, 16, QV_PLAIN, 12, 0)

/* ---- 5 and 6 bits --------------------------------------------------------- */

/* A state of 5 or 6 bits, by the factor of its light. */
FX_INLINE uint32_t blended_narrow(uint32_t state, uint32_t light, const meeting *slice,
                                  uint32_t factor)
{
    light = fx_light_narrow(fx_light_within(light, slice->most), factor);
    return fx_blend_dithered(state, light, slice->opacity, slice->u, 0);
}

static void blend_565(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                      const qv_moment *moment)
{
    uint32_t opacity = fx_opacity_q23(fragment->opacity);
    const meeting slice = {opacity, fx_light_of_colour(255, opacity), moment->u};
    uint32_t state[4];
    (void)beside;
    qv_states_read(state, pixel, 0, &qv_states_565);
    state[0] = blended_narrow(state[0], fragment->light[0], &slice, FX_FACTOR_5);
    state[1] = blended_narrow(state[1], fragment->light[1], &slice, FX_FACTOR_6);
    state[2] = blended_narrow(state[2], fragment->light[2], &slice, FX_FACTOR_5);
    qv_states_write(pixel, 0, state, &qv_states_565);
}

static void clear_565(uint8_t *pixel, uint8_t *beside, const qv_fragment *background)
{
    static const uint32_t nothing[4] = {0, 0, 0, 0};
    const qv_moment rounded = {.u = FX_NO_DITHER};
    qv_states_write(pixel, 0, nothing, &qv_states_565);
    blend_565(pixel, beside, background, &rounded);
}

static void read_565(qv_fragment *fragment, const uint8_t *pixel, const uint8_t *beside)
{
    (void)beside;
    qv_565_read(fragment, pixel);
}

QV_DESCRIPTOR qv_blend qv_over_rgb565 = {blend_565, clear_565, read_565, 0, 2, 0, QV_OVER};
