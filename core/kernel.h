/*
 * kernel.h - pre-integrated footprints: how much of a splat each pixel gets.
 *
 * A voxel's kernel is a product of one kernel across the picture and the same down; along the
 * ray it is integrated to 1. Its integral up to the edges between pixels, times the voxel's size,
 * gives each pixel the kernel's mean over it as the difference of two; so the weights of a splat
 * sum to its size, wherever its centre lies.
 */
#ifndef QV_KERNEL_H
#define QV_KERNEL_H

#include "fx_table.h"
#include "qvol.h"

/* Parts of half the width that the tables of integrals tell apart. */
#define QV_KERNEL_PARTS 64u

/* Pixels, Q16.16, that a voxel may be wide: 1/64 .. 4096. */
#define QV_LEAST_WIDTH ((uint32_t)1 << 10)
#define QV_MOST_WIDTH  ((uint32_t)1 << 28)

/* A splat on one axis of the picture. */
typedef struct qv_footprint {
    const qv_kernel *kernel;
    int64_t centre;      /* in pixels, Q47.16; whole numbers are centres of pixels */
    uint32_t size;       /* of the voxel, in pixels, Q16.16 */
    uint32_t half;       /* half the kernel's width, likewise */
    uint32_t reciprocal; /* of half, as fx_reciprocal gives it */
    uint8_t shift;       /* and by how much half was doubled for that */
} qv_footprint;

/* What of a footprint tells its pixels, but no weights: all but the reciprocal and its shift. */
static inline void qv_footprint_place(qv_footprint *footprint, const qv_kernel *kernel,
                                      int64_t centre, uint32_t size)
{
    footprint->kernel = kernel;
    footprint->centre = centre;
    footprint->size = size;
    footprint->half = size / 2u * QV_FIELD(kernel, halves); /* 2^10 .. 3 * 2^27 */
}

void qv_footprint_of(qv_footprint *footprint, const qv_kernel *kernel, int64_t centre,
                     uint32_t size);

/* The pixels first <= k < end that a footprint reaches, of those from `from` to `to`. */
void qv_footprint_range(int32_t *first, int32_t *end, const qv_footprint *footprint, int32_t from,
                        int32_t to);

/* The weight of a pixel, Q1.15: the mean of the kernel over it, at most 1, or 2^-15 more; within
   2^-9 of exact, and 2^-12 for voxels up to a pixel wide. */
uint16_t qv_footprint_weight(const qv_footprint *footprint, int32_t pixel);

/* The weights of `count` pixels side by side. */
void qv_footprint_weights(uint16_t *weights, const qv_footprint *footprint, int32_t pixel,
                          unsigned count);

#endif /* QV_KERNEL_H */
