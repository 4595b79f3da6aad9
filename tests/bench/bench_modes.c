/*
 * bench_modes.c - every mode of sampling.
 */
#include "bench_modes.h"

#define STORED(storage) BENCH_MODE(storage, extinction), BENCH_MODE(storage, bspline_extinction)
#define STEPS(storage)                                                                             \
    BENCH_MODE(storage, nearest), BENCH_MODE(storage, separate), BENCH_MODE(storage, weighted)
#define ALL(storage)                                                                               \
    STEPS(storage), BENCH_MODE(storage, corrected), BENCH_MODE(storage, bspline_weighted),         \
        STORED(storage)

/* Or those that the flash of a small device holds at a time. */
#ifndef BENCH_MODES
#define BENCH_MODES                                                                                \
    ALL(rgba8), ALL(rgba16), ALL(indexed8), ALL(indexed8_16), STORED(rgbt8), STORED(rgbt16),       \
        STORED(indexed8_t8), STORED(indexed8_t16), BENCH_MODE(associated8, preweighted)
#endif

const bench_mode bench_modes[] = {BENCH_MODES};

const unsigned bench_mode_count = sizeof bench_modes / sizeof *bench_modes;
