/*
 * march_twin.h - qv_march by a twin in assembly (QV_TWIN_HEADER): opacity-weighted samples of
 * 8-bit entries, front to back, with the bits of C.
 */
#ifndef MARCH_TWIN_H
#define MARCH_TWIN_H

#include "march.h"

typedef struct twin_axis {
    uint32_t place[2], advance[2]; /* of qv_ray, the lower words first */
    uint32_t last;                 /* index of the last voxel */
    int32_t stride;
} twin_axis;

/* What the twins walk through: their offsets, in words, stand in march_*.S. */
typedef struct twin_walk {
    uint32_t colour[3]; /* of qv_light */
    uint32_t taken;     /* the complement of its transmittance */
    uint32_t samples;   /* that remain */
    uint32_t enough;    /* transmittance below which the ray ends */
    twin_axis x;
    qv_address voxels;
    twin_axis y, z;
    uint32_t weights[6]; /* for the twin */
    qv_address palette;
    uint32_t skipped;
} twin_walk;

/* Takes samples, of which there is at least one, until none remain or the transmittance is below
   `enough`. */
void twin_march_rgba8(twin_walk *walk);
void twin_march_indexed8(twin_walk *walk);

FX_INLINE void twin_axis_of(twin_axis *of, const qv_ray *ray, const qv_volume *volume,
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

/* As qv_march does, up to where the ray stands afterwards. */
FX_INLINE void twin_march(qv_light *light, qv_ray *ray, const qv_context *context, unsigned storage,
                          qv_taking *mode)
{
    (void)mode;
    const qv_volume *volume = &context->scene.volume;
    twin_walk walk;
    qv_ray_clip(ray, context);
    if (ray->samples == 0)
        return;
    for (unsigned c = 0; c < 3; c++)
        walk.colour[c] = light->colour[c];
    walk.taken = ~light->transmittance;
    walk.samples = ray->samples;
    walk.enough = ((uint32_t)context->scene.termination << 15) + 1u;
    walk.voxels = volume->voxels;
    walk.palette = volume->palette;
    walk.skipped = light->skipped;
    twin_axis_of(&walk.x, ray, volume, 0);
    twin_axis_of(&walk.y, ray, volume, 1);
    twin_axis_of(&walk.z, ray, volume, 2);
    if (qv_storage_indexed(storage))
        twin_march_indexed8(&walk);
    else
        twin_march_rgba8(&walk);
    for (unsigned c = 0; c < 3; c++)
        light->colour[c] = walk.colour[c];
    light->transmittance = ~walk.taken;
    light->skipped = walk.skipped;
    light->terminated = walk.samples != 0;
    ray->samples = walk.samples;
}

#define QV_MARCH_WEIGHTED8 twin_march

#endif /* MARCH_TWIN_H */
