/*
 * fx_blend.h - one channel of a pixel that stays in a frame buffer, blended with slice
 * after slice.
 *
 * Source: Williams et al., alpha dithering for 8-bit compositing: equations 1, 4 and 6 .. 8,
 * section 2.1 (blends of n bits) and section 8.2 (front to back).
 *
 * State     what the frame buffer holds: 5, 6, 8 or 12 bits of which all ones are 1, or
 *           8-bit levels with f fraction bits ("8.f": 255 * 2^f is 1) for f = 4, 8, 16.
 * Level     8 bits, 255 is 1; what is shown of a state.
 * Opacity   Q0.32, 2^32 - 1 is 1, as sampling gives it; or Q0.23, 2^23 is 1.
 * Light     associated colour (weighted by opacity) of a slice: levels Q8.23, 0 .. 255 *
 *           2^23. A pixel's opacity is a channel like the others, whose light is that of
 *           colour 255 (equation 7 is equation 6 with a colour of 1).
 * u         dither value (fx_dither.h), the same for all channels of a pixel and slice.
 *
 * All is unsigned arithmetic of 32 bits without a division; each intermediate's bound
 * stands beside it. The blends back to front that take light share four facts, which are
 * proved beside them; A is the opacity:
 *
 *   monotone   The result never falls as state or light rises. So, by induction, a channel
 *              whose light never exceeds that of another is never above it: no colour above
 *              the opacity, and grey stays grey.
 *   fixed      A state that is a level c stays so for the light c * A, whatever u. With
 *              the first fact: states stay between two levels that all colours lie
 *              between, and so within 0 .. 255.
 *   clear      Opacity 0, without light, changes nothing.
 *   opaque     Opacity 1 leaves nothing of the state.
 */
#ifndef FX_BLEND_H
#define FX_BLEND_H

#include "fx_inline.h"
#include "fx_wide.h"

#define FX_NO_DITHER 0x80000000u /* u = 1/2: rounds to nearest */
#define FX_ONE_Q23   0x00800000u
#define FX_LIGHT_ONE 0x7F800000u /* 255 * 2^23 */

/* ---- Opacity and light ---------------------------------------------------- */

/* Q0.32 to Q0.23, to nearest, ties upwards: 2^32 - 1 is 2^23, exactly 1. */
static inline uint32_t fx_opacity_q23(uint32_t opacity32)
{
    return (opacity32 >> 9) + ((opacity32 >> 8) & 1u);
}

/* The opacity, Q0.32, of a level with 16 fraction bits, 0 .. 255 * 65536; at most 3 units of
   2^-32 low, and 2^32 - 1 for 1. 2^16 / 255 = 257 + 1/255, 1/255 = 2^-8 + 2^-16 + ... */
static inline uint32_t fx_opacity_of_level(uint32_t level)
{
    return level * 257u + (level >> 8) + (level >> 16);
}

/* The light of a level of colour at an opacity in Q0.23, exact: at most 255 * 2^23. With
   colour 255 that of the opacity channel. */
static inline uint32_t fx_light_of_colour(uint32_t colour, uint32_t opacity)
{
    return colour * opacity;
}

/* The same for an opacity in Q0.32, to nearest; colour is 0 .. 255. */
static inline uint32_t fx_light_of_colour32(uint32_t colour, uint32_t opacity32)
{
    return fx_high_product(opacity32, colour << 23);
}

/*
 * The light of an associated colour in another unit, v / one: factor is 255 * 2^54 / one to
 * nearest, for one above 255 * 2^22, so that it is below 2^32. At most 1.5 units off.
 */
static inline uint32_t fx_light_of(uint32_t v, uint32_t factor)
{
    return 2u * fx_high_product(v, factor); /* v <= one + 2^22: the product is below 2^30 */
}

/* The same, limited to the opacity channel's light, which roundings may have passed. */
static inline uint32_t fx_light_within(uint32_t light, uint32_t opacity_light)
{
    return light < opacity_light ? light : opacity_light;
}

/*
 * Light for a state of 5 or 6 bits, `full` 31 or 63 in place of 255: light * full / 255 to
 * nearest. That of the opacity channel is exactly full * A, since the factor's error times
 * 255 * 2^23 is below 1/2: the facts above hold for these states too.
 */
#define FX_FACTOR_5 522133279u  /* 31 * 2^32 / 255, less .5 */
#define FX_FACTOR_6 1061109568u /* 63 * 2^32 / 255, and .06 */

static inline uint32_t fx_light_narrow(uint32_t light, uint32_t factor)
{
    return fx_high_product(light, factor);
}

/* ---- Plain blends, rounded ------------------------------------------------ */

/* round(x / (2^bits - 1)) for x <= (2^bits - 1)^2, bits 5 .. 12; no ties, as the divisor is
   odd. 1 / (2^b - 1) = 2^-b + 2^-2b + ..., of which two terms decide; tests/ proves it. */
FX_INLINE uint32_t fx_divide_by_ones(uint32_t x, unsigned bits)
{
    uint32_t t = x + ((uint32_t)1 << (bits - 1u));
    return (t + (t >> bits)) >> bits;
}

/*
 * Equation 1 rounded to nearest, as blending hardware of few bits has it; for 8 bits (2 (c A +
 * (255 - A) S) + 255) / 510. The opacity has 5, 6, 8 or 12 bits, 2^bits - 1 being 1; state
 * and colour have as many bits or fewer, both alike. Off by at most 1/2 a slice, but it
 * stops below its aim: fx_plateau.
 */
FX_INLINE uint32_t fx_blend_plain(uint32_t state, uint32_t colour, uint32_t opacity, unsigned bits)
{
    uint32_t rest = ((uint32_t)1 << bits) - 1u - opacity;
    return fx_divide_by_ones(colour * opacity + rest * state, bits);
}

/*
 * Equations 6 and 7, and 8 for two images, near over far: the same of a colour that is
 * associated already, at most the opacity; then the result is at most all ones, as
 * colour + rest is.
 */
FX_INLINE uint32_t fx_blend_associated(uint32_t state, uint32_t colour, uint32_t opacity,
                                       unsigned bits)
{
    uint32_t rest = ((uint32_t)1 << bits) - 1u - opacity;
    return colour + fx_divide_by_ones(rest * state, bits);
}

/* ---- Dithered blends, back to front ---------------------------------------- */

/*
 * Equations 6 and 7 by an opacity in Q0.23, rounded by dither: state + light - A * state,
 * plus u of a unit, cut. For states of 8 bits (fraction 0), 8.4 and 8.8 (fraction 4, 8); with
 * fx_light_narrow also of 5 and 6 bits (fraction 0). It is the floor or the ceiling of the exact
 * result; its mean over all u is the exact result for fraction 0, else less than 2^(f-23) of a
 * unit below.
 *
 * With B = 1 - A it is floor((light + floor(B state / 2^f) + floor(u / 2^(9+f))) / 2^(23-f)),
 * B times the whole and the fraction taken apart: each term is monotone. light <= 255 A and
 * state <= 255 * 2^f bound the sum by 255 * 2^23 + 2^(23-f) - 1 < 2^31. For state c * 2^f and
 * light c A the first two sum up to c 2^23, which u does not carry over: fixed.
 */
FX_INLINE uint32_t fx_blend_dithered(uint32_t state, uint32_t light, uint32_t opacity, uint32_t u,
                                     unsigned fraction)
{
    uint32_t rest = FX_ONE_Q23 - opacity;
    uint32_t part = state & (((uint32_t)1 << fraction) - 1u);
    uint32_t kept = rest * (state >> fraction) + ((rest * part) >> fraction); /* part < 2^8 */
    uint32_t sum = light + kept + (u >> (9u + fraction));
    return 2u * sum >> (24u - fraction); /* whole bytes: machines of 8 bits need not shift */
}

/*
 * The same for states of 8.16 by an opacity in Q0.32. u = FX_NO_DITHER rounds to nearest, off
 * by at most 1/2 + 2^-7 of a unit, 2^-17 of a level, a slice: dither gains nothing here.
 *
 * In units of 2^-24: kept <= 255 * 2^24, and with twice the light the sum is at most 255 *
 * 2^24 + 2, below 2^32 - 253. v - round(v A) is monotone in v as A < 1. For level c both
 * roundings, of A c here and of light, together are off by at most 3/2 of these units, which
 * 2 .. 253 more, of 256, do not show. Opacity 2^32 - 1 leaves at most 1 of them, which does not
 * show either, and opacity 0 leaves all.
 */
static inline uint32_t fx_blend_8_16(uint32_t state, uint32_t light, uint32_t opacity32, uint32_t u)
{
    uint32_t kept = state << 8;
    uint32_t dither = 2u + (((u >> 24) * 252u) >> 8); /* 2 .. 253, and 128 for FX_NO_DITHER */
    kept -= fx_high_product(kept, opacity32);
    return (kept + 2u * light + dither) >> 8;
}

/* ---- Front to back --------------------------------------------------------- */

/*
 * Section 8.2. A pixel keeps its transmittance, 24 bits: Q0.24, of which 2^24 would be 1, and
 * which starts 1 unit below, so that it fits.
 */
#define FX_CLEAR_Q24 0x00FFFFFFu

/* transmittance * (1 - opacity), to nearest; opacity in Q0.32. Monotone in both; opacity 0
   changes nothing, 2^32 - 1 leaves 0. Off by at most 1/2 + 2^-7 of a unit. */
static inline uint32_t fx_transmit(uint32_t transmittance, uint32_t opacity32)
{
    uint32_t kept = transmittance << 8; /* below 2^32 - 255 */
    kept -= fx_high_product(kept, opacity32);
    return (kept + 128u) >> 8;
}

/*
 * What a medium of one colour, 0 .. 255, shows of itself where it lets the transmittance
 * through: round(colour * (1 - transmittance)), ties upwards, as a state with fraction 0 ..
 * 16 bits. With colour 255 the pixel's opacity. At most 255 * 2^24 + 2^23 < 2^32.
 */
FX_INLINE uint32_t fx_opaque_share(uint32_t colour, uint32_t transmittance, unsigned fraction)
{
    uint32_t opaque = ((uint32_t)1 << 24) - transmittance;
    return (colour * opaque + ((uint32_t)1 << (23u - fraction))) >> (24u - fraction);
}

/* A state, limited to the pixel's opacity: roundings of several colours may sum up. */
FX_INLINE uint32_t fx_below_opacity(uint32_t state, uint32_t transmittance, unsigned fraction)
{
    uint32_t most = fx_opaque_share(255u, transmittance, fraction);
    return state < most ? state : most;
}

/*
 * A slice of a colour that is not weighted, 0 .. 255, behind the state: adds the difference
 * of what its colour shows before and after. No dither: while the colour is the same the
 * sum telescopes, and is off by at most 1/2 of a unit; each change of it may add 1.
 * Fraction 0, 4, 8 or 16.
 */
FX_INLINE uint32_t fx_front_colour(uint32_t state, uint32_t colour, uint32_t before, uint32_t after,
                                   unsigned fraction)
{
    uint32_t added =
        fx_opaque_share(colour, after, fraction) - fx_opaque_share(colour, before, fraction);
    return fx_below_opacity(state + added, after, fraction);
}

/*
 * A slice of light behind the state: adds light * transmittance, rounded by dither; for a
 * fraction of 16 bits FX_NO_DITHER is best. before and after are the
 * transmittances of the pixel on both sides of the slice. Fraction 0, 4, 8 or 16. Off by
 * less than 1 unit, on average by less than 2^(fraction-23), before it is limited.
 */
FX_INLINE uint32_t fx_front_light(uint32_t state, uint32_t light, uint32_t before, uint32_t after,
                                  uint32_t u, unsigned fraction)
{
    uint32_t shown = fx_high_product(light, before << 8); /* at most 255 * 2^23 */
    uint32_t added = (shown + (u >> (9u + fraction))) >> (23u - fraction);
    return fx_below_opacity(state + added, after, fraction);
}

/* ---- What is shown, and the residual -------------------------------------- */

/* The level of a state with 4, 8 or 16 fraction bits, to nearest, ties upwards: 0 .. 255. */
FX_INLINE uint32_t fx_level_of(uint32_t state, unsigned fraction)
{
    return (state + ((uint32_t)1 << (fraction - 1u))) >> fraction;
}

/*
 * A state of 8.8 or 8.4 kept as the level that is shown, in a frame buffer of 8 bits, and a
 * residual of 8 or 4 bits beside it, -2^(f-1) .. 2^(f-1) - 1. A picture that is cleared
 * or drawn over needs its residuals cleared: level 0 has none below 0.
 */
FX_INLINE int32_t fx_residual_of(uint32_t state, unsigned fraction)
{
    return (int32_t)state - (int32_t)(fx_level_of(state, fraction) << fraction);
}

/* The state of a level and its residual: exactly the one that they were made of. */
FX_INLINE uint32_t fx_state_of(uint32_t level, int32_t residual, unsigned fraction)
{
    return (level << fraction) + (uint32_t)residual;
}

#endif /* FX_BLEND_H */
