/*
 * fx_dither.h - dither: values that decide a rounding, and alpha dithering, which
 * replaces an opacity by two of 8 bits that alternate over a period of slices.
 *
 * Source: Williams et al., alpha dithering for 8-bit compositing: section 3,
 * equations 9 and 10, table 1. The integer hash is by Ellis (lowbias32), the lattice
 * of pixels by Roberts (R2).
 */
#ifndef FX_DITHER_H
#define FX_DITHER_H

#include <stdint.h>

/* ---- Dither values -------------------------------------------------------- */

/*
 * A dither value u is Q0.32, 0 .. 1 - 2^-32. Where a blend adds u before it cuts a
 * fraction off, the result is on average exact. Each slice has a value of its own, and
 * fx_dither_at shifts it for each pixel and frame. All of it is modulo 2^32.
 */

#define FX_GOLDEN 0x9E3779B9u /* 2^32 / 1.6180..., the golden ratio */
/* 2^32 / r and 2^32 / r^2 for r^3 = r + 1, r = 1.3247... */
#define FX_LATTICE_X 0xC13FA9A9u
#define FX_LATTICE_Y 0x91E10DA6u

/* A bijection of 32 bits without visible order. */
uint32_t fx_hash(uint32_t v);

/*
 * Multiples of the golden ratio: any n in a row part the circle nearly evenly. The best for
 * slices that all have opacity; but it beats with slices of which only every k-th has,
 * as for k = 233.
 */
static inline uint32_t fx_dither_golden(uint32_t slice)
{
    return FX_GOLDEN * slice;
}

/* Independent values: no beat with anything, but the noise of a random walk. */
static inline uint32_t fx_dither_hash(uint32_t slice)
{
    return fx_hash(2u * slice + 1u);
}

/*
 * Blocks of 8 slices with one value in each eighth of 0 .. 1: the order of a block turned by a
 * hash, its place in the eighth by the golden ratio, anew after 64 blocks, so that nothing
 * beats.
 */
static inline uint32_t fx_dither_blocks(uint32_t slice)
{
    uint32_t block = slice >> 3;
    uint32_t place = FX_GOLDEN * block + fx_hash(block >> 6);
    return ((5u * slice + fx_hash(block)) << 29) + (place >> 3);
}

/* A slice's value for the pixel (x, y) of a frame. To the right it grows by FX_LATTICE_X. */
static inline uint32_t fx_dither_at(uint32_t u, uint32_t x, uint32_t y, uint32_t frame)
{
    return u + FX_LATTICE_X * x + FX_LATTICE_Y * y + FX_GOLDEN * frame;
}

/* ---- Alpha dithering ------------------------------------------------------ */

/* A period of 2 .. 64 slices; 1 / slices rounded up, Q0.18. */
typedef struct fx_period {
    uint32_t slices, reciprocal;
} fx_period;

/* slices 2 .. 64. */
fx_period fx_period_of(uint32_t slices);

/* slice modulo the period, for any slice: 0 .. slices - 1. */
uint32_t fx_phase(const fx_period *period, uint32_t slice);

/*
 * Equation 9: how many slices of a period are to have base + bump in place of base, so
 * that their mean is the opacity: round(slices * (opacity - base) / bump), ties upwards,
 * and at most slices. The opacity has levels of 8 bits with 16 fraction bits, 0 .. 255 *
 * 65536; base 0 .. opacity, bump 1 .. 255. Unless limited, the mean is off by at most
 * bump / (2 slices). For bump 0, which base 255 leaves alone, it is slices.
 */
uint32_t fx_hits(const fx_period *period, uint32_t opacity, uint32_t base, uint32_t bump);

/* Whether the slice of dither value u hits, at random: hits / slices of the values do, but
   for 2^-16. */
static inline uint32_t fx_hit_random(const fx_period *period, uint32_t hits, uint32_t u)
{
    return ((u >> 16) * period->slices) >> 16 < hits;
}

/*
 * Whether the slice at a phase hits, in order: floor((phase + 1) * hits / slices) >
 * floor(phase * hits / slices). w slices in a row, also across periods, have w * hits /
 * slices hits, rounded up or down.
 */
static inline uint32_t fx_hit_ordered(const fx_period *period, uint32_t hits, uint32_t phase)
{
    uint32_t n = phase * hits; /* at most 63 * 64 < 2^12 */
    /* Exact: with reciprocal * slices = 2^18 + e, e < slices, it is floor((n + n e / 2^18) /
       slices), and n e <= 63 * 64 * 63 < 2^18. */
    uint32_t whole = (n * period->reciprocal) >> 18;
    return n - whole * period->slices + hits >= period->slices;
}

/* ---- Plateaus of a rounded blend ------------------------------------------- */

/*
 * Equation 10: where the blend of n bits, rounded to nearest, stops for good at full
 * colour: ceil(full - full / (2 opacity)) = full - floor((full - 1) / 2 / opacity), with
 * full = 2^n - 1. opacity 0 .. full of n = 5 .. 16 bits; for 0 it is 0.
 */
uint32_t fx_plateau(uint32_t opacity, uint32_t full);

/* Table 1: the least opacity that raises a value of n bits, below full, at full colour:
   opacity * (full - value) > full / 2. For full itself it is full + 1, which there is not. */
uint32_t fx_overcoming(uint32_t value, uint32_t full);

/*
 * Exponential bumping: the least of 1, 3, 7 ... 255 that overcomes a value of 8 bits (255
 * where none does), but at most 255 - base, which is 0 for base 255.
 */
uint32_t fx_bump(uint32_t value, uint32_t base);

#endif /* FX_DITHER_H */
