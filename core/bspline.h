/*
 * bspline.h - reconstruction by the triquadratic B-spline: 27 voxels, smooth where
 * trilinear interpolation shows its cells.
 *
 * On each axis, the voxel that contains the point and its two neighbours, whose indices
 * are clamped to the volume. With f the place within the voxel, 0 .. 1, their weights are
 * (1-f)^2 / 2, the rest, and f^2 / 2.
 *
 * Source: Sigg and Hadwiger 2005, as used by Kraus and Buerger 2008, section 4.2.
 */
#ifndef QV_BSPLINE_H
#define QV_BSPLINE_H

#include "sample.h"

/* Lower, middle and upper voxel on one axis. */
typedef struct qv_triple {
    qv_offset at[3]; /* bytes from voxel 0 */
    fx_tap tap[2];   /* weights of the lower and the upper one */
} qv_triple;

/* Unsigned, an index below 0 lies above every size. */
FX_INLINE void qv_triple_locate(qv_triple *triple, const qv_volume *volume, const qv_ray *ray,
                                unsigned axis)
{
    uint64_t place = (uint64_t)(ray->place[axis] + ((qv_coord)1 << 31)); /* 1/2: of the voxel */
    uint32_t index = (uint32_t)(place >> 32), last = volume->size[axis] - 1u;
    uint32_t fraction = (uint32_t)place >> 24; /* Q0.8 */
    qv_offset stride = (qv_offset)volume->stride[axis];
    uint32_t middle = index > QV_AXIS_MAX ? 0 : index < last ? index : last;
    triple->at[1] = (qv_offset)middle * stride;
    triple->at[0] = triple->at[1] - (index - 1u < last ? stride : 0);
    triple->at[2] = triple->at[1] + (index < last ? stride : 0);
    triple->tap[0] = fx_tap_of_square(256u - fraction);
    triple->tap[1] = fx_tap_of_square(fraction);
}

/*
 * A weight parted among three voxels: rounded for the outer two, the rest for the middle.
 * The taps sum to at most 1/2, so both roundings upwards leave weight / 2 - 1; and for a
 * weight of 1 only one product can reach 1/2. What is left is never negative.
 */
FX_INLINE void qv_part(fx_weight *lower, fx_weight *middle, fx_weight *upper, fx_weight weight,
                       const qv_triple *triple)
{
    *lower = fx_weight_tap_mul(weight, triple->tap[0]);
    *upper = fx_weight_tap_mul(weight, triple->tap[1]);
    *middle = fx_weight_sub(fx_weight_sub(weight, *lower), *upper);
}

/* The 27 weights, x fastest, then y, then z: they sum to exactly 65536, as every voxel's
   weight is parted without remainder. 26 multiplications, 26 additions. */
FX_INLINE void qv_bspline_weights(fx_weight weight[QV_MOST_TAPS], const qv_triple triple[3])
{
    fx_weight z[3], y[3];
    qv_part(&z[0], &z[1], &z[2], fx_weight_of(FX_WEIGHT_ONE), &triple[2]);
    for (unsigned k = 0; k < 3; k++) {
        qv_part(&y[0], &y[1], &y[2], z[k], &triple[1]);
        for (unsigned j = 0; j < 3; j++) {
            fx_weight *row = weight + 9u * k + 3u * j;
            qv_part(&row[0], &row[1], &row[2], y[j], &triple[0]);
        }
    }
}

/* The entries of the 27 voxels in the same order; returns whether one has opacity. */
FX_INLINE int qv_bspline_entries(qv_address entry[QV_MOST_TAPS], const qv_triple triple[3],
                                 const qv_volume *volume, unsigned storage)
{
    uint32_t any = 0;
    for (unsigned k = 0; k < 3; k++)
        for (unsigned j = 0; j < 3; j++) {
            qv_address row = qv_at(qv_at(volume->voxels, triple[2].at[k]), triple[1].at[j]);
            for (unsigned i = 0; i < 3; i++) {
                qv_address voxel = qv_entry(qv_at(row, triple[0].at[i]), volume, storage);
                any |= qv_opacity_bits(voxel, storage);
                entry[9u * k + 3u * j + i] = voxel;
            }
        }
    return any != 0;
}

FX_INLINE int qv_bspline(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                         unsigned storage, qv_factor factor)
{
    qv_triple triple[3];
    qv_address entry[QV_MOST_TAPS];
    fx_weight weight[QV_MOST_TAPS];
    for (unsigned axis = 0; axis < 3; axis++)
        qv_triple_locate(&triple[axis], volume, ray, axis);
    if (!qv_bspline_entries(entry, triple, volume, storage))
        return 0;
    qv_bspline_weights(weight, triple);
    qv_accumulate(sample, weight, entry, QV_MOST_TAPS, storage, factor);
    return 1;
}

/* By opacity, or by stored extinction. */
FX_INLINE int qv_bspline_weighted(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                                  unsigned storage)
{
    return qv_bspline(sample, ray, volume, storage, QV_BY_SHARE);
}

/* By the extinction of stored opacity. */
FX_INLINE int qv_bspline_converted(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                                   unsigned storage)
{
    return qv_bspline(sample, ray, volume, storage, QV_BY_DENSITY);
}

#endif /* QV_BSPLINE_H */
