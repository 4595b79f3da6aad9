/*
 * stages.h - the error of each stage: how it is described, and what its measurement fills.
 *
 * A chapter is a derivation and the stages that it bounds. Errors are results less true values, in
 * the unit that the stage names. True values come from arithmetic on exact integers, double
 * or long double, of what the stage is given, which an earlier stage of the library may have made.
 */
#ifndef STAGES_H
#define STAGES_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

/* The errors of a stage so far: the worst, with its input, and what their RMS needs. */
typedef struct measured {
    double worst;
    long double squares;
    uint64_t count;
    char input[120];
} measured;

/* Whether this error is worse than all before: then the caller writes its input. */
static inline int measured_is_worse(measured *m, double error)
{
    const double size = fabs(error);
    if (size <= m->worst)
        return 0;
    m->worst = size;
    return 1;
}

/* The same, and the error counts for the RMS. */
static inline int measured_add(measured *m, double error)
{
    m->squares += (long double)(error * error);
    m->count++;
    return measured_is_worse(m, error);
}

/* Writes the input of the worst error. */
void measured_input(measured *m, const char *format, ...);

double measured_rms(const measured *m);

/* Measures a stage, for what the row says it is to measure: bits, or how many samples. */
typedef void stage_measure(measured *m, unsigned parameter);

typedef struct stage {
    const char *name, *formats, *rounding, *unit;
    double bound;
    unsigned within;    /* how many times the worst error found the bound may be: 2, chains 4 */
    const char *inputs; /* which are measured */
    stage_measure *measure;
    unsigned parameter;
    const char *reason; /* why the bound is more than `within` times the worst; or null */
} stage;

typedef struct chapter {
    const char *title, *derivation;
    const stage *stages;
    size_t count;
} chapter;

extern const chapter chapter_weights, chapter_depth, chapter_samples, chapter_composite,
    chapter_pixels, chapter_blends, chapter_bspline, chapter_rays, chapter_lengths, chapter_splats,
    chapter_downsampling, chapter_preweighted, chapter_entries;

#endif /* STAGES_H */
