#include "blend.h"

/* How a slice meets what is in front of it. */
typedef struct {
    uint32_t before, after; /* transmittances of the pixel on its two sides */
    uint32_t most;          /* light of the opacity, which no colour's passes */
    uint32_t u;
} meeting;

FX_INLINE uint32_t blended(uint32_t state, uint32_t light, const meeting *slice, unsigned fraction)
{
    light = fx_light_within(light, slice->most);
    return fx_front_light(state, light, slice->before, slice->after, slice->u, fraction);
}

/* Section 8.2. Beside the pixel lies its transmittance. */
FX_INLINE void under(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment, uint32_t u,
                     const qv_states *of)
{
    uint32_t most = fx_light_of_colour32(255, fragment->opacity);
    uint32_t before = qv_bytes_read(beside, 3);
    uint32_t after = fx_transmit(before, fragment->opacity);
    const meeting slice = {before, after, most, u};
    uint32_t state[4];
    qv_states_read(state, pixel, 0, of);
    state[0] = blended(state[0], fragment->light[0], &slice, of->fraction);
    state[1] = blended(state[1], fragment->light[1], &slice, of->fraction);
    state[2] = blended(state[2], fragment->light[2], &slice, of->fraction);
    qv_states_write(pixel, 0, state, of);
    qv_bytes_write(beside, 3, after);
}

/* The background comes last, with the read-out. */
FX_INLINE void clear(uint8_t *pixel, uint8_t *beside, const qv_states *of)
{
    static const uint32_t nothing[4] = {0, 0, 0, 0};
    qv_states_write(pixel, 0, nothing, of);
    qv_bytes_write(beside, 3, FX_CLEAR_Q24);
}

FX_INLINE void read(qv_fragment *fragment, const uint8_t *pixel, const uint8_t *beside,
                    const qv_states *of)
{
    uint32_t transmittance = qv_bytes_read(beside, 3);
    uint32_t state[4];
    qv_states_read(state, pixel, 0, of);
    qv_states_fragment(fragment, state, of);
    fragment->opacity = transmittance == FX_CLEAR_Q24
                            ? 0u
                            : fx_opacity_of_level(fx_opaque_share(255, transmittance, 16));
}

#define DEFINE_UNDER(name, bits, pixel_bytes)                                                      \
    static const qv_states name##_states = {3, bits, QV_PLAIN};                                    \
    static void blend_##name(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,         \
                             const qv_moment *moment)                                              \
    {                                                                                              \
        under(pixel, beside, fragment, moment->u, &name##_states);                                 \
    }                                                                                              \
    static void clear_##name(uint8_t *pixel, uint8_t *beside, const qv_fragment *background)       \
    {                                                                                              \
        (void)background;                                                                          \
        clear(pixel, beside, &name##_states);                                                      \
    }                                                                                              \
    static void read_##name(qv_fragment *fragment, const uint8_t *pixel, const uint8_t *beside)    \
    {                                                                                              \
        read(fragment, pixel, beside, &name##_states);                                             \
    }                                                                                              \
    QV_DESCRIPTOR qv_blend qv_under_##name = {                                                     \
        blend_##name, clear_##name, read_##name, 0, pixel_bytes, 3, QV_UNDER};

DEFINE_UNDER(rgb888, 0, 3)
DEFINE_UNDER(rgb16, 8, 6)
DEFINE_UNDER(rgb24, 16, 9)
