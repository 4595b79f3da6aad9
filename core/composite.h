/*
 * composite.h - light along a ray: over and under with associated colours.
 *
 * Source: Wittenbrink, Malzbender, Goss 1998: equations 5, 6, 8 (under, front to
 * back) and 7 (over, back to front), after Blinn and Porter and Duff.
 *
 * Light accumulates in half the unit of qv_sample (just below 2^31 is 1),
 * transmittance as Q1.31. Each operation rounds to nearest, by at most 2^-32 of
 * 1. With n <= 2^23 samples the sums stay below 2^31 + 2^22.
 */
#ifndef QV_COMPOSITE_H
#define QV_COMPOSITE_H

#include "fx_wide.h"
#include "fx_inline.h"
#include "qvol.h"

#define QV_CLEAR 0x80000000u /* transmittance 1, Q1.31 */

typedef struct qv_light {
    uint32_t colour[3];     /* associated; half the unit of the storage */
    uint32_t transmittance; /* Q1.31 */
    uint32_t skipped;       /* samples in cells without opacity */
    int terminated;         /* whether the ray ended before its last sample */
} qv_light;

/* Places a sample behind what has been gathered. opacity is Q0.32, 2^32 - 1 for
   1: then T * opacity rounds to T, as T <= 2^31, and nothing is left. */
FX_INLINE void qv_under(qv_light *light, const uint32_t sample[3], uint32_t opacity)
{
    uint32_t transmittance = light->transmittance;
    light->colour[0] = fx_add_high_product(light->colour[0], sample[0], transmittance);
    light->colour[1] = fx_add_high_product(light->colour[1], sample[1], transmittance);
    light->colour[2] = fx_add_high_product(light->colour[2], sample[2], transmittance);
    light->transmittance = transmittance - fx_add_high_product(0, opacity, transmittance);
}

/* Places a sample in front of what has been gathered. */
FX_INLINE void qv_over(qv_light *light, const uint32_t sample[3], uint32_t opacity)
{
    for (unsigned c = 0; c < 3; c++) {
        light->colour[c] -= fx_high_product(light->colour[c], opacity);
        light->colour[c] += (sample[c] >> 1) + (sample[c] & 1u);
    }
    light->transmittance -= fx_high_product(light->transmittance, opacity);
}

/*
 * Light to pixel levels with 16 fraction bits, 255 * 65536 is 1: colour *
 * QV_READ_OUT / 2^32, with QV_READ_OUT = 255 * 2^49 / unit rounded to nearest
 * for units of 65536 * 255^2 and 65535^2.
 */
#define QV_LEVEL_ONE   0x00FF0000u
#define QV_READ_OUT_8  33686018u
#define QV_READ_OUT_16 33424380u
/* The same for 2^31 * 65535 / 65536: colours weighted by the extinction of opacities. */
#define QV_READ_OUT_CONVERTED 66847740u
/* The same, exactly, for 255 * 2^24: associated colours. */
#define QV_READ_OUT_ASSOCIATED 33554432u

/* A level with 16 fraction bits, at most QV_LEVEL_ONE, as part of 1, Q0.32: 65536 / 255 = 257 +
   1/2^8 + 1/2^16 + ... */
FX_INLINE uint32_t qv_part_of_level(uint32_t level)
{
    return 257u * level + (level >> 8) + (level >> 16);
}

/* The factor of fx_light_of for the unit of a read-out: 255 * 2^55 / unit, rounded to nearest.
   Of the three, 64 times the read-out is 1 too small. */
#define QV_LIGHT_OF(read_out) (64u * (read_out) + 1u)

#endif /* QV_COMPOSITE_H */
