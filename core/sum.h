/*
 * sum.h - sums that stop.
 */
#ifndef QV_SUM_H
#define QV_SUM_H

#include <stdint.h>

#include "fx_inline.h"

/* What a sum that is full holds. */
#define QV_SUM_FULL 0xFFFFFFFFu

/* a + b, but at most QV_SUM_FULL: whatever the order, a sum of many ends the same. */
FX_INLINE uint32_t qv_sum_of(uint32_t a, uint32_t b)
{
    uint32_t sum = a + b;
    return sum < a ? QV_SUM_FULL : sum;
}

#endif /* QV_SUM_H */
