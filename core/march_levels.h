/*
 * march_levels.h - the loop over a ray's pieces through the levels of a pyramid.
 */
#ifndef QV_MARCH_LEVELS_H
#define QV_MARCH_LEVELS_H

#include "level.h"
#include "march_lengths.h"
#include "pyramid.h"

/* A sum of one level and that of the next, in proportion, to nearest: never above the
   larger, and exact where they are equal. share is not 0; both are below 2^32 - 2^15. */
FX_INLINE uint32_t qv_blend_sums(uint32_t finer, uint32_t coarser, uint32_t share)
{
    uint64_t sum = fx_wide_product(finer, 0u - share) + fx_wide_product(coarser, share);
    return (uint32_t)((sum + 0x80000000u) >> 32);
}

/* Blends the coarser sample into the finer one, both at the lesser of their scales. share is the
   coarser one's, Q0.32, and not 0. */
void qv_blend_samples(qv_sample *finer, const qv_sample *coarser, uint32_t share);

/* A sample without opacity, which takes the scale of any other. */
FX_INLINE void qv_clear_sample(qv_sample *sample)
{
    sample->opacity = fx_share_of(0);
    for (unsigned c = 0; c < 3; c++)
        sample->light[c] = fx_sum_of(0);
    sample->scale = 31;
}

/* One axis of where a ray stands on a level, the finer or the one above. */
FX_INLINE qv_coord qv_place_on_level(const qv_ray *ray, unsigned which, unsigned axis)
{
    qv_coord place = ray->place[axis];
    return which == 0 ? place : fx_shift_floor(place - QV_CENTRED, 1) + QV_CENTRED;
}

/* One of the two levels, as entries. Modes read nothing else of a ray and of a volume without
   a palette; written out, no more than that is kept of both. */
FX_INLINE int qv_look_at_level(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                               const qv_levels *levels, unsigned which, unsigned storage,
                               const qv_family *family)
{
    unsigned entries = qv_entry_storage(storage);
    qv_volume level;
    qv_ray there;
    level.voxels = levels->voxels[which];
    qv_level_shape(&level, volume, levels->finer + which, entries);
    there.place[0] = qv_place_on_level(ray, which, 0);
    there.place[1] = qv_place_on_level(ray, which, 1);
    there.place[2] = qv_place_on_level(ray, which, 2);
    return family->mode(sample, &there, &level, entries);
}

/* One of the two levels, apart from the other: the stack holds one look at a time. */
typedef int qv_look_apart(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                          const qv_levels *levels, unsigned which);

/* The finer level, and the coarser where it has a share. */
FX_INLINE int qv_look_at_levels(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                                qv_levels *levels, unsigned storage, qv_look_apart *indices,
                                qv_look_apart *entries)
{
    int of_indices = qv_storage_indexed(storage) && levels->finer == 0;
    qv_sample coarser;
    qv_clear_sample(sample);
    int seen = of_indices ? indices(sample, ray, volume, levels, 0)
                          : entries(sample, ray, volume, levels, 0);
    if (levels->blend != 0) {
        qv_clear_sample(&coarser);
        seen |= entries(&coarser, ray, volume, levels, 1);
        if (seen)
            qv_blend_samples(sample, &coarser, levels->blend);
    }
    levels->blend += levels->rise;
    return seen;
}

FX_INLINE void qv_march_levels(qv_light *light, qv_ray *ray, const qv_context *context,
                               unsigned storage, const qv_family *family, qv_look *look)
{
    qv_gathered gathered = {{0, 0, 0}, 0};
    qv_levels levels;
    qv_run run;
    levels.finer = QV_NO_LEVEL;
    qv_run_begin(&run, ray);
    while (qv_next_run_of_levels(&levels, &run, ray, &context->scene) &&
           qv_march_run(light, &gathered, &run, ray, context, storage, family, look, &levels))
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
                                            const qv_volume *volume, const qv_levels *levels,      \
                                            unsigned which)                                        \
    {                                                                                              \
        (void)levels;                                                                              \
        (void)which;                                                                               \
        return qv_look_at_volume(sample, ray, volume, storage, family);                            \
    }                                                                                              \
    static FX_NOINLINE int entries_##suffix(qv_sample *sample, const qv_ray *ray,                  \
                                            const qv_volume *volume, const qv_levels *levels,      \
                                            unsigned which)                                        \
    {                                                                                              \
        return qv_look_at_level(sample, ray, volume, levels, which, storage, family);              \
    }                                                                                              \
    static int look_##suffix(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,        \
                             qv_levels *levels)                                                    \
    {                                                                                              \
        return qv_look_at_levels(sample, ray, volume, levels, storage, indices_##suffix,           \
                                 entries_##suffix);                                                \
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
