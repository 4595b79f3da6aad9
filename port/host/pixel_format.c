/*
 * pixel_format.c - what a panel shows of the library's bytes.
 */
#include "pixel_format.h"
#include "error.h"

#include <stdio.h>
#include <string.h>

/* Colour by alpha, to nearest; a colour above its alpha cannot occur, and
   would be full. */
static uint8_t straight(uint8_t associated, uint8_t alpha)
{
    unsigned value = alpha == 0 ? 0 : (associated * 255u + alpha / 2u) / alpha;
    return (uint8_t)(value < 255 ? value : 255);
}

static void show_rgba8888(uint8_t *channels, const uint8_t *row, uint32_t x, uint32_t line)
{
    const uint8_t *pixel = row + 4 * (size_t)x;
    (void)line;
    for (unsigned c = 0; c < 3; c++) {
        channels[c] = straight(pixel[c], pixel[3]);
    }
    channels[3] = pixel[3];
}

static void show_bgra8888(uint8_t *channels, const uint8_t *row, uint32_t x, uint32_t line)
{
    const uint8_t *pixel = row + 4 * (size_t)x;
    (void)line;
    for (unsigned c = 0; c < 3; c++) {
        channels[c] = straight(pixel[2 - c], pixel[3]);
    }
    channels[3] = pixel[3];
}

static void show_rgb888(uint8_t *channels, const uint8_t *row, uint32_t x, uint32_t line)
{
    (void)line;
    memcpy(channels, row + 3 * (size_t)x, 3);
}

/* Repeating the high bits below makes full scale 255. */
static void show_rgb565(uint8_t *channels, unsigned word)
{
    unsigned red = word >> 11 & 31;
    unsigned green = word >> 5 & 63;
    unsigned blue = word & 31;
    channels[0] = (uint8_t)(red << 3 | red >> 2);
    channels[1] = (uint8_t)(green << 2 | green >> 4);
    channels[2] = (uint8_t)(blue << 3 | blue >> 2);
}

static void show_rgb565_le(uint8_t *channels, const uint8_t *row, uint32_t x, uint32_t line)
{
    const uint8_t *pixel = row + 2 * (size_t)x;
    (void)line;
    show_rgb565(channels, pixel[0] | (unsigned)pixel[1] << 8);
}

static void show_rgb565_be(uint8_t *channels, const uint8_t *row, uint32_t x, uint32_t line)
{
    const uint8_t *pixel = row + 2 * (size_t)x;
    (void)line;
    show_rgb565(channels, (unsigned)pixel[0] << 8 | pixel[1]);
}

static void show_l8(uint8_t *channels, const uint8_t *row, uint32_t x, uint32_t line)
{
    (void)line;
    channels[0] = row[x];
}

/* Level 15 is white: 15 * 17 = 255. */
static void show_grey4(uint8_t *channels, const uint8_t *row, uint32_t x, uint32_t line)
{
    unsigned level = row[x / 2] >> (x % 2 == 0 ? 4 : 0) & 15;
    (void)line;
    channels[0] = (uint8_t)(level * 17);
}

/* The leftmost pixel is the highest bit. */
static void show_mono_horizontal(uint8_t *channels, const uint8_t *row, uint32_t x, uint32_t line)
{
    (void)line;
    channels[0] = row[x / 8] >> (7 - x % 8) & 1 ? 255 : 0;
}

/* The topmost pixel is the lowest bit. */
static void show_mono_vertical(uint8_t *channels, const uint8_t *row, uint32_t x, uint32_t line)
{
    channels[0] = row[x] >> line & 1 ? 255 : 0;
}

static const struct pixel_format formats[] = {
    {"rgba8888", &qv_format_rgba8888, 4, show_rgba8888},
    {"bgra8888", &qv_format_bgra8888, 4, show_bgra8888},
    {"rgb888", &qv_format_rgb888, 3, show_rgb888},
    {"rgb565le", &qv_format_rgb565_le, 3, show_rgb565_le},
    {"rgb565be", &qv_format_rgb565_be, 3, show_rgb565_be},
    {"l8", &qv_format_l8, 1, show_l8},
    {"grey4", &qv_format_grey4, 1, show_grey4},
    {"mono-horizontal", &qv_format_mono_horizontal, 1, show_mono_horizontal},
    {"mono-vertical", &qv_format_mono_vertical, 1, show_mono_vertical},
};

#define FORMATS (sizeof formats / sizeof formats[0])

const struct pixel_format *pixel_format_find(const char *option, const char *name)
{
    char names[256] = "";
    for (size_t i = 0; i < FORMATS; i++) {
        size_t used = strlen(names);
        if (strcmp(formats[i].name, name) == 0) {
            return &formats[i];
        }
        snprintf(names + used, sizeof names - used, " %s", formats[i].name);
    }
    usage_error(option, "unknown '%s', use one of%s", name, names);
}

uint32_t pixel_format_lines(const struct pixel_format *format)
{
    return 1u << format->format->line_shift;
}

size_t pixel_format_rows(const struct pixel_format *format, uint32_t height)
{
    uint32_t lines = pixel_format_lines(format);
    return (height + lines - 1) / lines;
}

void pixel_format_show(struct picture *picture, const struct pixel_format *format,
                       const uint8_t *bytes, uint32_t width, uint32_t height)
{
    size_t row_bytes = qv_row_bytes(format->format, (uint16_t)width);
    uint32_t lines = pixel_format_lines(format);
    picture_create(picture, width, height, format->channels);
    for (uint32_t y = 0; y < height; y++) {
        const uint8_t *row = bytes + y / lines * row_bytes;
        uint8_t *out = picture->pixels + (size_t)y * width * format->channels;
        for (uint32_t x = 0; x < width; x++) {
            format->show(out, row, x, y % lines);
            out += format->channels;
        }
    }
}
