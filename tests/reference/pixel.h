/*
 * pixel.h - one channel of a pixel in a fog of constant opacity and colour, slice by slice, by
 * each technique of the library: for measurements of bricks, frames and fields of pixels.
 */
#ifndef REF_PIXEL_H
#define REF_PIXEL_H

#include <stdint.h>

/* A fog in all the units that blends take it in. */
typedef struct ref_pixel_fog {
    double level; /* opacity, 255 is 1 */
    uint32_t colour;
    uint32_t opacity, opacity23, opacity32; /* the first a level with 16 fraction bits */
} ref_pixel_fog;

ref_pixel_fog ref_pixel_fog_of(double level, uint32_t colour);

/* The exact level after so many slices over black. */
double ref_pixel_exact(const ref_pixel_fog *fog, uint32_t slices);

/* Of techniques that have a period. */
#define REF_PIXEL_PERIOD 32

/* A slice of a pixel: its place in the period, and its dither value. */
typedef struct ref_moment {
    uint32_t place;
    uint32_t u;
} ref_moment;

/* A number of a slice near the middle of a volume, as the renderer counts them. */
#define REF_PIXEL_MIDDLE 0x400000u

typedef uint32_t ref_pixel_blend(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at);
typedef uint32_t ref_pixel_dither(uint32_t slice);

typedef struct ref_pixel_technique {
    const char *name;
    ref_pixel_blend *blend;
    ref_pixel_dither *dither; /* null where there is none */
    unsigned fraction;        /* of the state */
} ref_pixel_technique;

/* As qv_slice makes it: both are shifted alike from pixel to pixel and from frame to frame. */
ref_moment ref_moment_of(const ref_pixel_technique *by, uint32_t slice, uint32_t shift);

/* The level that a state shows. */
double ref_pixel_shown(const ref_pixel_technique *by, uint32_t state);

/* Blends of 8 bits with opacities of 8 bits: fx_alpha.h, with slopes of 1. */
ref_pixel_blend ref_pixel_rounded, ref_pixel_random, ref_pixel_ordered, ref_pixel_bumped,
    ref_pixel_corrected;

/* fx_blend_dithered of each fraction, and fx_blend_8_16. */
ref_pixel_blend ref_pixel_8, ref_pixel_8_4, ref_pixel_8_8, ref_pixel_8_16;

#endif /* REF_PIXEL_H */
