/*
 * bench_modes.h - what bench_device.c measures, one after the other: every mode of sampling, or
 * as many as the flash of a small device holds.
 */
#ifndef BENCH_MODES_H
#define BENCH_MODES_H

#include "qvol.h"

typedef struct bench_mode {
    const char *storage;
    const char *name;
    const qv_sampling *sampling;
} bench_mode;

/* An element of the list: qv_MODE_STORAGE. */
#define BENCH_MODE(storage, mode)                                                                  \
    {                                                                                              \
#storage, #mode, &qv_##mode##_##storage                                                    \
    }

extern const bench_mode bench_modes[];
extern const unsigned bench_mode_count;

#endif /* BENCH_MODES_H */
