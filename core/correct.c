#include "correct.h"

void qv_corrected_under(qv_light *light, qv_gathered *gathered, const qv_sample *sample,
                        const qv_medium *medium, unsigned storage)
{
    uint32_t colour[3];
    uint32_t opacity = qv_correct(colour, sample, medium, storage);
    (void)gathered;
    qv_under(light, colour, opacity);
}

void qv_corrected_over(qv_light *light, qv_gathered *gathered, const qv_sample *sample,
                       const qv_medium *medium, unsigned storage)
{
    uint32_t colour[3];
    uint32_t opacity = qv_correct(colour, sample, medium, storage);
    (void)gathered;
    qv_over(light, colour, opacity);
}

void qv_extinction_under(qv_light *light, qv_gathered *gathered, const qv_sample *sample,
                         const qv_medium *medium, unsigned storage)
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

void qv_extinction_over(qv_light *light, qv_gathered *gathered, const qv_sample *sample,
                        const qv_medium *medium, unsigned storage)
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

void qv_gathered_light(qv_light *light, const qv_gathered *gathered, const qv_medium *medium)
{
    for (unsigned c = 0; c < 3; c++)
        light->colour[c] = (uint32_t)(gathered->light[c] >> (32u - medium->light_shift));
}
