/*
 * march_levels.h - the loop over a ray's pieces through the levels of a pyramid.
 */
#ifndef QV_MARCH_LEVELS_H
#define QV_MARCH_LEVELS_H

#include "level.h"
#include "march_lengths.h"

/* A sum of one level and that of the next, in proportion, to nearest: never above the
   larger, and exact where they are equal. share is not 0; both are below 2^32 - 2^15. */
FX_INLINE uint32_t qv_blend_sums(uint32_t finer, uint32_t coarser, uint32_t share)
{
    uint64_t sum = fx_wide_product(finer, 0u - share) + fx_wide_product(coarser, share);
    return (uint32_t)((sum + 0x80000000u) >> 32);
}

/* Blends the coarser sample into the finer one, both at the lesser of their scales. */
FX_INLINE void qv_blend_samples(qv_sample *finer, const qv_sample *coarser, uint32_t share)
{
    unsigned scale = finer->scale < coarser->scale ? finer->scale : coarser->scale;
    unsigned down = finer->scale - scale, coarser_down = coarser->scale - scale;
    finer->scale = scale;
    finer->opacity =
        fx_share_of(qv_blend_sums(fx_share_bits(finer->opacity) >> down,
                                  fx_share_bits(coarser->opacity) >> coarser_down, share));
    for (unsigned c = 0; c < 3; c++)
        finer->light[c] =
            fx_sum_of(qv_blend_sums(fx_sum_bits(finer->light[c]) >> down,
                                    fx_sum_bits(coarser->light[c]) >> coarser_down, share));
}

/* A sample without opacity, which takes the scale of any other. */
FX_INLINE void qv_clear_sample(qv_sample *sample)
{
    sample->opacity = fx_share_of(0);
    for (unsigned c = 0; c < 3; c++)
        sample->light[c] = fx_sum_of(0);
    sample->scale = 31;
}

/* One level: entries stand by themselves above level 0, whatever the volume's storage. */
FX_INLINE int qv_look_at_level(qv_sample *sample, const qv_ray *ray, const qv_subject *subject,
                               unsigned which, unsigned storage, const qv_family *family)
{
    if (which == 0 && qv_storage_indexed(storage) && subject->span->level == 0)
        return family->mode(sample, ray, subject->volume[which], storage);
    return family->mode(sample, ray, subject->volume[which], qv_entry_storage(storage));
}

/* The finer level, and the coarser where it has a share. */
FX_INLINE int qv_look_at_levels(qv_sample *sample, const qv_ray *ray, const qv_subject *subject,
                                unsigned storage, const qv_family *family)
{
    uint32_t share = subject->span->blend;
    qv_sample coarser;
    qv_ray above;
    qv_clear_sample(sample);
    int seen = qv_look_at_level(sample, ray, subject, 0, storage, family);
    subject->span->blend = share + subject->span->rise;
    if (share == 0)
        return seen;
    for (unsigned axis = 0; axis < 3; axis++)
        above.place[axis] = fx_shift_floor(ray->place[axis] - QV_CENTRED, 1) + QV_CENTRED;
    qv_clear_sample(&coarser);
    seen |= qv_look_at_level(&coarser, &above, subject, 1, storage, family);
    if (!seen)
        return 0;
    qv_blend_samples(sample, &coarser, share);
    return 1;
}

FX_INLINE void qv_march_levels(qv_light *light, qv_ray *ray, const qv_context *context,
                               unsigned storage, const qv_family *family)
{
    qv_gathered gathered = {{0, 0, 0}, 0};
    qv_levels levels;
    qv_span span;
    qv_run run;
    const qv_subject subject = {{&levels.volume[0], &levels.volume[1]}, &span};
    int more = 1;
    levels.finer = QV_NO_LEVEL;
    for (qv_path_clip(ray, context); more;) {
        qv_span_begin(&span, ray, &context->scene);
        if (!qv_next_run(&run, ray, span.end, span.level))
            break;
        qv_span_blend(&span, &run);
        qv_levels_describe(&levels, span.level, &context->scene);
        more = qv_march_run(light, &gathered, &run, ray, context, storage, family,
                            qv_look_at_levels, &subject);
    }
    if (family->gathers)
        qv_gathered_light(light, &gathered, &context->medium);
}

/* Defines qv_MODE_SUFFIX_levels. The pyramid is checked before the medium is made. */
#define QV_DEFINE_LEVELS(mode, suffix, kind, family, read_out, storage)                            \
    static qv_status prepare_##suffix(qv_context *context, const qv_scene *scene)                  \
    {                                                                                              \
        qv_status status = qv_level_check(scene);                                                  \
        if (status == QV_OK)                                                                       \
            status = qv_medium_##kind(&context->medium, scene, scene->pyramid->levels);            \
        return status;                                                                             \
    }                                                                                              \
    static void march_##suffix(qv_light *light, qv_ray *ray, const qv_context *context)            \
    {                                                                                              \
        qv_march_levels(light, ray, context, storage, family);                                     \
    }                                                                                              \
    QV_DESCRIPTOR qv_sampling qv_##mode##_##suffix##_levels = {prepare_##suffix, march_##suffix,   \
                                                               read_out, storage, 1};

#endif /* QV_MARCH_LEVELS_H */
