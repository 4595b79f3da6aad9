#include "correct.h"

void qv_corrected_under(qv_light *light, qv_gathered *gathered, const qv_sample *sample,
                        const qv_medium *medium, unsigned storage)
{
    qv_corrected_under_body(light, gathered, sample, medium, storage);
}

void qv_corrected_over(qv_light *light, qv_gathered *gathered, const qv_sample *sample,
                       const qv_medium *medium, unsigned storage)
{
    qv_corrected_over_body(light, gathered, sample, medium, storage);
}

void qv_extinction_under(qv_light *light, qv_gathered *gathered, const qv_sample *sample,
                         const qv_medium *medium, unsigned storage)
{
    qv_extinction_under_body(light, gathered, sample, medium, storage);
}

void qv_extinction_over(qv_light *light, qv_gathered *gathered, const qv_sample *sample,
                        const qv_medium *medium, unsigned storage)
{
    qv_extinction_over_body(light, gathered, sample, medium, storage);
}

void qv_gathered_light(qv_light *light, const qv_gathered *gathered, const qv_medium *medium)
{
    for (unsigned c = 0; c < 3; c++)
        light->colour[c] = (uint32_t)(gathered->light[c] >> (32u - medium->light_shift));
}
