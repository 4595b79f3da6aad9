#include "preweighted.h"

#ifdef QV_PASSAGE_HEADER
#include QV_PASSAGE_HEADER
#else

/* Light of one channel: of its halves at the two ends of the rows. */
static uint32_t lower(uint32_t low, uint32_t high, uint32_t share_low, uint32_t share_high)
{
    return (low & 0xFFFFu) * share_low + (high & 0xFFFFu) * share_high;
}

static uint32_t upper(uint32_t low, uint32_t high, uint32_t share_low, uint32_t share_high)
{
    return (low >> 16) * share_low + (high >> 16) * share_high;
}

/*
 * The two ends of the rows share what gets through as the sample lies between them. Light and
 * opacity of a sample are taken from the same shares: so no more light is gathered than has been
 * taken from the transmittance, no sum wraps, and a colour is never above the opacity.
 */
void qv_passage_under(qv_passage *passage)
{
    do {
        qv_ends ends;
        qv_passage_next(&ends, passage);
        uint32_t share = qv_share_of(passage->transmittance);
        uint32_t high = share * ends.fraction >> 8, low = share - high; /* share <= 2^16 */
        uint32_t taken = upper(ends.low.green_opacity, ends.high.green_opacity, low, high);
        if (taken == 0) {
            passage->skipped++;
            continue;
        }
        passage->light[0] += lower(ends.low.red_blue, ends.high.red_blue, low, high);
        passage->light[1] += lower(ends.low.green_opacity, ends.high.green_opacity, low, high);
        passage->light[2] += upper(ends.low.red_blue, ends.high.red_blue, low, high);
        passage->transmittance -= taken;
        if (passage->transmittance <= passage->enough)
            return;
    } while (passage->samples != 0);
}

#endif
