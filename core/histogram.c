/*
 * Source: Williams et al., alpha dithering for 8-bit compositing: section 6, equation 12,
 * figure 41.
 */
#include "qvol.h"

#include "fx_log.h"
#include "fx_wide.h"

/* 257 / ln 2, Q9.22: 257 units of 16 bits are a level, and logarithms are in base 2. */
#define UNITS_BY_LN2 1555133106u

/* A histogram and the counts of which its bins are peaks; 0: none are. */
typedef struct bins {
    const uint32_t *counts;
    uint32_t peak;
} bins;

static int is_peak(const bins *of, unsigned bin)
{
    return bin < QV_PALETTE_ENTRIES && of->peak != 0 && of->counts[bin] >= of->peak;
}

/* Whether a bin is a peak or beside one; bin - 1 of bin 0 is none. */
static int at_peak(const bins *of, unsigned bin)
{
    return is_peak(of, bin - 1u) || is_peak(of, bin) || is_peak(of, bin + 1u);
}

/* The mean of a bin's count and those beside it that have a peak's opacity: what they hold
   beside the peak shall not go unseen. To nearest, ties upwards. */
static uint32_t mean_count(const bins *of, unsigned bin)
{
    uint64_t sum = of->counts[bin]; /* at most 3 * 2^32 */
    uint32_t n = 1;
    if (is_peak(of, bin - 2u)) {
        sum += of->counts[bin - 1u];
        n++;
    }
    if (is_peak(of, bin + 2u)) {
        sum += of->counts[bin + 1u];
        n++;
    }
    return (uint32_t)fx_divide(sum + n / 2u, n);
}

/* scale / ln(count) levels, Q16.16, in 16 bits; equation 12. The logarithm in base 2 is Q6.32,
   at most 32; with 6 bits more it has the fraction bits of the product, 16 + 22. */
static uint16_t opacity_of_count(uint32_t count, uint32_t scale)
{
    if (count <= 1)
        return 65535u;
    fx_depth logarithm = ((fx_depth)32 << 32) - fx_depth_of_transmittance(count);
    return fx_quotient16(fx_wide_product(scale, UNITS_BY_LN2), logarithm << 6);
}

qv_status qv_transfer_from_histogram(qv_transfer *table, const uint32_t histogram[256],
                                     uint32_t scale, uint32_t peak, uint16_t peak_opacity)
{
    if (!table || !histogram)
        return QV_ERROR_NULL;
    const bins of = {histogram, peak};
    for (unsigned v = 0; v < QV_PALETTE_ENTRIES; v++)
        table->rgba[v][3] =
            at_peak(&of, v) ? peak_opacity : opacity_of_count(mean_count(&of, v), scale);
    return QV_OK;
}
