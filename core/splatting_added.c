#include "fx_wide.h"
#include "qvol.h"

/* a + b, but at most 2^32 - 1: whatever the order, a sum of many ends the same. */
static uint32_t sum_of(uint32_t a, uint32_t b)
{
    uint32_t sum = a + b;
    return sum < a ? 0xFFFFFFFFu : sum;
}

/* Light of a row is Q10.21, of a pixel Q10.20, and goes to levels with 16 fraction bits. */
static void row(uint32_t *sums, const uint16_t *weights, unsigned count, const uint32_t light[4])
{
    for (unsigned i = 0; i < count; i++, sums += QV_SUM_CHANNELS)
        for (unsigned c = 0; c < QV_SUM_CHANNELS; c++)
            sums[c] = sum_of(sums[c], (fx_product_shift16(light[c], weights[i]) + 8u) >> 4);
}

const qv_splatting qv_splatting_added = {row, 1};
