/*
 * sample.h - tests/SPEC.md, sections 12 and 13: a sample of eight entries, and its opacity.
 */
#ifndef SAMPLE_H
#define SAMPLE_H

#include "number.h"

/* Entries of 8 or 16 bits a channel: colours K[channel][entry], and A opacity or extinction. */
enum { ENTRIES_MAX = 27 };

typedef struct entries {
    unsigned bits;  /* 8 or 16 */
    unsigned count; /* 8, or 27 of a B-spline */
    number A[ENTRIES_MAX], K[3][ENTRIES_MAX];
} entries;

typedef struct sample {
    number O;
    triple L;
    bool is_skipped;
} sample;

/* s[q] and the terms of the three sums L. */
typedef struct weighted_steps {
    number s[ENTRIES_MAX], term[3][ENTRIES_MAX];
} weighted_steps;

sample weighted(const entries *e, const number w[], weighted_steps *step);

typedef struct separate_steps {
    triple D;
} separate_steps;

sample separate(const entries *e, const number w[], separate_steps *step);
unsigned nearest_corner(const triple *f);
sample nearest(const entries *e, unsigned corner);

/* Section 13: a32. */
number opacity32(number O, unsigned bits);

#endif /* SAMPLE_H */
