#include "pixels.h"

#include "fx_unorm.h"

/* A channel as 8 bits, to nearest. */
static uint8_t level8(uint32_t channel)
{
    return (uint8_t)((channel + 0x8000u) >> 16);
}

/* Grey with 16 fraction bits: the three factors sum to 256. */
static uint32_t grey(const qv_pixel *pixel)
{
    const uint32_t *c = pixel->channel; /* each <= 255 * 2^16, so the sum <= 255 * 2^24 */
    return (77u * c[0] + 150u * c[1] + 29u * c[2] + 128u) >> 8;
}

/*
 * Threshold 0 .. 63 of the 8x8 ordered pattern (Bayer): the bits of x ^ y and of
 * y alternate, the lowest bits of the position being the most significant.
 */
static uint32_t threshold(const qv_pixel *pixel)
{
    uint32_t t = 0;
    for (unsigned bit = 0; bit < 3; bit++) {
        uint32_t y = pixel->y >> bit & 1u;
        t = t << 2 | ((pixel->x >> bit & 1u) ^ y) << 1 | y;
    }
    return t;
}

/*
 * A channel on 0 .. top (at most 63): floor(v * top + (2 t + 1) / 128), where v =
 * channel / (255 * 65536). The sum stays below 2^30 + 2^24, its upper part below
 * 65535 as the division asks.
 */
static uint32_t dithered(uint32_t channel, uint32_t top, uint32_t t)
{
    uint32_t offset = (2u * t + 1u) * (255u * 65536u / 128u);
    return fx_div255_floor((channel * top + offset) >> 16);
}

static void store_rgba8888(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)line;
    for (unsigned c = 0; c < 4; c++)
        row[4u * column + c] = level8(pixel->channel[c]);
}

static void store_bgra8888(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)line;
    for (unsigned c = 0; c < 3; c++)
        row[4u * column + 2u - c] = level8(pixel->channel[c]);
    row[4u * column + 3u] = level8(pixel->channel[3]);
}

static void store_rgb888(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)line;
    for (unsigned c = 0; c < 3; c++)
        row[3u * column + c] = level8(pixel->channel[c]);
}

static uint32_t rgb565(const qv_pixel *pixel)
{
    uint32_t t = threshold(pixel);
    return dithered(pixel->channel[0], 31, t) << 11 | dithered(pixel->channel[1], 63, t) << 5 |
           dithered(pixel->channel[2], 31, t);
}

static void store_rgb565_le(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    uint32_t v = rgb565(pixel);
    (void)line;
    row[2u * column] = (uint8_t)(v & 0xFFu);
    row[2u * column + 1u] = (uint8_t)(v >> 8);
}

static void store_rgb565_be(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    uint32_t v = rgb565(pixel);
    (void)line;
    row[2u * column] = (uint8_t)(v >> 8);
    row[2u * column + 1u] = (uint8_t)(v & 0xFFu);
}

static void store_l8(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)line;
    row[column] = level8(grey(pixel));
}

/* Replaces the bits of `mask` << shift in a byte. */
static void store_bits(uint8_t *byte, uint32_t mask, unsigned shift, uint32_t value)
{
    *byte = (uint8_t)((*byte & ~(mask << shift)) | value << shift);
}

static void store_grey4(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    unsigned shift = (column & 1u) != 0 ? 0 : 4;
    (void)line;
    store_bits(row + column / 2u, 15u, shift, dithered(grey(pixel), 15, threshold(pixel)));
}

static void store_mono_horizontal(uint8_t *row, uint32_t column, uint32_t line,
                                  const qv_pixel *pixel)
{
    (void)line;
    store_bits(row + column / 8u, 1u, 7u - (column & 7u),
               dithered(grey(pixel), 1, threshold(pixel)));
}

static void store_mono_vertical(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    store_bits(row + column, 1u, line & 7u, dithered(grey(pixel), 1, threshold(pixel)));
}

QV_DESCRIPTOR qv_format qv_format_rgba8888 = {store_rgba8888, 32, 0};
QV_DESCRIPTOR qv_format qv_format_bgra8888 = {store_bgra8888, 32, 0};
QV_DESCRIPTOR qv_format qv_format_rgb888 = {store_rgb888, 24, 0};
QV_DESCRIPTOR qv_format qv_format_rgb565_le = {store_rgb565_le, 16, 0};
QV_DESCRIPTOR qv_format qv_format_rgb565_be = {store_rgb565_be, 16, 0};
QV_DESCRIPTOR qv_format qv_format_l8 = {store_l8, 8, 0};
QV_DESCRIPTOR qv_format qv_format_grey4 = {store_grey4, 4, 0};
QV_DESCRIPTOR qv_format qv_format_mono_horizontal = {store_mono_horizontal, 1, 0};
QV_DESCRIPTOR qv_format qv_format_mono_vertical = {store_mono_vertical, 8, 3};
