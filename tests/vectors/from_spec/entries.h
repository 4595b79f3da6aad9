/*
 * entries.h - tests/SPEC.md, sections 31, 32, 34 and 69: entries from other entries.
 */
#ifndef ENTRIES_H
#define ENTRIES_H

#include "number.h"

/* Section 31: a fourth channel v, unorm16, for other units U or extinctions E. */
number opacity_to_extinction(number v, number U, number E);
number extinction_to_opacity(number v, number E, number U);
number opacity_to_opacity(number v, number U, number U_new);
number extinction_to_extinction(number v, number E, number E_new);

/* The least E that holds opacities; opaque stands for 65535, 0 where it is not given. */
number least_extinction(unsigned count, const number a[], number U, number opaque);

/* Section 32. Y are the colours' sums; with X they make an entry. */
typedef struct mixture {
    number X;
    triple Y;
} mixture;

mixture mixture_of(unsigned count, const number p[], const number E[], const triple C[]);
number mixture_colour(const mixture *m, unsigned channel);
number mixture_extinction(const mixture *m, number E);

/* Section 34: a filter's inner tap, and 64 entries with x fastest. */
enum { TAPS = 64 };

typedef struct taps {
    number X[TAPS], C[3][TAPS];
} taps;

typedef struct reduced {
    number W, m, X;
    triple L, c;
} reduced;

/* The voxel that tap t of result p reads on an axis of n voxels. */
long tap_voxel(long p, long t, long n);
reduced downsample(const taps *of, number inner, bool is_extinction);

/* Section 69: of rgba8, of rgba16, as unorm8. */
number associated_of_8(number colour, number A);
number associated_of_16(number colour, number A);

#endif /* ENTRIES_H */
