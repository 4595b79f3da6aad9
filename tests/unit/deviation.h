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

static inline void deviation_add(deviation *d, uint32_t result, long double exact)
{
    const double error = (double)((long double)result - exact);
    d->worst = fmax(d->worst, fabs(error));
    d->squares += error * error;
    d->sum += error;
    d->count += 1;
}

static inline void deviation_print(const deviation *d, const char *name)
{
    printf("# %s: max %.4f, rms %.4f, bias %+.4f\n", name, d->worst, sqrt(d->squares / d->count),
           d->sum / d->count);
}

#endif /* QV_DEVIATION_H */
