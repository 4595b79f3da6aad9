/*
 * ray.h - the samples of one ray.
 */
#ifndef QV_RAY_H
#define QV_RAY_H

#include "fx_inline.h"
#include "fx_wide.h"
#include "qvol.h"

/* The sample numbers k of a ray lie in -QV_GRID_LIMIT .. QV_GRID_LIMIT - 1. */
#define QV_GRID_LIMIT 0x400000

/* From voxel coordinates to those that sampling wants: less 1/2, so that whole numbers
   are voxel centres, plus 1/512, so that cutting to 8 fraction bits rounds to nearest. */
#define QV_CENTRED (((qv_coord)1 << 23) - ((qv_coord)1 << 31))

/*
 * A ray. As a projection makes it, place is the point of sample 0 in voxel coordinates. As
 * a mode samples it, place is the next sample's point plus QV_CENTRED, and samples are
 * those that remain.
 */
typedef struct qv_ray {
    qv_coord place[3];    /* Q31.32, |place| < 2^62 */
    qv_coord advance[3];  /* voxels from sample to sample, Q31.32 */
    int32_t first;        /* least sample number: 0 in perspective, else -QV_GRID_LIMIT */
    uint32_t all;         /* samples in the box */
    uint32_t samples;     /* that remain of them */
    int64_t enter, leave; /* of modes that weigh by length: where the way begins and ends */
} qv_ray;

/* `first` of a ray whose way ends at the borders of one slice: `enter` and `leave` hold them
   before it is clipped. */
#define QV_ONE_SLICE (-QV_GRID_LIMIT - 1)

/*
 * Clips a ray to the box of a scene's volume: from then on it stands at its first sample
 * k >= first with 0 <= p < size on every axis, and all and samples count those up to the
 * last. Exact: the same samples as testing each of them.
 */
void qv_ray_clip(qv_ray *ray, const qv_context *context);

/* Counts a ray's samples from one of them. |place| stays below 2^62 + 2^22 * 2^40. */
void qv_ray_count_from(qv_ray *ray, int32_t sample);

/*
 * Leaves a ray, as its projection made it, sample 0, and no other in reach of the box: clipped, it
 * stands there. Returns 0 where there is no such sample, or it lies outside the box.
 */
int qv_ray_hold(qv_ray *ray, const qv_context *context);

/* The rays of qv_projection_orthographic and qv_projection_perspective. Return whether
   there is one: 0 where the direction is too short. */
int qv_ray_orthographic(qv_ray *ray, const qv_context *context, int32_t x, int32_t y);
int qv_ray_perspective(qv_ray *ray, const qv_context *context, int32_t x, int32_t y);

/* The ray of the pixel to the right of an orthographic ray's that began at `place`: side by side
   they differ by `across` exactly, so this one is that of qv_ray_orthographic, counted from a
   sample. */
static inline void qv_ray_right(qv_ray *ray, qv_coord place[3], const qv_camera *camera,
                                int32_t sample)
{
    for (unsigned axis = 0; axis < 3; axis++) {
        place[axis] += camera->across[axis];
        ray->place[axis] = place[axis];
        ray->advance[axis] = camera->along[axis];
    }
    ray->first = -QV_GRID_LIMIT - sample;
}

/* The point of pixel (x, y): base + x*across + y*down. |x|, |y| < 2^15 and
   components within the ranges of qv_camera keep it below 2^61. */
FX_INLINE qv_coord qv_pixel_point(const qv_coord base[3], const qv_camera *camera, unsigned axis,
                                  int32_t x, int32_t y)
{
    return base[axis] + fx_multiply(camera->across[axis], x) + fx_multiply(camera->down[axis], y);
}

/* phase * v, v in Q31.32 at most 2^40. */
qv_coord qv_phase_of(qv_coord v, uint16_t phase);

#endif /* QV_RAY_H */
