/*
 * freevoxels.h - tests/SPEC.md, part H: sections 62 to 64, footprints and sums of 66.
 */
#ifndef FREEVOXELS_H
#define FREEVOXELS_H

#include "number.h"
#include "pixels.h"

/* Section 64. */
number length_of(const triple *v);

/* A scaled number m 2^e: m is 0, or 2^31 <= m < 2^32. */
typedef struct scaled {
    number m;
    long e;
} scaled;

scaled scaled_of(number v, long e);
scaled scaled_product(scaled a, scaled b);
scaled scaled_quotient(scaled a, scaled b);
number scaled_fixed(scaled a, long f);

/* Section 62. */
typedef struct thickness {
    number f, s;
} thickness;

thickness thickness_of_unit(number U, number L);
thickness thickness_of_extinction(number E, number L);
number thickness_depth(thickness t, number w);
number attenuation_byte(number D);

triple direction_step(number d);
number step_length(const triple *step, const triple *spacing);

/* Voxels on each axis of a box, or a place in it; voxels are counted x fastest. */
typedef struct box {
    long n[3];
} box;

long box_voxels(const box *b);

/* D of a voxel: of all that lie one step, two steps, ... from it. */
number voxel_depth(const box *b, const number weight[], long index, const triple *step,
                   thickness t);

/* Section 63: level l of a box, the levels after level 0, and what a level holds. */
box level_box(const box *b, unsigned level);
unsigned level_count(const box *b);
number block_depth(const box *b, const number D[], long block); /* B */
number level_byte(const box *b, const number B[], long index, unsigned level);

/* Section 66: halves is 2 of the linear, 3 of the quadratic kernel; R as there. */
typedef struct footprint {
    unsigned halves, j;
    number x, size, H, R;
} footprint;

footprint footprint_of(number x, number size, unsigned halves);
number footprint_weight(const footprint *of, number k);

/* What a pixel with a weight in a line's light gets: part[c], and new sums. */
number splat_part(number line, number weight);
channels splat_added(const channels *sum, const number part[]);
channels splat_over(const channels *sum, const number part[]);

#endif /* FREEVOXELS_H */
