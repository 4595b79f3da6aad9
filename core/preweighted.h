/*
 * preweighted.h - sampling of associated colours: few bits, few instructions.
 *
 * A voxel is one word, whose four channels are interpolated two at a time, in the halves of
 * a word. Between the rows of a cell that run along x, weights have 8 bits; the rest, along
 * x, is done by compositing, which multiplies anyway.
 *
 *   weight   Q1.8    of a row; the four of a cell sum to 256
 *   sum      Q0.16   weights * channel; 255 * 256 is 1
 *   share    Q1.16   of the light that still gets through: 65536 is 1
 *   light            share * sum, and sums of them; QV_WHOLE is 1
 *
 * Sums of weights times channels are at most 255 * 256, so that they stay in their halves.
 */
#ifndef QV_PREWEIGHTED_H
#define QV_PREWEIGHTED_H

#include "access.h"
#include "fx_inline.h"

/* 1 in units of light, and as much more as a transmittance begins with: from what remains of
   it, 65536, or less, nothing gets through. */
#define QV_WHOLE      0xFF000000u
#define QV_NOTHING    0x00010000u
#define QV_UNDIMMED   (QV_WHOLE + QV_NOTHING)
#define QV_HALVES     0x00FF00FFu
#define QV_WEIGHT_ALL 256u

/*
 * Samples of a ray whose cells have the same steps from voxel to voxel: all of those between
 * the outermost voxel centres, or those beyond them that are clamped alike. Twins know the order of
 * the fields.
 */
typedef struct qv_passage {
    qv_offset next[3];   /* to a voxel's neighbour on each axis; 0 where clamped */
    uint32_t advance[3]; /* from sample to sample, fraction bits of Q31.32 */
    qv_offset step;      /* the same, whole voxels */
    uint32_t place[3];   /* of the next sample in its cell, Q0.32 */
    qv_address base;     /* voxel with the lowest indices of the next sample's cell */
    uint32_t light[3];
    uint32_t transmittance; /* QV_UNDIMMED at first */
    uint32_t samples;       /* that remain */
    uint32_t enough;        /* transmittance at or below which the ray ends */
    uint32_t skipped;       /* samples that had no opacity */
} qv_passage;

/*
 * Composites the samples of a passage, 1 or more, until none remain or its transmittance is at
 * most `enough`. A port may name a header in QV_PASSAGE_HEADER that defines a twin of
 * qv_passage_under; base and place, which are of no use afterwards, need not be the same.
 */
void qv_passage_under(qv_passage *passage);
void qv_passage_over(qv_passage *passage);

/* Sums of two rows' ends: of red and blue, of green and opacity, in the halves of a word. */
typedef struct qv_end {
    uint32_t red_blue, green_opacity;
} qv_end;

/* The ends of a cell's rows at the lower x and at the higher, and how far between them the
   sample lies, Q0.8. */
typedef struct qv_ends {
    qv_end low, high;
    uint32_t fraction;
} qv_ends;

FX_INLINE void qv_end_add(qv_end *end, uint32_t weight, qv_address voxel)
{
    uint32_t channels = qv_read32(voxel);
    end->red_blue += weight * (channels & QV_HALVES);
    end->green_opacity += weight * (channels >> 8 & QV_HALVES);
}

FX_INLINE void qv_row_add(qv_ends *ends, uint32_t weight, qv_address row, qv_offset along)
{
    qv_end_add(&ends->low, weight, row);
    qv_end_add(&ends->high, weight, qv_at(row, along));
}

/* Takes a passage one sample on, on one axis: to the next voxel where the fraction wraps. */
FX_INLINE void qv_passage_step(qv_passage *passage, unsigned axis)
{
    uint32_t advance = passage->advance[axis], place = passage->place[axis] + advance;
    passage->place[axis] = place;
    if (place < advance)
        passage->base = qv_at(passage->base, passage->next[axis]);
}

/*
 * The sums of the next sample, which is then behind. Of the weights only y z / 256 is rounded,
 * by 1/2 at most, and each holds it once: they sum to 256, none is negative, and each channel
 * is off by at most 1/512 of |v00 - v10 - v01 + v11|.
 */
FX_INLINE void qv_passage_next(qv_ends *ends, qv_passage *passage)
{
    uint32_t y = passage->place[1] >> 24, z = passage->place[2] >> 24;
    uint32_t both = (y * z + 128u) >> 8, only_y = y - both, only_z = z - both;
    qv_offset along = passage->next[0], across = passage->next[1];
    qv_address row = passage->base, above = qv_at(row, passage->next[2]);
    ends->low.red_blue = 0;
    ends->low.green_opacity = 0;
    ends->high = ends->low;
    ends->fraction = passage->place[0] >> 24;
    qv_row_add(ends, QV_WEIGHT_ALL - y - only_z, row, along);
    qv_row_add(ends, only_y, qv_at(row, across), along);
    qv_row_add(ends, only_z, above, along);
    qv_row_add(ends, both, qv_at(above, across), along);
    passage->base = qv_at(passage->base, passage->step);
    for (unsigned axis = 0; axis < 3; axis++)
        qv_passage_step(passage, axis);
    passage->samples--;
}

/* The share of what gets through, or of what has been gathered: at most v / (255 * 256), and
   less than 2.01 below it. 1 / 255 = 2^-8 + 2^-16 + ... */
FX_INLINE uint32_t qv_share_of(uint32_t v)
{
    return (v >> 16) + (v >> 24);
}

#endif /* QV_PREWEIGHTED_H */
