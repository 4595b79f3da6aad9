/*
 * preweighted.h - tests/SPEC.md, section 70: sampling of associated colours.
 */
#ifndef PREWEIGHTED_H
#define PREWEIGHTED_H

#include "number.h"
#include "pixels.h"

/* Corners of a cell: four channels, A the last. */
typedef struct corners {
    channels of[8];
} corners;

typedef struct ends {
    number u[4];
    channels low, high;
} ends;

ends preweighted_ends(const corners *c, const triple *f);

typedef struct preweighted_light {
    triple E;
    number T;
} preweighted_light;

/* Each returns whether the sample was skipped, in which case nothing changes. */
bool preweighted_under(preweighted_light *kept, const ends *of, number X);
bool preweighted_over(preweighted_light *kept, const ends *of, number X);

#endif /* PREWEIGHTED_H */
