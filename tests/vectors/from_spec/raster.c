/* Sections 17, 18 and 25: bytes of a row, and their checksum. */
#include "picture.h"

static void put_byte(row_of_bytes *row, unsigned at, number value)
{
    if (at >= ROW_BYTES_MAX)
        fail("a row is too long");
    row->byte[at] = (unsigned char)(row->byte[at] + small(value));
    if (at >= row->length)
        row->length = at + 1;
}

/* Levels of channels, in the order of their bytes. */
static void put_levels(row_of_bytes *row, const channels *c, const int order[], unsigned count,
                       unsigned column)
{
    for (unsigned i = 0; i < count; i++)
        put_byte(row, count * column + i, level8(c->v[order[i]]));
}

static void put_rgb565(row_of_bytes *row, number v, unsigned column, unsigned upper)
{
    put_byte(row, 2 * column + upper, down(v, 8));
    put_byte(row, 2 * column + 1 - upper, low_bits(v, 8));
}

/* Formats of less than a byte a pixel. */
static void put_bits(row_of_bytes *row, enum pixel_format format, number grey, number t,
                     unsigned column, unsigned line)
{
    if (format == FORMAT_GREY4)
        put_byte(row, column / 2, up(dither(grey, whole(15), t), column % 2 == 0 ? 4 : 0));
    else if (format == FORMAT_MONO_HORIZONTAL)
        put_byte(row, column / 8, up(dither(grey, whole(1), t), 7 - column % 8));
    else
        put_byte(row, column, up(dither(grey, whole(1), t), line % 8));
}

void put_pixel(row_of_bytes *row, enum pixel_format format, const channels *c, long x, long y)
{
    static const int rgba[4] = {0, 1, 2, 3}, bgra[4] = {2, 1, 0, 3};
    const unsigned column = (unsigned)x;
    number t = threshold_at(whole(x), whole(y));
    switch (format) {
    case FORMAT_RGBA8888:
        put_levels(row, c, rgba, 4, column);
        break;
    case FORMAT_BGRA8888:
        put_levels(row, c, bgra, 4, column);
        break;
    case FORMAT_RGB888:
        put_levels(row, c, rgba, 3, column);
        break;
    case FORMAT_RGB565_LE:
        put_rgb565(row, rgb565(c, t), column, 1);
        break;
    case FORMAT_RGB565_BE:
        put_rgb565(row, rgb565(c, t), column, 0);
        break;
    case FORMAT_L8:
        put_byte(row, column, level8(grey_of(c)));
        break;
    default:
        put_bits(row, format, grey_of(c), t, column, (unsigned)y);
    }
}

uint32_t crc_of_row(uint32_t crc, const row_of_bytes *row)
{
    crc = ~crc;
    for (unsigned i = 0; i < row->length; i++) {
        crc ^= row->byte[i];
        for (int bit = 0; bit < 8; bit++)
            crc = (crc & 1) != 0 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
    }
    return ~crc;
}
