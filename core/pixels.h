/*
 * pixels.h - the finished pixel that a format stores.
 */
#ifndef QV_PIXELS_H
#define QV_PIXELS_H

#include "qvol.h"

typedef struct qv_pixel {
    uint32_t channel[4]; /* associated R, G, B and opacity: 8-bit levels with 16 fraction bits, at
                            most 255 * 65536; no colour above the opacity */
    uint32_t x, y;       /* absolute position modulo 2^32, for the display dither */
} qv_pixel;

#endif /* QV_PIXELS_H */
