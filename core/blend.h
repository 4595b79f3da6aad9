/*
 * blend.h - what a slice shows in a pixel, and how a frame buffer keeps pixels.
 *
 * Source: Williams et al., alpha dithering for 8-bit compositing: equations 1, 4 and 6 .. 8.
 */
#ifndef QV_BLEND_H
#define QV_BLEND_H

#include "fx_alpha.h"
#include "fx_blend.h"
#include "ray.h"

/* What a slice, or a picture that stands for slices, shows in one pixel. */
typedef struct qv_fragment {
    uint32_t light[3]; /* associated colour, levels Q8.23; may pass the opacity's by roundings */
    uint32_t opacity;  /* Q0.32, 2^32 - 1 is 1 */
} qv_fragment;

/* How a slice is dithered, in one pixel. */
typedef struct qv_moment {
    uint32_t u;                    /* dither value */
    uint32_t phase;                /* of the slice in the period; of techniques, as alpha is */
    uint32_t slice_u, slice_phase; /* those of pixels that are not shifted */
    fx_alpha alpha;                /* what equation 9 goes by */
    const qv_technique *technique; /* null for blends that want none */
    uint32_t opacity;              /* what it makes of the fragment's: 0 .. 255 */
    int spread;                    /* whether dither differs from pixel to pixel */
} qv_moment;

/* The families of blends. */
enum { QV_OVER = 1, QV_UNDER = 2, QV_HARDWARE = 3, QV_HAND_OUT = 4 };

/* The moment of a slice, without opacity, for pixels that are not shifted against each other.
   Nothing is written on error: QV_ERROR_NULL, QV_ERROR_DITHER, QV_ERROR_SLICE. */
qv_status qv_moment_of(qv_moment *moment, const qv_dither *dither, const qv_blend *blend,
                       int32_t slice);

/* The number that dither knows a slice by. It rises in the order of blending, for which the
   sequences are made: numbered the other way, the seams of bricks are deeper. */
static inline uint32_t qv_slice_number(int32_t slice, int front_to_back)
{
    return (uint32_t)(front_to_back ? QV_GRID_LIMIT + slice : QV_GRID_LIMIT - slice);
}

/* What equation 9 goes by. Nothing is written on error: QV_ERROR_DITHER. */
qv_status qv_alpha_of(fx_alpha *alpha, const qv_dither *dither);

/* The phase of a pixel whose dither values are shifted: over all shifts each as often as any
   other, but for 2^-16. */
static inline uint32_t qv_phase_shifted(const fx_period *period, uint32_t phase, uint32_t shift)
{
    uint32_t shifted = phase + (((shift >> 16) * period->slices) >> 16); /* < 2 slices */
    return shifted < period->slices ? shifted : shifted - period->slices;
}

/* What a pixel's dither value is more than that of its slice. It grows by qv_dither_step from a
   pixel to that on its right. */
static inline uint32_t qv_dither_shift(int spread, int32_t x, int32_t y)
{
    return spread ? fx_dither_at(0, (uint32_t)x, (uint32_t)y, 0) : 0;
}

static inline uint32_t qv_dither_step(int spread)
{
    return spread ? FX_LATTICE_X : 0;
}

/* Shifts the moment of a slice to a pixel of dither value u. */
static inline void qv_moment_at(qv_moment *moment, uint32_t u)
{
    moment->u = u;
    if (moment->technique)
        moment->phase =
            qv_phase_shifted(&moment->alpha.period, moment->slice_phase, u - moment->slice_u);
}

/* Finds the opacity of a moment with a technique, for a fragment in front of a pixel. */
void qv_moment_opacity(qv_moment *moment, const qv_blend *blend, const uint8_t *pixel,
                       const qv_fragment *fragment);

/* ---- States in memory ------------------------------------------------------- */

/* How the states of a pixel's channels lie in memory. */
typedef enum {
    QV_PLAIN,     /* whole bytes, lowest first */
    QV_PACKED,    /* 12 bits each */
    QV_RESIDUALS, /* levels, and beside them residuals */
    QV_565
} qv_packing;

typedef struct qv_states {
    unsigned channels; /* 3, or 4 with the opacity */
    unsigned fraction; /* bits of a state beyond the level's 8 */
    qv_packing packing;
} qv_states;

/* A state of 8, 16 or 24 bits. */
FX_INLINE uint32_t qv_bytes_read(const uint8_t *at, unsigned bytes)
{
    uint32_t v = at[0];
    if (bytes > 1)
        v |= (uint32_t)at[1] << 8;
    if (bytes > 2)
        v |= (uint32_t)at[2] << 16;
    return v;
}

FX_INLINE void qv_bytes_write(uint8_t *at, unsigned bytes, uint32_t v)
{
    at[0] = (uint8_t)(v & 0xFFu);
    if (bytes > 1)
        at[1] = (uint8_t)(v >> 8 & 0xFFu);
    if (bytes > 2)
        at[2] = (uint8_t)(v >> 16);
}

/* Residual c of a pixel, two's complement: 8 bits each, or 4, of which the first lie lowest. */
FX_INLINE int32_t qv_residual_read(const uint8_t *beside, unsigned c, unsigned fraction)
{
    uint32_t v = fraction == 8 ? beside[c] : qv_bytes_read(beside, 2) >> 4u * c & 15u;
    uint32_t half = (uint32_t)1 << (fraction - 1u);
    return (int32_t)(v ^ half) - (int32_t)half;
}

/* A pixel's residuals of 4 bits: the lowest bits of its states. */
FX_INLINE void qv_residuals4_write(uint8_t *beside, const uint32_t state[4], unsigned channels)
{
    uint32_t last = channels == 4 ? state[3] & 15u : 0u;
    qv_bytes_write(beside, 2,
                   (state[0] & 15u) | (state[1] & 15u) << 4 | (state[2] & 15u) << 8 | last << 12);
}

/*
 * Channel c of states that are not packed. Nothing here and below loops over the channels of a
 * state: compilers that leave such a loop a loop keep the states in memory, at twice the cost.
 */
FX_INLINE uint32_t qv_channel_read(const uint8_t *pixel, const uint8_t *beside, unsigned c,
                                   const qv_states *of)
{
    unsigned bytes = 1u + of->fraction / 8u;
    if (of->packing == QV_RESIDUALS)
        return fx_state_of(pixel[c], qv_residual_read(beside, c, of->fraction), of->fraction);
    return qv_bytes_read(pixel + bytes * c, bytes);
}

/* Residuals of 8 bits with it; those of 4 bits lie in bytes that channels share. */
FX_INLINE void qv_channel_write(uint8_t *pixel, uint8_t *beside, unsigned c, uint32_t state,
                                const qv_states *of)
{
    unsigned bytes = 1u + of->fraction / 8u;
    if (of->packing == QV_RESIDUALS)
        pixel[c] = (uint8_t)fx_level_of(state, of->fraction);
    else
        qv_bytes_write(pixel + bytes * c, bytes, state);
    if (of->packing == QV_RESIDUALS && of->fraction == 8)
        beside[c] = (uint8_t)(state & 0xFFu);
}

FX_INLINE void qv_states_read(uint32_t state[4], const uint8_t *pixel, const uint8_t *beside,
                              const qv_states *of)
{
    if (of->packing == QV_565) {
        uint32_t v = qv_bytes_read(pixel, 2);
        state[0] = v >> 11;
        state[1] = v >> 5 & 63u;
        state[2] = v & 31u;
    } else if (of->packing == QV_PACKED) {
        uint32_t low = qv_bytes_read(pixel, 3), high = qv_bytes_read(pixel + 3, 3);
        state[0] = low & 0xFFFu;
        state[1] = low >> 12;
        state[2] = high & 0xFFFu;
        state[3] = high >> 12;
    } else {
        state[0] = qv_channel_read(pixel, beside, 0, of);
        state[1] = qv_channel_read(pixel, beside, 1, of);
        state[2] = qv_channel_read(pixel, beside, 2, of);
        if (of->channels == 4)
            state[3] = qv_channel_read(pixel, beside, 3, of);
    }
}

FX_INLINE void qv_states_write(uint8_t *pixel, uint8_t *beside, const uint32_t state[4],
                               const qv_states *of)
{
    if (of->packing == QV_565) {
        qv_bytes_write(pixel, 2, state[0] << 11 | state[1] << 5 | state[2]);
    } else if (of->packing == QV_PACKED) {
        qv_bytes_write(pixel, 3, state[0] | state[1] << 12);
        qv_bytes_write(pixel + 3, 3, state[2] | state[3] << 12);
    } else {
        qv_channel_write(pixel, beside, 0, state[0], of);
        qv_channel_write(pixel, beside, 1, state[1], of);
        qv_channel_write(pixel, beside, 2, state[2], of);
        if (of->channels == 4)
            qv_channel_write(pixel, beside, 3, state[3], of);
        if (of->packing == QV_RESIDUALS && of->fraction == 4)
            qv_residuals4_write(beside, state, of->channels);
    }
}

/* States back to a fragment. Three channels hide what is behind. */
FX_INLINE void qv_states_fragment(qv_fragment *fragment, const uint32_t state[4],
                                  const qv_states *of)
{
    for (unsigned c = 0; c < 3; c++)
        fragment->light[c] = state[c] << (23u - of->fraction); /* <= 255 * 2^23 */
    fragment->opacity =
        of->channels == 4 ? fx_opacity_of_level(state[3] << (16u - of->fraction)) : 0xFFFFFFFFu;
}

/* A state of 5 or 6 bits as light, to nearest. */
FX_INLINE uint32_t qv_light_of_narrow(uint32_t state, uint32_t full)
{
    return (uint32_t)fx_divide(fx_wide_product(state, FX_LIGHT_ONE) + full / 2u, full);
}

static const qv_states qv_states_565 = {3, 0, QV_565};

/* What a pixel of 5 and 6 bits shows. */
FX_INLINE void qv_565_read(qv_fragment *fragment, const uint8_t *pixel)
{
    uint32_t state[4];
    qv_states_read(state, pixel, 0, &qv_states_565);
    fragment->light[0] = qv_light_of_narrow(state[0], 31);
    fragment->light[1] = qv_light_of_narrow(state[1], 63);
    fragment->light[2] = qv_light_of_narrow(state[2], 31);
    fragment->opacity = 0xFFFFFFFFu;
}

#endif /* QV_BLEND_H */
