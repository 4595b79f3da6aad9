/*
 * march_walk.h - marches in assembly (QV_MARCH_HEADER), of opacity-weighted samples of 8-bit
 * entries, for families that share how a ray is handed to it. It lies in cortex-m/march_thumb2.S
 * (all of them), in cortex-m/march_thumb1.S and riscv/march_rv32im.S (RGBA8, from front to back);
 * what there is no assembly for is left to the C of core/march.h, which includes this file.
 */
#ifndef MARCH_WALK_H
#define MARCH_WALK_H

#include "composite.h"
#include "march.h"
#include "ray.h"
#include "storage.h"

/* An axis of a walk. */
typedef struct walk_axis {
    uint32_t place[2], advance[2]; /* of qv_ray, the lower words first */
    uint32_t last;                 /* index of the last voxel */
    int32_t stride;
} walk_axis;

/* What the assembly walks through, word by word in this order. */
typedef struct march_walk {
    qv_address palette;
    uint32_t skipped;
    uint32_t colour[3]; /* of qv_light */
    uint32_t taken;     /* the complement of its transmittance */
    uint32_t samples;   /* that remain */
    uint32_t enough;    /* transmittance below which the ray ends, from front to back */
    walk_axis x;
    qv_address voxels;
    walk_axis y, z;
    uint32_t weights[6]; /* its own */
} march_walk;

/* Take samples, of which there is at least one, until none remain or light is enough. */
void walk_march_rgba8(march_walk *walk);
void walk_march_back_rgba8(march_walk *walk);
void walk_march_indexed8(march_walk *walk);
void walk_march_back_indexed8(march_walk *walk);

FX_INLINE void walk_axis_of(walk_axis *of, const qv_ray *ray, const qv_volume *volume,
                            unsigned axis)
{
    uint64_t place = (uint64_t)ray->place[axis], advance = (uint64_t)ray->advance[axis];
    of->place[0] = (uint32_t)place;
    of->place[1] = (uint32_t)(place >> 32);
    of->advance[0] = (uint32_t)advance;
    of->advance[1] = (uint32_t)(advance >> 32);
    of->last = volume->size[axis] - 1u;
    of->stride = volume->stride[axis];
}

FX_INLINE void walk_set_out(march_walk *walk, const qv_light *light, const qv_ray *ray,
                            const qv_context *context)
{
    const qv_volume *volume = &context->scene.volume;
    for (unsigned c = 0; c < 3; c++)
        walk->colour[c] = light->colour[c];
    walk->taken = ~light->transmittance;
    walk->samples = ray->samples;
    walk->enough = ((uint32_t)context->scene.termination << 15) + 1u; /* Q0.16 to Q1.31 */
    walk_axis_of(&walk->x, ray, volume, 0);
    walk_axis_of(&walk->y, ray, volume, 1);
    walk_axis_of(&walk->z, ray, volume, 2);
    walk->voxels = volume->voxels;
    walk->palette = volume->palette;
    walk->skipped = light->skipped;
}

FX_INLINE void walk_through(march_walk *walk, unsigned storage, int back)
{
    if (qv_storage_indexed(storage) && back)
        walk_march_back_indexed8(walk);
    else if (qv_storage_indexed(storage))
        walk_march_indexed8(walk);
    else if (back)
        walk_march_back_rgba8(walk);
    else
        walk_march_rgba8(walk);
}

/* Whether there is assembly for it. */
FX_INLINE int walk_marches(unsigned storage, qv_taking *mode, int back)
{
    if (mode != qv_take_weighted)
        return 0;
#if defined(__ARM_ARCH_ISA_THUMB) && __ARM_ARCH_ISA_THUMB >= 2
    (void)back;
    return qv_channel_bytes(storage) == 1;
#else
    return storage == QV_STORAGE_RGBA8 && !back;
#endif
}

/* The ray is left where it was clipped: nobody looks where it stands. */
FX_INLINE int qv_march_twin(qv_light *light, qv_ray *ray, const qv_context *context,
                            unsigned storage, qv_taking *mode, int back)
{
    march_walk walk;
    if (!walk_marches(storage, mode, back))
        return 0;
    qv_ray_clip(ray, context);
    if (ray->samples == 0)
        return 1;
    if (back)
        qv_reverse(ray);
    walk_set_out(&walk, light, ray, context);
    walk_through(&walk, storage, back);
    for (unsigned c = 0; c < 3; c++)
        light->colour[c] = walk.colour[c];
    light->transmittance = ~walk.taken;
    light->skipped = walk.skipped;
    light->terminated = walk.samples != 0;
    ray->samples = walk.samples;
    return 1;
}

#endif /* MARCH_WALK_H */
