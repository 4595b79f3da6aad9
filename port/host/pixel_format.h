/*
 * pixel_format.h - the library's pixel formats by name, and what a panel shows
 * of their bytes.
 */
#ifndef QVOL_HOST_PIXEL_FORMAT_H
#define QVOL_HOST_PIXEL_FORMAT_H

#include "picture.h"
#include "qvol.h"

struct pixel_format {
    const char *name;
    const qv_format *format;
    unsigned channels; /* of the picture it shows: 1 grey, 3 RGB, 4 RGBA */
    /* One pixel of a row of bytes; line counts the rows that share the bytes. */
    void (*show)(uint8_t *channels, const uint8_t *row, uint32_t x, uint32_t line);
};

/* The format of that name, or a usage error that lists the names. */
const struct pixel_format *pixel_format_find(const char *option, const char *name);

/* Pixel rows that share one row of bytes. */
uint32_t pixel_format_lines(const struct pixel_format *format);

/* Rows of bytes that `height` pixel rows take. */
size_t pixel_format_rows(const struct pixel_format *format, uint32_t height);

/* What a panel shows of tightly packed rows: narrow channels are spread over
   0 .. 255, associated colours become straight ones. */
void pixel_format_show(struct picture *picture, const struct pixel_format *format,
                       const uint8_t *bytes, uint32_t width, uint32_t height);

#endif
