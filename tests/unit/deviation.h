/*
 * deviation.h - how far results lie from the true values: the greatest deviation,
 * root mean square and mean, in units of the result.
 */
#ifndef QV_DEVIATION_H
#define QV_DEVIATION_H

#include <math.h>
#include <stdio.h>

typedef struct deviation {
    double worst, squares, sum, count;
} deviation;

static inline void deviation_add(deviation *d, long double result, long double exact)
{
    const double error = (double)(result - exact);
    d->worst = fmax(d->worst, fabs(error));
    d->squares += error * error;
    d->sum += error;
    d->count += 1;
}

/* Prints a line for people and tests/bench/functions.sh, in multiples of a unit. */
static inline void deviation_print(const deviation *d, const char *name, double unit)
{
    printf("# %s: max %.4f, rms %.4f, bias %+.4f\n", name, d->worst / unit,
           sqrt(d->squares / d->count) / unit, d->sum / d->count / unit);
}

#endif /* QV_DEVIATION_H */
