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

/* One axis of where a ray stands on a level, the finer or the one above, and of the level. */
FX_INLINE void qv_stand_on_level(qv_ray *there, qv_volume *volume, const qv_ray *ray,
                                 const qv_level *level, unsigned which, unsigned axis)
{
    qv_coord place = ray->place[axis];
    there->place[axis] = which == 0 ? place : fx_shift_floor(place - QV_CENTRED, 1) + QV_CENTRED;
    volume->stride[axis] = level->stride[axis];
    volume->size[axis] = level->size[axis];
}

/* One of the two levels, as entries. Modes read nothing else of a ray and of a volume without
   a palette; written out, no more than that is kept of both. */
FX_INLINE int qv_look_at_level(qv_sample *sample, const qv_ray *ray, const qv_subject *subject,
                               unsigned which, unsigned storage, const qv_family *family)
{
    const qv_level *level = &subject->levels->level[which];
    qv_volume volume;
    qv_ray there;
    volume.voxels = level->voxels;
    qv_stand_on_level(&there, &volume, ray, level, which, 0);
    qv_stand_on_level(&there, &volume, ray, level, which, 1);
    qv_stand_on_level(&there, &volume, ray, level, which, 2);
    return family->mode(sample, &there, &volume, qv_entry_storage(storage));
}

/* How two levels are looked at: each apart from the loop, since two are long, and so that the
   stack holds one of them at a time. */
typedef int qv_look_apart(qv_sample *sample, const qv_ray *ray, const qv_subject *subject,
                          unsigned which);

/* The finer level, and the coarser where it has a share. */
FX_INLINE int qv_look_at_levels(qv_sample *sample, const qv_ray *ray, const qv_subject *subject,
                                unsigned storage, qv_look_apart *indices, qv_look_apart *entries)
{
    uint32_t share = subject->span->blend;
    int of_indices = qv_storage_indexed(storage) && subject->span->level == 0;
    qv_sample coarser;
    qv_clear_sample(sample);
    int seen = of_indices ? indices(sample, ray, subject, 0) : entries(sample, ray, subject, 0);
    subject->span->blend = share + subject->span->rise;
    if (share == 0)
        return seen;
    qv_clear_sample(&coarser);
    seen |= entries(&coarser, ray, subject, 1);
    if (!seen)
        return 0;
    qv_blend_samples(sample, &coarser, share);
    return 1;
}

FX_INLINE void qv_march_levels(qv_light *light, qv_ray *ray, const qv_context *context,
                               unsigned storage, const qv_family *family, qv_look *look)
{
    qv_gathered gathered = {{0, 0, 0}, 0};
    qv_levels levels;
    qv_span span;
    qv_run run;
    const qv_subject subject = {&context->scene.volume, &levels, &span};
    levels.finer = QV_NO_LEVEL;
    qv_run_begin(&run, ray);
    while (qv_next_run_of_levels(&span, &levels, &run, ray, &context->scene) &&
           qv_march_run(light, &gathered, &run, ray, context, storage, family, look, &subject))
        ;
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
    static FX_NOINLINE int indices_##suffix(qv_sample *sample, const qv_ray *ray,                  \
                                            const qv_subject *subject, unsigned which)             \
    {                                                                                              \
        (void)which;                                                                               \
        return qv_look_at_volume(sample, ray, subject, storage, family);                           \
    }                                                                                              \
    static FX_NOINLINE int entries_##suffix(qv_sample *sample, const qv_ray *ray,                  \
                                            const qv_subject *subject, unsigned which)             \
    {                                                                                              \
        return qv_look_at_level(sample, ray, subject, which, storage, family);                     \
    }                                                                                              \
    static int look_##suffix(qv_sample *sample, const qv_ray *ray, const qv_subject *subject,      \
                             unsigned of, const qv_family *by)                                     \
    {                                                                                              \
        (void)by;                                                                                  \
        return qv_look_at_levels(sample, ray, subject, of, indices_##suffix, entries_##suffix);    \
    }                                                                                              \
    static FX_NOINLINE void pieces_##suffix(qv_light *light, qv_ray *ray,                          \
                                            const qv_context *context)                             \
    {                                                                                              \
        qv_march_levels(light, ray, context, storage, family, look_##suffix);                      \
    }                                                                                              \
    static void march_##suffix(qv_light *light, qv_ray *ray, const qv_context *context)            \
    {                                                                                              \
        qv_path_clip(ray, context);                                                                \
        pieces_##suffix(light, ray, context);                                                      \
    }                                                                                              \
    QV_DESCRIPTOR qv_sampling qv_##mode##_##suffix##_levels = {prepare_##suffix, march_##suffix,   \
                                                               read_out, storage, 1};

#endif /* QV_MARCH_LEVELS_H */
