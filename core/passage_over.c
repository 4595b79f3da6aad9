#include "preweighted.h"

/* Between the two ends of the rows: Q0.16 as they are, cut. */
static uint32_t between(uint32_t low, uint32_t high, uint32_t fraction)
{
    return (low * (256u - fraction) + high * fraction) >> 8; /* <= 255 * 2^16 */
}

/*
 * Light, or transmittance, behind an opacity. At most its share of the opacity is lost, so that
 * nothing wraps; light grows no more once it is QV_WHOLE + 65536, and so stays below 2^32.
 */
static uint32_t behind(uint32_t v, uint32_t opacity)
{
    return v - opacity * qv_share_of(v);
}

void qv_passage_over(qv_passage *passage)
{
    while (passage->samples != 0) {
        qv_ends ends;
        qv_passage_next(&ends, passage);
        const qv_end *low = &ends.low, *high = &ends.high;
        uint32_t fraction = ends.fraction;
        uint32_t opacity = between(low->green_opacity >> 16, high->green_opacity >> 16, fraction);
        if (opacity == 0) {
            passage->skipped++;
            continue;
        }
        const uint32_t colour[3] = {
            between(low->red_blue & 0xFFFFu, high->red_blue & 0xFFFFu, fraction),
            between(low->green_opacity & 0xFFFFu, high->green_opacity & 0xFFFFu, fraction),
            between(low->red_blue >> 16, high->red_blue >> 16, fraction)};
        for (unsigned c = 0; c < 3; c++)
            passage->light[c] = behind(passage->light[c], opacity) + (colour[c] << 16);
        passage->transmittance = behind(passage->transmittance, opacity);
    }
}
