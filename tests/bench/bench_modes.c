/*
 * bench_modes.c - every mode of sampling.
 */
#include "bench_modes.h"

const bench_mode bench_modes[] = {
    {"rgba8", "nearest", &qv_nearest_rgba8},
    {"rgba8", "separate", &qv_separate_rgba8},
    {"rgba8", "weighted", &qv_weighted_rgba8},
    {"associated8", "preweighted", &qv_preweighted_associated8},
    {"rgba8", "corrected", &qv_corrected_rgba8},
    {"rgba8", "extinction", &qv_extinction_rgba8},
    {"rgba8", "bspline_weighted", &qv_bspline_weighted_rgba8},
    {"rgba8", "bspline_extinction", &qv_bspline_extinction_rgba8},
    {"rgba16", "nearest", &qv_nearest_rgba16},
    {"rgba16", "separate", &qv_separate_rgba16},
    {"rgba16", "weighted", &qv_weighted_rgba16},
    {"rgba16", "corrected", &qv_corrected_rgba16},
    {"rgba16", "extinction", &qv_extinction_rgba16},
    {"rgba16", "bspline_weighted", &qv_bspline_weighted_rgba16},
    {"rgba16", "bspline_extinction", &qv_bspline_extinction_rgba16},
    {"indexed8", "nearest", &qv_nearest_indexed8},
    {"indexed8", "separate", &qv_separate_indexed8},
    {"indexed8", "weighted", &qv_weighted_indexed8},
    {"indexed8", "corrected", &qv_corrected_indexed8},
    {"indexed8", "extinction", &qv_extinction_indexed8},
    {"indexed8", "bspline_weighted", &qv_bspline_weighted_indexed8},
    {"indexed8", "bspline_extinction", &qv_bspline_extinction_indexed8},
    {"indexed8_16", "nearest", &qv_nearest_indexed8_16},
    {"indexed8_16", "separate", &qv_separate_indexed8_16},
    {"indexed8_16", "weighted", &qv_weighted_indexed8_16},
    {"indexed8_16", "corrected", &qv_corrected_indexed8_16},
    {"indexed8_16", "extinction", &qv_extinction_indexed8_16},
    {"indexed8_16", "bspline_weighted", &qv_bspline_weighted_indexed8_16},
    {"indexed8_16", "bspline_extinction", &qv_bspline_extinction_indexed8_16},
    {"rgbt8", "extinction", &qv_extinction_rgbt8},
    {"rgbt8", "bspline_extinction", &qv_bspline_extinction_rgbt8},
    {"rgbt16", "extinction", &qv_extinction_rgbt16},
    {"rgbt16", "bspline_extinction", &qv_bspline_extinction_rgbt16},
    {"indexed8_t8", "extinction", &qv_extinction_indexed8_t8},
    {"indexed8_t8", "bspline_extinction", &qv_bspline_extinction_indexed8_t8},
    {"indexed8_t16", "extinction", &qv_extinction_indexed8_t16},
    {"indexed8_t16", "bspline_extinction", &qv_bspline_extinction_indexed8_t16},
};

const unsigned bench_mode_count = sizeof bench_modes / sizeof *bench_modes;
