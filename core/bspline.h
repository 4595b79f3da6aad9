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

#define QV_BSPLINE_TAPS 27

/* Lower, middle and upper voxel on one axis. */
typedef struct qv_triple {
    qv_offset at[3]; /* bytes from voxel 0 */
    fx_tap tap[2];   /* weights of the lower and the upper one */
} qv_triple;

/* Strides are bytes, or 1 for indices. Unsigned, an index below 0 lies above every size. */
FX_INLINE void qv_triple_locate(qv_triple *triple, uint32_t size, qv_offset stride,
                                const qv_ray *ray, unsigned axis)
{
    uint64_t place = (uint64_t)(ray->place[axis] + ((qv_coord)1 << 31)); /* 1/2: of the voxel */
    uint32_t index = (uint32_t)(place >> 32), last = size - 1u;
    uint32_t fraction = (uint32_t)place >> 24; /* Q0.8 */
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
FX_INLINE void qv_part(fx_weight part[3], fx_weight weight, const qv_triple *triple)
{
    part[0] = fx_weight_tap_mul(weight, triple->tap[0]);
    part[2] = fx_weight_tap_mul(weight, triple->tap[1]);
    part[1] = fx_weight_sub(fx_weight_sub(weight, part[0]), part[2]);
}

/* The same for a weight of 1: the parts sum to exactly 65536, and those of parts too. */
FX_INLINE void qv_part_one(fx_weight part[3], const qv_triple *triple)
{
    part[0] = fx_weight_of_tap(triple->tap[0]);
    part[2] = fx_weight_of_tap(triple->tap[1]);
    part[1] = fx_weight_sub(fx_weight_sub(fx_weight_of(FX_WEIGHT_ONE), part[0]), part[2]);
}

/* One of the nine rows of three voxels: where voxels are at[i] of the x axis from. */
FX_INLINE qv_address qv_row(const qv_triple triple[3], unsigned j, unsigned k,
                            const qv_volume *volume)
{
    return qv_at(qv_at(volume->voxels, triple[2].at[k]), triple[1].at[j]);
}

FX_INLINE qv_address qv_row_entry(qv_address row, const qv_triple *x, unsigned i,
                                  const qv_volume *volume, unsigned storage)
{
    return qv_entry(qv_at(row, x->at[i]), volume, storage);
}

/* The largest opacity of a row. */
FX_INLINE uint32_t qv_row_most(qv_address row, const qv_triple *x, const qv_volume *volume,
                               unsigned storage)
{
    uint32_t a = qv_opacity_bits(qv_row_entry(row, x, 0, volume, storage), storage);
    uint32_t b = qv_opacity_bits(qv_row_entry(row, x, 1, volume, storage), storage);
    uint32_t c = qv_opacity_bits(qv_row_entry(row, x, 2, volume, storage), storage);
    return (a | b | c) == 0 ? 0 : qv_larger(qv_larger(a, b), c);
}

/* Whether one of the 27 voxels has opacity. Most samples that are not in the void find it in
   their first row. */
FX_INLINE int qv_rows_any(const qv_triple triple[3], const qv_volume *volume, unsigned storage)
{
    for (unsigned k = 0; k < 3; k++)
        for (unsigned j = 0; j < 3; j++)
            if (qv_row_most(qv_row(triple, j, k, volume), &triple[0], volume, storage) != 0)
                return 1;
    return 0;
}

/* The largest opacity of the 27 voxels. */
FX_INLINE uint32_t qv_rows_most(const qv_triple triple[3], const qv_volume *volume,
                                unsigned storage)
{
    uint32_t most = 0;
    for (unsigned k = 0; k < 3; k++)
        for (unsigned j = 0; j < 3; j++)
            most = qv_larger(
                most, qv_row_most(qv_row(triple, j, k, volume), &triple[0], volume, storage));
    return most;
}

/* The sums over all voxels, each with its part of 1. */
FX_INLINE void qv_add_rows(qv_sample *sum, const qv_triple triple[3], const qv_volume *volume,
                           unsigned storage, qv_factor factor)
{
    fx_weight slice[3], row[3], voxel[3];
    qv_part_one(slice, &triple[2]);
    for (unsigned k = 0; k < 3; k++) {
        qv_part(row, slice[k], &triple[1]);
        for (unsigned j = 0; j < 3; j++) {
            qv_address at = qv_row(triple, j, k, volume);
            qv_part(voxel, row[j], &triple[0]);
            FX_UNROLL
            for (unsigned i = 0; i < 3; i++)
                qv_add_voxel(sum, voxel[i], qv_row_entry(at, &triple[0], i, volume, storage),
                             storage, factor);
        }
    }
}

/* Whether there is anything to see; and the scale of extinctions of stored opacities. */
FX_INLINE int qv_rows_begin(qv_sample *sum, const qv_triple triple[3], const qv_volume *volume,
                            unsigned storage, qv_factor factor)
{
    sum->scale = 0;
    if (factor != QV_BY_DENSITY)
        return qv_rows_any(triple, volume, storage);
    uint32_t most = qv_rows_most(triple, volume, storage);
    if (most == 0)
        return 0;
    sum->scale = qv_density_scale(most, storage);
    return 1;
}

FX_INLINE int qv_bspline(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                         unsigned storage, qv_factor factor)
{
    qv_triple triple[3];
    qv_triple_locate(&triple[0], volume->size[0], (qv_offset)volume->stride[0], ray, 0);
    qv_triple_locate(&triple[1], volume->size[1], (qv_offset)volume->stride[1], ray, 1);
    qv_triple_locate(&triple[2], volume->size[2], (qv_offset)volume->stride[2], ray, 2);
    if (!qv_rows_begin(sample, triple, volume, storage, factor))
        return 0;
    sample->opacity = fx_share_of(0);
    sample->light[0] = sample->light[1] = sample->light[2] = fx_sum_of(0);
    qv_add_rows(sample, triple, volume, storage, factor);
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
