#include "composite.h"
#include "fx_wide.h"
#include "qvol.h"

static uint32_t clamp(uint32_t level)
{
    return level < QV_LEVEL_ONE ? level : QV_LEVEL_ONE;
}

/* Equation 9. Light of a row is Q10.21, of a pixel Q10.20, and goes to levels with 16 fraction
   bits. */
static void row(uint32_t *sums, const uint16_t *weights, unsigned count, const uint32_t light[4])
{
    for (unsigned i = 0; i < count; i++, sums += QV_SUM_CHANNELS) {
        uint32_t opacity = clamp((fx_product_shift16(light[3], weights[i]) + 8u) >> 4);
        uint32_t covered = qv_part_of_level(opacity);
        for (unsigned c = 0; c < QV_SUM_CHANNELS; c++) {
            uint32_t level = clamp((fx_product_shift16(light[c], weights[i]) + 8u) >> 4);
            sums[c] = clamp(sums[c] - fx_high_product(sums[c], covered) + level);
        }
    }
}

QV_DESCRIPTOR qv_splatting qv_splatting_over = {row, 0};
