/*
 * correct.h - light of a sample for the length that it stands for, and its compositing.
 *
 * Two models. Opacity-based: opacity and opacity-weighted colour are corrected for the
 * length, then composited as they are. Extinction-based: depth adds up along the ray and
 * transmittance follows from the sum, so that the opacity of a sample is a difference of
 * transmittances. Both orders of compositing have both.
 *
 * Source: Kraus and Buerger 2008, equations 16, 17 (corrected), 22 and 23 (extinction).
 */
#ifndef QV_CORRECT_H
#define QV_CORRECT_H

#include "composite.h"
#include "fx_inline.h"
#include "fx_phi.h"
#include "medium.h"
#include "sample.h"

/* What a ray gathers besides its qv_light, with extinction. */
typedef struct qv_gathered {
    uint64_t light[3]; /* sums of colour * factor: unit of the sample * 2^(31 - light_shift) */
    fx_depth depth;    /* from the first sample on */
} qv_gathered;

/* Composites a sample that stands for a length of this medium. */
typedef void qv_model(qv_light *light, qv_gathered *gathered, const qv_sample *sample,
                      const qv_medium *medium, unsigned storage);

/* The two models, front to back and back to front. Corrected opacity gathers nothing. */
qv_model qv_corrected_under, qv_corrected_over, qv_extinction_under, qv_extinction_over;

/* Light summed up, in half the unit of the sample. */
void qv_gathered_light(qv_light *light, const qv_gathered *gathered, const qv_medium *medium);

/* Q1.31 as Q0.32, with 2^32 - 1 for 1. */
FX_INLINE uint32_t qv_opacity_of_q31(uint32_t opacity)
{
    return (opacity << 1) - (opacity >> 31);
}

/* ---- Opacity-based ---------------------------------------------------------- */

/* From this depth for the unit distance on, an opacity is within 2^-23 of 1. */
#define QV_NEARLY_OPAQUE 23u

/*
 * Corrected by stored opacity, Q(a).(32-a): the ratio times phi of the corrected by phi of
 * the stored depth. Below 2^a, as the ratio is, or, if that is below 1, below 2.
 */
FX_INLINE uint32_t qv_correction(fx_depth stored, fx_depth corrected, const qv_medium *medium)
{
    if (stored >> 32 >= QV_NEARLY_OPAQUE)
        return fx_opacity(corrected) >> (medium->light_shift - 1u);
    uint32_t share = fx_phi_share(stored, corrected); /* Q5.27 */
    return (uint32_t)(fx_wide_product(share, medium->light) >> 27);
}

/* Opacity, Q0.32, and colour of a sample for the length. A colour stays below 2^32: at most
   its unit, 65536 * 255^2 or 65535^2, and less than 2^-15 of it. For a ratio of 2^11, the
   most, phi of a depth of 23 * 2^11 is 2^-15, which its rounding and that of the share of
   phi change by 2^-17 each, and its own error by .16 * 2^-16. */
FX_INLINE uint32_t qv_correct(uint32_t colour[3], const qv_sample *sample, const qv_medium *medium,
                              unsigned storage)
{
    uint32_t opacity = qv_opacity_q32(sample->opacity, storage);
    for (unsigned c = 0; c < 3; c++)
        colour[c] = fx_sum_bits(sample->light[c]);
    if (medium->depth == (uint64_t)1 << 32) /* the length is the unit distance */
        return opacity;
    fx_depth stored = fx_depth_of_opacity(opacity);
    fx_depth corrected = fx_depth_times(stored, medium->depth);
    uint32_t factor = qv_correction(stored, corrected, medium);
    for (unsigned c = 0; c < 3; c++)
        colour[c] = (uint32_t)(fx_wide_product(colour[c], factor) >> (32u - medium->light_shift));
    return qv_opacity_of_q31(fx_opacity(corrected));
}

FX_INLINE void qv_corrected_under_body(qv_light *light, qv_gathered *gathered,
                                       const qv_sample *sample, const qv_medium *medium,
                                       unsigned storage)
{
    uint32_t colour[3];
    uint32_t opacity = qv_correct(colour, sample, medium, storage);
    (void)gathered;
    qv_under(light, colour, opacity);
}

FX_INLINE void qv_corrected_over_body(qv_light *light, qv_gathered *gathered,
                                      const qv_sample *sample, const qv_medium *medium,
                                      unsigned storage)
{
    uint32_t colour[3];
    uint32_t opacity = qv_correct(colour, sample, medium, storage);
    (void)gathered;
    qv_over(light, colour, opacity);
}

/* ---- Extinction-based ------------------------------------------------------- */

/* The depth of a sample: its extinction sum times what 2^32 units are worth. */
FX_INLINE fx_depth qv_sample_depth(const qv_sample *sample, const qv_medium *medium)
{
    uint32_t sum = fx_share_bits(sample->opacity);
    uint64_t low = fx_wide_product(sum, (uint32_t)medium->depth) >> 32;
    return (fx_wide_product(sum, (uint32_t)(medium->depth >> 32)) + low) >> sample->scale;
}

/* transmittance * phi * ln 2 * the full value's depth, Q(a+1).(31-a): what a sample's
   extinction-weighted colour, in parts of the full value, is light of. */
FX_INLINE uint32_t qv_light_factor(uint32_t transmittance, fx_depth depth, const qv_medium *medium)
{
    uint32_t seen = (uint32_t)(fx_wide_product(transmittance, fx_phi(depth)) >> 32); /* <= 2^30 */
    return (uint32_t)(fx_wide_product(seen << 1, medium->light) >> 32);
}

FX_INLINE void qv_extinction_under_body(qv_light *light, qv_gathered *gathered,
                                        const qv_sample *sample, const qv_medium *medium,
                                        unsigned storage)
{
    fx_depth depth = qv_sample_depth(sample, medium);
    uint32_t factor = qv_light_factor(light->transmittance, depth, medium);
    (void)storage;
    /* all light together is at most 1 and a little: half of what 64 bits hold */
    gathered->light[0] += fx_wide_product(fx_sum_bits(sample->light[0]), factor) >> sample->scale;
    gathered->light[1] += fx_wide_product(fx_sum_bits(sample->light[1]), factor) >> sample->scale;
    gathered->light[2] += fx_wide_product(fx_sum_bits(sample->light[2]), factor) >> sample->scale;
    gathered->depth += depth; /* the sum was below 32, since something was transmitted */
    light->transmittance = fx_transmittance(gathered->depth);
}

FX_INLINE void qv_extinction_over_body(qv_light *light, qv_gathered *gathered,
                                       const qv_sample *sample, const qv_medium *medium,
                                       unsigned storage)
{
    fx_depth depth = qv_sample_depth(sample, medium);
    uint32_t factor = qv_light_factor(QV_CLEAR, depth, medium);
    uint32_t opacity = qv_opacity_of_q31(fx_opacity(depth));
    (void)storage;
    for (unsigned c = 0; c < 3; c++) {
        uint64_t term = fx_wide_product(fx_sum_bits(sample->light[c]), factor);
        light->colour[c] -= fx_high_product(light->colour[c], opacity);
        light->colour[c] += (uint32_t)(term >> sample->scale >> (32u - medium->light_shift));
    }
    if (gathered->depth < FX_OPAQUE_DEPTH) /* beyond, more depth changes nothing */
        gathered->depth += depth;
    light->transmittance = fx_transmittance(gathered->depth);
}

/* How a loop has a model: as a function, whose stack frame is gone when the next sample is made, or
   as a part of itself. */
#if FX_SMALL
#define QV_MODEL(name) name
#else
#define QV_MODEL(name) name##_body
#endif

#endif /* QV_CORRECT_H */
