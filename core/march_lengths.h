/*
 * march_lengths.h - the loop over a ray's pieces, for the modes that weigh by length.
 *
 * A model turns a sample and the length that it stands for into light. Modes, models
 * and storage are constants at each call, and all of it is inlined.
 */
#ifndef QV_MARCH_LENGTHS_H
#define QV_MARCH_LENGTHS_H

#include "families.h"
#include "stretch.h"

FX_INLINE void qv_advance_run(qv_run *run, qv_ray *ray)
{
    run->samples--;
    for (unsigned axis = 0; axis < 3; axis++)
        ray->place[axis] += ray->advance[axis];
}

struct qv_levels;

/* Looks at the point where a ray stands, in a volume or in two of its levels; returns 0 where
   there is nothing to see. Apart where size counts, so that what they keep on the stack is
   gone when the next run is looked for. */
typedef int qv_look(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                    struct qv_levels *levels);

FX_INLINE int qv_look_at_volume(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                                unsigned storage, const qv_family *family)
{
    return family->mode(sample, ray, volume, storage);
}

/*
 * Front to back through one run. ray->samples counts down to the pieces that were not
 * taken. Returns 0 where the ray ends here, for lack of transmittance.
 */
FX_INLINE int qv_march_run(qv_light *light, qv_gathered *gathered, qv_run *run, qv_ray *ray,
                           const qv_context *context, unsigned storage, const qv_family *family,
                           qv_look *look, struct qv_levels *levels)
{
    qv_medium medium;
    qv_medium_scale(&medium, &context->medium, run->length);
    ray->samples -= run->samples;
    for (; run->samples != 0; qv_advance_run(run, ray)) {
        qv_sample sample;
        if (family->bring)
            family->bring(ray, &context->scene.volume);
        if (!look(&sample, ray, &context->scene.volume, levels)) {
            light->skipped++;
            continue;
        }
        family->under(light, family->gathers ? gathered : 0, &sample, &medium, storage);
        if (light->transmittance <= (uint32_t)context->scene.termination << 15) { /* to Q1.31 */
            uint32_t rest = run->samples - 1u;
            ray->samples += rest;
            light->terminated = rest != 0 || ray->enter < ray->leave;
            return 0;
        }
    }
    return 1;
}

/* Through the pieces of a ray that was clipped. */
FX_INLINE void qv_march_lengths(qv_light *light, qv_ray *ray, const qv_context *context,
                                unsigned storage, const qv_family *family, qv_look *look)
{
    qv_gathered gathered = {{0, 0, 0}, 0};
    qv_run run;
    qv_run_begin(&run, ray);
    while (qv_next_run(&run, ray, ray->leave, 0) &&
           qv_march_run(light, &gathered, &run, ray, context, storage, family, look, 0))
        ;
    if (family->gathers)
        qv_gathered_light(light, &gathered, &context->medium);
}

/* The same back to front: every piece is taken. */
FX_INLINE void qv_march_lengths_back(qv_light *light, qv_ray *ray, const qv_context *context,
                                     unsigned storage, const qv_family *family, qv_look *look)
{
    qv_gathered gathered = {{0, 0, 0}, 0};
    qv_run run;
    qv_path_reverse(ray);
    qv_run_begin(&run, ray);
    while (qv_next_run(&run, ray, ray->leave, 0)) {
        qv_medium medium;
        qv_medium_scale(&medium, &context->medium, run.length);
        for (; run.samples != 0; qv_advance_run(&run, ray)) {
            qv_sample sample;
            ray->samples--;
            if (family->bring)
                family->bring(ray, &context->scene.volume);
            if (look(&sample, ray, &context->scene.volume, 0))
                family->over(light, family->gathers ? &gathered : 0, &sample, &medium, storage);
            else
                light->skipped++;
        }
    }
}

/*
 * Defines the sampling mode qv_MODE_SUFFIX of a family for a storage, in both orders.
 * Macros because the descriptors are public names; the code is qv_march_lengths. A ray is clipped
 * before the loop over its pieces has its stack frame.
 */
#define QV_DEFINE_BY_LENGTH(mode, suffix, prepare, family, read_out, storage)                      \
    static FX_APART int look_##suffix(qv_sample *sample, const qv_ray *ray,                        \
                                      const qv_volume *volume, struct qv_levels *levels)           \
    {                                                                                              \
        (void)levels;                                                                              \
        return qv_look_at_volume(sample, ray, volume, storage, family);                            \
    }                                                                                              \
    static FX_NOINLINE void pieces_##suffix(qv_light *light, qv_ray *ray,                          \
                                            const qv_context *context)                             \
    {                                                                                              \
        qv_march_lengths(light, ray, context, storage, family, look_##suffix);                     \
    }                                                                                              \
    static FX_NOINLINE void pieces_back_##suffix(qv_light *light, qv_ray *ray,                     \
                                                 const qv_context *context)                        \
    {                                                                                              \
        qv_march_lengths_back(light, ray, context, storage, family, look_##suffix);                \
    }                                                                                              \
    static void march_##suffix(qv_light *light, qv_ray *ray, const qv_context *context)            \
    {                                                                                              \
        qv_path_clip(ray, context);                                                                \
        pieces_##suffix(light, ray, context);                                                      \
    }                                                                                              \
    static void march_back_##suffix(qv_light *light, qv_ray *ray, const qv_context *context)       \
    {                                                                                              \
        qv_path_clip(ray, context);                                                                \
        pieces_back_##suffix(light, ray, context);                                                 \
    }                                                                                              \
    QV_DESCRIPTOR qv_sampling qv_##mode##_##suffix = {prepare, march_##suffix, read_out, storage,  \
                                                      1};                                          \
    QV_DESCRIPTOR qv_sampling qv_##mode##_##suffix##_back_to_front = {                             \
        prepare, march_back_##suffix, read_out, storage, 1};

#define QV_DEFINE_LENGTHS(mode, suffix, kind, family, read_out, storage)                           \
    QV_DEFINE_BY_LENGTH(mode, suffix, qv_prepare_##kind, family, read_out, storage)

/* DEFINE for each storage of opacity-based modes: those that hold opacity. */
#define QV_CORRECTED_ENTRIES(DEFINE, mode, family)                                                 \
    DEFINE(mode, rgba8, corrected, family, QV_READ_OUT_8, QV_STORAGE_RGBA8)                        \
    DEFINE(mode, rgba16, corrected, family, QV_READ_OUT_16, QV_STORAGE_RGBA16)
#define QV_CORRECTED_INDEXED(DEFINE, mode, family)                                                 \
    DEFINE(mode, indexed8, corrected, family, QV_READ_OUT_8, QV_STORAGE_INDEXED8)                  \
    DEFINE(mode, indexed8_16, corrected, family, QV_READ_OUT_16, QV_STORAGE_INDEXED8_16)
#define QV_EACH_CORRECTED(DEFINE, mode, family)                                                    \
    QV_CORRECTED_ENTRIES(DEFINE, mode, family)                                                     \
    QV_CORRECTED_INDEXED(DEFINE, mode, family)

/* Of extinction-based modes: those that hold extinction, */
#define QV_EXTINCTION_ENTRIES(DEFINE, mode, family)                                                \
    DEFINE(mode, rgbt8, extinction, family, QV_READ_OUT_8, QV_STORAGE_RGBT8)                       \
    DEFINE(mode, rgbt16, extinction, family, QV_READ_OUT_16, QV_STORAGE_RGBT16)
#define QV_EXTINCTION_INDEXED(DEFINE, mode, family)                                                \
    DEFINE(mode, indexed8_t8, extinction, family, QV_READ_OUT_8, QV_STORAGE_INDEXED8_T8)           \
    DEFINE(mode, indexed8_t16, extinction, family, QV_READ_OUT_16, QV_STORAGE_INDEXED8_T16)
#define QV_EACH_EXTINCTION(DEFINE, mode, family)                                                   \
    QV_EXTINCTION_ENTRIES(DEFINE, mode, family)                                                    \
    QV_EXTINCTION_INDEXED(DEFINE, mode, family)

/* and those that hold opacity, which is converted. */
#define QV_CONVERTED_ENTRIES(DEFINE, mode, family)                                                 \
    DEFINE(mode, rgba8, converted, family, QV_READ_OUT_CONVERTED, QV_STORAGE_RGBA8)                \
    DEFINE(mode, rgba16, converted, family, QV_READ_OUT_CONVERTED, QV_STORAGE_RGBA16)
#define QV_CONVERTED_INDEXED(DEFINE, mode, family)                                                 \
    DEFINE(mode, indexed8, converted, family, QV_READ_OUT_CONVERTED, QV_STORAGE_INDEXED8)          \
    DEFINE(mode, indexed8_16, converted, family, QV_READ_OUT_CONVERTED, QV_STORAGE_INDEXED8_16)
#define QV_EACH_CONVERTED(DEFINE, mode, family)                                                    \
    QV_CONVERTED_ENTRIES(DEFINE, mode, family)                                                     \
    QV_CONVERTED_INDEXED(DEFINE, mode, family)

#endif /* QV_MARCH_LENGTHS_H */
