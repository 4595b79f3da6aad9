#include "fx_wide.h"
#include "qvol.h"
#include "sum.h"

/* Light of a row is Q10.21, of a pixel Q10.20, and goes to levels with 16 fraction bits. */
static void row(uint32_t *sums, const uint16_t *weights, unsigned count, const uint32_t light[4])
{
    for (unsigned i = 0; i < count; i++, sums += QV_SUM_CHANNELS)
        for (unsigned c = 0; c < QV_SUM_CHANNELS; c++)
            sums[c] = qv_sum_of(sums[c], (fx_product_shift16(light[c], weights[i]) + 8u) >> 4);
}

QV_DESCRIPTOR qv_splatting qv_splatting_added = {row, 1};
