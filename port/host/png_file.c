/*
 * png_file.c - PNG through libpng. No time stamp, one filter and one level of
 * compression, so that equal pictures give equal files.
 */
#include "picture.h"
#include "error.h"

#include <png.h>
#include <stdlib.h>

#define COMPRESSION_LEVEL 6

/* libpng's messages become data errors about the file that is being read or
   written; data_error does not return, so no jump is needed. */
static void fail(png_structp png, png_const_charp message)
{
    data_error(png_get_error_ptr(png), "PNG", "%s", message);
}

static void ignore(png_structp png, png_const_charp message)
{
    (void)png;
    (void)message;
}

static void write_bytes(png_structp png, png_bytep bytes, size_t count)
{
    output_write(png_get_io_ptr(png), bytes, count);
}

static void flush(png_structp png)
{
    (void)png;
}

/* libpng keeps the name for fail(), and wants it without const. */
void write_png(output *out, const struct picture *picture)
{
    static const int colour_types[] = {0, PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
                                       PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
    size_t row_bytes = (size_t)picture->width * picture->channels;
    char *name = allocate(FILENAME_MAX, out->target, NULL);
    png_structp png;
    png_infop info;
    snprintf(name, FILENAME_MAX, "%s", out->target);
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, name, fail, ignore);
    info = png_create_info_struct(png);
    png_set_write_fn(png, out, write_bytes, flush);
    png_set_compression_level(png, COMPRESSION_LEVEL);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_PAETH);
    png_set_IHDR(png, info, picture->width, picture->height, 8, colour_types[picture->channels],
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (uint32_t y = 0; y < picture->height; y++) {
        png_write_row(png, picture->pixels + y * row_bytes);
    }
    png_write_end(png, NULL);
    png_destroy_write_struct(&png, &info);
    free(name);
}

/* Palettes and narrow greys become 8 bits a channel; lies about size are found
   before anything is allocated. */
static void read_header(png_structp png, png_infop info, const char *name, uint64_t bytes)
{
    uint64_t pixels;
    png_set_user_limits(png, PICTURE_SIDE_MOST, PICTURE_SIDE_MOST);
    png_read_info(png, info);
    if (png_get_bit_depth(png, info) > 8) {
        data_error(name, "bit depth", "16 bits a channel cannot be read");
    }
    /* deflate makes at most 1032 bytes of one; 8 pixels may share a byte. */
    pixels = (uint64_t)png_get_image_width(png, info) * png_get_image_height(png, info);
    if (pixels / (8u * 1032u) > bytes) {
        data_error(name, "size", "%llu pixels do not fit in %llu bytes", (unsigned long long)pixels,
                   (unsigned long long)bytes);
    }
    png_set_expand(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
}

void read_png(struct picture *picture, const char *name, FILE *file, uint64_t bytes)
{
    size_t row_bytes;
    char *copy = allocate(FILENAME_MAX, name, NULL);
    png_structp png;
    png_infop info;
    png_bytep *rows;
    snprintf(copy, FILENAME_MAX, "%s", name);
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, copy, fail, ignore);
    info = png_create_info_struct(png);
    png_init_io(png, file);
    read_header(png, info, name, bytes);
    picture_create(picture, png_get_image_width(png, info), png_get_image_height(png, info),
                   png_get_channels(png, info));
    row_bytes = png_get_rowbytes(png, info);
    rows = allocate(picture->height * sizeof *rows, name, "size");
    for (uint32_t y = 0; y < picture->height; y++) {
        rows[y] = picture->pixels + y * row_bytes;
    }
    png_read_image(png, rows);
    png_read_end(png, NULL);
    png_destroy_read_struct(&png, &info, NULL);
    free(rows);
    free(copy);
}
