/*
 * fx_alpha.h - opacities of 8 bits for blending hardware of 8 bits: what each technique of
 * alpha dithering hands it for one slice of one pixel.
 *
 * Source: Williams et al., alpha dithering for 8-bit compositing: sections 3 and 4 (dither,
 * cutoff, bumps, slope modifiers), section 9.2 (its open questions).
 *
 * Opacity   levels with 16 fraction bits, 0 .. 255 * 65536 (255 is 1); results 0 .. 255.
 * Colour    a level that is not weighted; hardware that wants associated colours is given
 *           those weighted by the result, never colours dithered apart (section 5).
 * Phase     of the slice: fx_phase. u: its dither value, of fx_dither.h.
 * Value     the level that the pixel holds. The bumps are made for colour 255; for a
 *           colour c and a level v they are right with 255 - |c - v| as the value.
 *
 * All is unsigned arithmetic of 32 bits without a division; bumps take the 7 steps of fx_hits, and
 * corrected opacities at most 8. Each function stands alone.
 */
#ifndef FX_ALPHA_H
#define FX_ALPHA_H

#include "fx_dither.h"

/* How opacities are dithered by equation 9. */
typedef struct fx_alpha {
    fx_period period;
    uint32_t slope[2]; /* Q8.16, 65536 is 1: what opacities are multiplied by below and above
                          the knee; where there is no knee, the first */
    uint32_t cutoff;   /* level 0 .. 255: opacities above are only rounded, and keep their slope
                          of 1; for 255 none is above */
} fx_alpha;

/* No dither: to nearest, ties upwards; off by at most 1/2. */
static inline uint32_t fx_alpha_rounded(uint32_t opacity)
{
    return (opacity + 32768u) >> 16;
}

/*
 * Simple dither: floor of the opacity or 1 more. Over all u, or over the phases of a period,
 * the mean is the opacity times its slope, but for 1 / (2 slices) and, at random, 2^-16.
 */
uint32_t fx_alpha_random(const fx_alpha *of, uint32_t opacity, uint32_t u);
uint32_t fx_alpha_ordered(const fx_alpha *of, uint32_t opacity, uint32_t phase);

/*
 * Exponential bumping with two slopes: floor of the opacity, or 1, 3, 7 ... 255 more as fx_bump
 * needs to raise the value. The knee is where floor of the opacity, at least 1, does not
 * raise it any more. The mean is the opacity times its slope, but for bump / (2 slices); it
 * is less where the slices of a period are too few for their bump.
 */
uint32_t fx_alpha_bumped_random(const fx_alpha *of, uint32_t opacity, uint32_t u, uint32_t value);
uint32_t fx_alpha_bumped(const fx_alpha *of, uint32_t opacity, uint32_t phase, uint32_t value);

/*
 * The answer to section 9.2: of all opacities by which the rounded blend of a colour with
 * the value gives what fx_blend_dithered gives with u, that nearest to the opacity rounded. So
 * one channel of 8 bits is blended by hardware as exactly as by fx_blend_dithered, without
 * bumps or slopes to choose; channels that share the opacity are not. Opacity 0 gives 0 and
 * opacity 1 gives 255.
 */
uint32_t fx_alpha_corrected(uint32_t opacity, uint32_t colour, uint32_t value, uint32_t u);

#endif /* FX_ALPHA_H */
