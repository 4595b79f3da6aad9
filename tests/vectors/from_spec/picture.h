/*
 * picture.h - whole pixels and rows of a small volume, by tests/SPEC.md, sections 3 to 18
 * and 36 to 43.
 */
#ifndef PICTURE_H
#define PICTURE_H

#include "lengths.h"
#include "pixels.h"
#include "ray.h"
#include "sample.h"

enum picture_mode {
    MODE_NEAREST,
    MODE_SEPARATE,
    MODE_WEIGHTED,
    MODE_CORRECTED,
    MODE_EXTINCTION,
    MODE_BSPLINE_WEIGHTED,
    MODE_BSPLINE_EXTINCTION,
    MODES
};

enum { VOXELS_MAX = 8 };

typedef struct scene {
    triple size;
    unsigned bits;                          /* 8 or 16 */
    number K[3][VOXELS_MAX], A[VOXELS_MAX]; /* x fastest, then y, then z */
    enum picture_mode mode;
    bool is_back_to_front;
    camera camera;
    medium medium; /* of a step, for modes that weigh by length */
    number phase, threshold;
    channels background; /* B */
} scene;

typedef struct statistics {
    long samples, skipped, terminated;
} statistics;

/* The channels of a pixel, before its format; adds to the statistics. */
channels pixel_of(const scene *s, long x, long y, statistics *sum);

enum { ROW_BYTES_MAX = 64 };

typedef struct row_of_bytes {
    unsigned length;
    unsigned char byte[ROW_BYTES_MAX];
} row_of_bytes;

enum pixel_format {
    FORMAT_RGBA8888,
    FORMAT_BGRA8888,
    FORMAT_RGB888,
    FORMAT_RGB565_LE,
    FORMAT_RGB565_BE,
    FORMAT_L8,
    FORMAT_GREY4,
    FORMAT_MONO_HORIZONTAL,
    FORMAT_MONO_VERTICAL,
    FORMATS
};

/* A row that begins as 0 takes the pixel of column x and line y. */
void put_pixel(row_of_bytes *row, enum pixel_format format, const channels *c, long x, long y);

/* CRC-32 of section 25, of a row behind what crc stands for: 0 of nothing. */
uint32_t crc_of_row(uint32_t crc, const row_of_bytes *row);

#endif /* PICTURE_H */
