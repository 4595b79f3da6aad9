/*
 * tally.h - how far rendered bytes are from the reference.
 */
#ifndef REFERENCE_TALLY_H
#define REFERENCE_TALLY_H

#include "reference.h"

typedef struct tally {
    uint64_t channels; /* compared */
    uint64_t equal;    /* to the reference rounded to 8 bits */
    uint64_t beyond;   /* more than one level off */
    uint32_t worst;    /* levels off after rounding */
    double farthest;   /* levels off from the reference before rounding */
} tally;

/* Compares the bytes R, G, B, A of a pixel with the reference. */
void tally_pixel(tally *into, const uint8_t bytes[4], const ref_pixel *pixel);

void tally_add(tally *into, const tally *other);

/* Equal channels of all, in 0 .. 1; 1 where nothing was compared. */
double tally_share(const tally *of);

/* Prints one line of figures behind "# ". */
void tally_print(const char *name, const tally *of);

#endif /* REFERENCE_TALLY_H */
