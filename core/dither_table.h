/*
 * dither_table.h - which place of a dither table a pixel reads.
 */
#ifndef QV_DITHER_TABLE_H
#define QV_DITHER_TABLE_H

#include "fx_dither.h"
#include "qvol.h"

/* Slices count from 2^22 below sample 0, so that none is negative. */
#define QV_FIRST_SLICE ((int32_t)1 << 22)

/* The place of a slice at a phase, for a pixel of which u is fx_dither_at of 0: over all u each
   place as often as any other, but for 2^-16. At most 63 + 63, less the period. */
static inline uint32_t qv_table_place(const fx_period *period, uint32_t phase, uint32_t u)
{
    uint32_t place = phase + (((u >> 16) * period->slices) >> 16);
    return place < period->slices ? place : place - period->slices;
}

#endif /* QV_DITHER_TABLE_H */
