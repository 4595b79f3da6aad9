/*
 * parallel.h - independent pieces of work on several threads.
 */
#ifndef QVOL_HOST_PARALLEL_H
#define QVOL_HOST_PARALLEL_H

#include <stdbool.h>
#include <stdint.h>

#define THREADS_MOST 256

struct parallel {
    void (*run)(void *context, uint32_t piece); /* may run on any thread, in any order */
    void *context;
    uint32_t pieces;
    unsigned threads;     /* 0: as many as there are processors */
    const char *progress; /* shown with a percentage on a terminal; null: silent */
};

/* Runs all pieces; returns when the last is done. */
void parallel_run(const struct parallel *work);

/* The threads that stand for that many asked for: 0 is as many as there are processors. */
unsigned parallel_threads(unsigned asked);

/* What to show while working, or null: quiet, or standard error is no terminal. */
const char *progress_label(bool quiet, const char *label);

#endif
