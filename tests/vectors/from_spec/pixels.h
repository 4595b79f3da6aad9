/*
 * pixels.h - tests/SPEC.md, sections 16 and 17: read-out, and formats of pixels.
 */
#ifndef PIXELS_H
#define PIXELS_H

#include "composite.h"
#include "number.h"

/* Section 16: four channels, the last of them opacity. */
typedef struct channels {
    number v[4];
} channels;

channels background_levels(const channels *B);                       /* G */
channels read_out(const light *l, const channels *G, number factor); /* factor: readout */

/* Section 17. */
number level8(number v);
number grey_of(const channels *c);
number threshold_at(number x, number y); /* t */
number dither(number v, number top, number t);
number rgb565(const channels *c, number t);

#endif /* PIXELS_H */
