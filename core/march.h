/*
 * march.h - the loop over a ray's samples, which every sampling mode shares.
 *
 * Modes and storage are constants at each call, and all of it is inlined.
 */
#ifndef QV_MARCH_H
#define QV_MARCH_H

#include "composite.h"
#include "sample.h"

/* What modes that know no lengths make of a scene: nothing but the check that they
   need to know none. QV_OK, QV_ERROR_UNIT. */
qv_status qv_prepare_steps(qv_context *context, const qv_scene *scene);

FX_INLINE void qv_advance(qv_ray *ray)
{
    FX_UNROLL
    for (unsigned axis = 0; axis < 3; axis++)
        ray->place[axis] += ray->advance[axis];
}

/* Takes a ray's next sample and advances the ray, while its place is at hand; returns 0 where
   there is nothing to see. */
FX_INLINE int qv_take(uint32_t colour[3], uint32_t *opacity, qv_ray *ray, const qv_volume *volume,
                      unsigned storage, qv_cell_mode *mode)
{
    qv_cell cell;
    qv_sample sample;
    qv_cell_locate(&cell, volume, ray);
    qv_advance(ray);
    FX_FORGET();
    if (!mode(&sample, &cell, volume, storage))
        return 0;
    for (unsigned c = 0; c < 3; c++)
        colour[c] = fx_sum_bits(sample.light[c]);
    *opacity = qv_opacity_q32(sample.opacity, storage);
    return 1;
}

/* Front to back. ray->samples counts down to those that were not taken. */
FX_INLINE void qv_march(qv_light *light, qv_ray *ray, const qv_context *context, unsigned storage,
                        qv_cell_mode *mode)
{
    uint32_t enough = (uint32_t)context->scene.termination << 15; /* Q0.16 to Q1.31 */
    qv_ray_clip(ray, context);
    while (ray->samples != 0) {
        uint32_t colour[3], opacity;
        ray->samples--;
        if (!qv_take(colour, &opacity, ray, &context->scene.volume, storage, mode)) {
            light->skipped++;
        } else {
            qv_under(light, colour, opacity);
            if (light->transmittance <= enough) {
                light->terminated = ray->samples != 0;
                return;
            }
        }
    }
}

/* Turns a ray round: it starts at its last sample and runs towards the viewer. Without
   samples it goes anywhere, and nowhere is looked at. */
FX_INLINE void qv_reverse(qv_ray *ray)
{
    int32_t last = (int32_t)(ray->samples - 1u);
    for (unsigned axis = 0; axis < 3; axis++) {
        ray->place[axis] += fx_multiply(ray->advance[axis], last);
        ray->advance[axis] = -ray->advance[axis];
    }
}

/* Back to front: every sample is taken. */
FX_INLINE void qv_march_back(qv_light *light, qv_ray *ray, const qv_context *context,
                             unsigned storage, qv_cell_mode *mode)
{
    qv_ray_clip(ray, context);
    for (qv_reverse(ray); ray->samples != 0; ray->samples--) {
        uint32_t colour[3], opacity;
        if (qv_take(colour, &opacity, ray, &context->scene.volume, storage, mode))
            qv_over(light, colour, opacity);
        else
            light->skipped++;
    }
}

/*
 * Defines the sampling mode qv_MODE_SUFFIX for a storage, in both orders. A macro
 * because the descriptors are public names; the code is `march`, qv_march or a port's twin of
 * it, and qv_march_back.
 */
#define QV_DEFINE_SAMPLING(mode, suffix, storage, read_out, march)                                 \
    static void march_##suffix(qv_light *light, qv_ray *ray, const qv_context *context)            \
    {                                                                                              \
        march(light, ray, context, storage, qv_cell_##mode);                                       \
    }                                                                                              \
    static void march_back_##suffix(qv_light *light, qv_ray *ray, const qv_context *context)       \
    {                                                                                              \
        qv_march_back(light, ray, context, storage, qv_cell_##mode);                               \
    }                                                                                              \
    QV_DESCRIPTOR qv_sampling qv_##mode##_##suffix = {qv_prepare_steps, march_##suffix, read_out,  \
                                                      storage, 0};                                 \
    QV_DESCRIPTOR qv_sampling qv_##mode##_##suffix##_back_to_front = {                             \
        qv_prepare_steps, march_back_##suffix, read_out, storage, 0};

/* The same for every storage of opacity: march8 for entries of 8 bits. */
#define QV_DEFINE_SAMPLINGS(mode, march8)                                                          \
    QV_DEFINE_SAMPLING(mode, rgba8, QV_STORAGE_RGBA8, QV_READ_OUT_8, march8)                       \
    QV_DEFINE_SAMPLING(mode, rgba16, QV_STORAGE_RGBA16, QV_READ_OUT_16, qv_march)                  \
    QV_DEFINE_SAMPLING(mode, indexed8, QV_STORAGE_INDEXED8, QV_READ_OUT_8, march8)                 \
    QV_DEFINE_SAMPLING(mode, indexed8_16, QV_STORAGE_INDEXED8_16, QV_READ_OUT_16, qv_march)

#endif /* QV_MARCH_H */
