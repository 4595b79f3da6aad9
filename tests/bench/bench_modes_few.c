/*
 * bench_modes_few.c - what 128 KB of flash hold on an AVR.
 */
#include "bench_modes.h"

const bench_mode bench_modes[] = {
    BENCH_MODE(rgba8, nearest),     BENCH_MODE(rgba8, separate),
    BENCH_MODE(rgba8, weighted),    BENCH_MODE(associated8, preweighted),
    BENCH_MODE(rgba8, corrected),   BENCH_MODE(rgba16, weighted),
    BENCH_MODE(indexed8, weighted), BENCH_MODE(rgbt8, extinction),
};

const unsigned bench_mode_count = sizeof bench_modes / sizeof *bench_modes;
