/*
 * lengths.h - tests/SPEC.md, part F: pieces of a ray and what they weigh.
 */
#ifndef LENGTHS_H
#define LENGTHS_H

#include "composite.h"
#include "number.h"
#include "ray.h"
#include "sample.h"

/* Section 37: a way through the box, in positions; first is where it may begin. */
typedef struct way {
    number enter, leave;
    bool is_there;
} way;

way way_through(const ray *r, const triple *size, number first);

/* A piece of a way: its length l, its middle t and the point P there. */
typedef struct piece {
    number end, l, t;
    triple P;
} piece;

/* Sections 38 and 44: the piece that begins there on a level, which is 0 in section 38. */
piece piece_from(const ray *r, number begin, number leave, unsigned level);

/* Section 39: what a step means, or a piece of its length. */
typedef struct medium {
    number depth, light, b;
} medium;

enum medium_kind { MEDIUM_CORRECTED, MEDIUM_EXTINCTION8, MEDIUM_EXTINCTION16, MEDIUM_OPACITY };

medium medium_of(enum medium_kind kind, number U, number E, number step, number levels);
number of_length(number of_step, number l);

/* Section 40: the fraction, and voxel v on axis a as voxel[v].v[a]. */
typedef struct spline_cell {
    triple f, voxel[3];
} spline_cell;

spline_cell spline_cell_of(const triple *point, const triple *size);

/* z, and y for each part of it. */
typedef struct spline_parts {
    triple z, y[3];
} spline_parts;

/* The 27 weights, x fastest. */
void spline_weights(number w[], const triple *f, spline_parts *step);

/* Section 41. */
typedef struct converted_steps {
    number e[ENTRIES_MAX], h[ENTRIES_MAX], s;
} converted_steps;

sample converted(const entries *of, const number w[], converted_steps *step);

/* Section 42, by the names of SPEC.md; d2 is d'. */
typedef struct corrected_steps {
    number d, d2, x, F;
} corrected_steps;

/* L' goes to lit, and a32' is the result. */
number corrected(triple *lit, const triple *L, number a32, const medium *of, corrected_steps *step);

/* Section 43: what a ray keeps. */
typedef struct extinction_ray {
    number X, T;
    triple G; /* front to back */
    triple E; /* back to front */
} extinction_ray;

typedef struct extinction_steps {
    number d, phi, factor, x, a32;
} extinction_steps;

extinction_ray extinction_at_start(void);
extinction_ray extinction_under(const extinction_ray *before, const sample *of, number s,
                                const medium *m, extinction_steps *step);
extinction_ray extinction_over(const extinction_ray *before, const sample *of, number s,
                               const medium *m, extinction_steps *step);
number extinction_light(number G, number b); /* E of G */

/* Section 44: a sample of a level, and one with a share of the next coarser level's. */
typedef struct level_sample {
    number O, s;
    triple L;
} level_sample;

level_sample level_blend(const level_sample *fine, const level_sample *coarse, number share);

#endif /* LENGTHS_H */
