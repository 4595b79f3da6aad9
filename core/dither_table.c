/*
 * Source: Williams et al., alpha dithering for 8-bit compositing: sections 5 and 6, table 3.
 */
#include "blend.h"
#include "fx_unorm.h"
#include "ray.h"

static int is_period(uint8_t period)
{
    return period >= 2 && period <= 64;
}

uint32_t qv_dither_table_bytes(uint8_t period, uint8_t entry_bytes)
{
    if (!is_period(period) || (entry_bytes != 1 && entry_bytes != 4))
        return 0;
    return (uint32_t)QV_PALETTE_ENTRIES * period * entry_bytes;
}

uint8_t qv_dither_table_place(uint8_t period, int32_t slice, uint32_t frame, int32_t x, int32_t y)
{
    if (!is_period(period))
        return 0;
    fx_period of = fx_period_of(period);
    uint32_t phase = fx_phase(&of, (uint32_t)QV_GRID_LIMIT - (uint32_t)slice + frame);
    return (uint8_t)qv_phase_shifted(&of, phase, qv_dither_shift(1, x, y));
}

/* Levels with 16 fraction bits of 16 bits, to nearest: 65535 is 255 * 65536. */
static uint32_t level_of(uint16_t opacity)
{
    uint32_t product = opacity * (uint32_t)255;
    return product + ((product + 32768u) >> 16);
}

/* The entry of a value at a phase: colours are weighted by the dithered opacity, never dithered
   apart (section 5), and rounded to nearest: at most the opacity. */
static void write_entry(uint8_t *to, uint8_t entry_bytes, const uint16_t rgba[4],
                        const fx_alpha *alpha, uint32_t phase)
{
    uint32_t opacity = fx_alpha_ordered(alpha, level_of(rgba[3]), phase);
    for (unsigned c = 0; c + 1u < entry_bytes; c++)
        to[c] = (uint8_t)fx_div65535_round(rgba[c] * opacity);
    to[entry_bytes - 1u] = (uint8_t)opacity;
}

/*
 * All places of a value. Place p has phase p + value, modulo the period: the pattern is turned
 * by 1 from value to value. Hits of a pattern lie at least floor(period / hits) apart, so that
 * as many equal neighbours never hit together; as in table 3.
 */
static void write_value(uint8_t *to, uint8_t entry_bytes, const uint16_t rgba[4],
                        const fx_alpha *alpha, uint16_t value)
{
    uint32_t phase = fx_phase(&alpha->period, value);
    for (uint32_t place = 0; place < alpha->period.slices; place++) {
        size_t entry = (size_t)(QV_PALETTE_ENTRIES * place + value); /* below 2^14 */
        write_entry(to + entry * entry_bytes, entry_bytes, rgba, alpha, phase);
        phase = phase + 1u < alpha->period.slices ? phase + 1u : 0;
    }
}

qv_status qv_dither_table_build(void *to, size_t bytes, uint8_t entry_bytes,
                                const qv_dither *dither, const qv_transfer *transfer,
                                uint16_t first, uint16_t end)
{
    if (!to || !dither || !transfer)
        return QV_ERROR_NULL;
    if ((entry_bytes != 1 && entry_bytes != 4) || first >= end || end > QV_PALETTE_ENTRIES)
        return QV_ERROR_SIZE;
    fx_alpha alpha;
    if (qv_alpha_of(&alpha, dither) != QV_OK)
        return QV_ERROR_DITHER;
    if (bytes < qv_dither_table_bytes(dither->period, entry_bytes))
        return QV_ERROR_BUFFER;
    for (uint16_t value = first; value < end; value++)
        write_value(to, entry_bytes, transfer->rgba[value], &alpha, value);
    return QV_OK;
}
