/*
 * bench_modes_few.c - what 128 KB of flash hold on an AVR.
 */
#include "bench_modes.h"

const bench_mode bench_modes[] = {
    {"rgba8", "nearest", &qv_nearest_rgba8},
    {"rgba8", "separate", &qv_separate_rgba8},
    {"rgba8", "weighted", &qv_weighted_rgba8},
    {"associated8", "preweighted", &qv_preweighted_associated8},
    {"rgba8", "corrected", &qv_corrected_rgba8},
    {"rgba16", "weighted", &qv_weighted_rgba16},
    {"indexed8", "weighted", &qv_weighted_indexed8},
    {"rgbt8", "extinction", &qv_extinction_rgbt8},
};

const unsigned bench_mode_count = sizeof bench_modes / sizeof *bench_modes;
