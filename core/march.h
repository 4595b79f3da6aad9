/*
 * march.h - the loop over a ray's samples, which every sampling mode shares.
 *
 * Modes and storage are constants at each call, and all of it is inlined.
 */
#ifndef QV_MARCH_H
#define QV_MARCH_H

#include "composite.h"
#include "sample.h"

/* Modes that know no lengths take opacities as they are. QV_OK, QV_ERROR_UNIT. */
static inline qv_status qv_steps_check(const qv_scene *scene)
{
    uint32_t unit = scene->volume.unit_distance;
    return unit != 0 && unit != scene->camera.step ? QV_ERROR_UNIT : QV_OK;
}

/* What they make of a scene: nothing but that check and the volume's. */
qv_status qv_prepare_steps(qv_context *context, const qv_scene *scene);

FX_INLINE void qv_advance(qv_ray *ray)
{
    FX_UNROLL
    for (unsigned axis = 0; axis < 3; axis++)
        ray->place[axis] += ray->advance[axis];
}

/* A mode that advances the ray too. */
typedef int qv_taking(qv_sample *sample, qv_ray *ray, const qv_volume *volume, unsigned storage);

/* Advances the ray while its place is at hand: qv_take_MODE. */
#define QV_TAKE_CELL(mode)                                                                         \
    FX_INLINE int qv_take_##mode(qv_sample *sample, qv_ray *ray, const qv_volume *volume,          \
                                 unsigned storage)                                                 \
    {                                                                                              \
        qv_cell cell;                                                                              \
        qv_cell_locate(&cell, volume, ray);                                                        \
        qv_advance(ray);                                                                           \
        FX_FORGET();                                                                               \
        return qv_cell_##mode(sample, &cell, volume, storage);                                     \
    }

QV_TAKE_CELL(nearest)
QV_TAKE_CELL(separate)
QV_TAKE_CELL(weighted)

/* Takes a ray's next sample, and advances it; returns 0 where there is nothing to see. */
FX_INLINE int qv_take(uint32_t colour[3], uint32_t *opacity, qv_ray *ray, const qv_volume *volume,
                      unsigned storage, qv_taking *mode)
{
    qv_sample sample;
    if (!mode(&sample, ray, volume, storage))
        return 0;
    for (unsigned c = 0; c < 3; c++)
        colour[c] = fx_sum_bits(sample.light[c]);
    *opacity = qv_opacity_q32(sample.opacity, storage);
    return 1;
}

/* Front to back. ray->samples counts down to those that were not taken. */
FX_INLINE void qv_march(qv_light *light, qv_ray *ray, const qv_context *context, unsigned storage,
                        qv_taking *mode)
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
                             unsigned storage, qv_taking *mode)
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
 * A target with marches of its own, in vectors or in assembly, names a header in
 * QV_MARCH_HEADER that defines qv_march_twin: it does the same as qv_march, or qv_march_back if
 * `back` is set, to the last bit, and returns 1; or it does nothing and returns 0, for scenes that
 * it leaves alone.
 */
#ifdef QV_MARCH_HEADER
#include QV_MARCH_HEADER
#else
FX_INLINE int qv_march_twin(qv_light *light, qv_ray *ray, const qv_context *context,
                            unsigned storage, qv_taking *mode, int back)
{
    (void)light;
    (void)ray;
    (void)context;
    (void)storage;
    (void)mode;
    (void)back;
    return 0;
}
#endif

/*
 * Defines the sampling mode qv_MODE_SUFFIX for a storage, in both orders. A macro
 * because the descriptors are public names; the code is qv_march.
 */
#define QV_DEFINE_SAMPLING(mode, suffix, prepare, sample, read_out, storage)                       \
    static void march_##suffix(qv_light *light, qv_ray *ray, const qv_context *context)            \
    {                                                                                              \
        if (!qv_march_twin(light, ray, context, storage, sample, 0))                               \
            qv_march(light, ray, context, storage, sample);                                        \
    }                                                                                              \
    static void march_back_##suffix(qv_light *light, qv_ray *ray, const qv_context *context)       \
    {                                                                                              \
        if (!qv_march_twin(light, ray, context, storage, sample, 1))                               \
            qv_march_back(light, ray, context, storage, sample);                                   \
    }                                                                                              \
    QV_DESCRIPTOR qv_sampling qv_##mode##_##suffix = {prepare, march_##suffix, read_out, storage,  \
                                                      0};                                          \
    QV_DESCRIPTOR qv_sampling qv_##mode##_##suffix##_back_to_front = {                             \
        prepare, march_back_##suffix, read_out, storage, 0};

#define QV_DEFINE_STEPS(mode, suffix, read_out, storage)                                           \
    QV_DEFINE_SAMPLING(mode, suffix, qv_prepare_steps, qv_take_##mode, read_out, storage)

/* DEFINE for each storage that modes without lengths take. */
#define QV_STEPS_ENTRIES(DEFINE, mode)                                                             \
    DEFINE(mode, rgba8, QV_READ_OUT_8, QV_STORAGE_RGBA8)                                           \
    DEFINE(mode, rgba16, QV_READ_OUT_16, QV_STORAGE_RGBA16)
#define QV_STEPS_INDEXED(DEFINE, mode)                                                             \
    DEFINE(mode, indexed8, QV_READ_OUT_8, QV_STORAGE_INDEXED8)                                     \
    DEFINE(mode, indexed8_16, QV_READ_OUT_16, QV_STORAGE_INDEXED8_16)
#define QV_EACH_STEPS(DEFINE, mode)                                                                \
    QV_STEPS_ENTRIES(DEFINE, mode)                                                                 \
    QV_STEPS_INDEXED(DEFINE, mode)

#endif /* QV_MARCH_H */
