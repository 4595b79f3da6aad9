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
    number b, u[4];
    channels low, high;
} ends;

ends preweighted_ends(const corners *c, const triple *f);

typedef struct preweighted_light {
    triple E;
    number T;
} preweighted_light;

typedef struct preweighted_under_steps {
    number s, h, l, t;
} preweighted_under_steps;

preweighted_light preweighted_under(const preweighted_light *before, const ends *of, number X,
                                    preweighted_under_steps *step);

/* m of SPEC.md goes to m. */
preweighted_light preweighted_over(const preweighted_light *before, const ends *of, number X,
                                   channels *m);
#endif /* PREWEIGHTED_H */
