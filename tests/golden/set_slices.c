#include "set.h"

/* Every storage, family and order, but not all of each. */
static const golden_mode modes[] = {
    OPACITY_MODES(qv_nearest, , GOLDEN_NEAREST, GOLDEN_FRONT_TO_BACK),
    MODE(DIRECT8, qv_separate_rgba8, GOLDEN_SEPARATE, GOLDEN_FRONT_TO_BACK),
    OPACITY_MODES(qv_weighted, _back_to_front, GOLDEN_WEIGHTED, GOLDEN_BACK_TO_FRONT),
    OPACITY_MODES(qv_corrected, , GOLDEN_CORRECTED, GOLDEN_FRONT_TO_BACK),
    OPACITY_MODES(qv_extinction, _back_to_front, GOLDEN_EXTINCTION, GOLDEN_BACK_TO_FRONT),
    EXTINCTION_MODES(qv_extinction, , GOLDEN_EXTINCTION, GOLDEN_FRONT_TO_BACK),
    MODE(DIRECT8, qv_bspline_weighted_rgba8, GOLDEN_BSPLINE_WEIGHTED, GOLDEN_FRONT_TO_BACK),
    MODE(INDEXED8, qv_bspline_extinction_indexed8_t8, GOLDEN_BSPLINE_EXTINCTION,
         GOLDEN_FRONT_TO_BACK),
    MODE(DIRECT8, qv_corrected_rgba8_levels, GOLDEN_CORRECTED, GOLDEN_LEVELS),
    MODE(INDEXED8, qv_extinction_indexed8_levels, GOLDEN_EXTINCTION, GOLDEN_LEVELS),
    MODE(DIRECT16, qv_extinction_rgbt16_levels, GOLDEN_EXTINCTION, GOLDEN_LEVELS),
};

#define BLEND(name, direction)                                                                     \
    {                                                                                              \
#name, &qv_##name, direction                                                               \
    }

/* The first are those that chunks may take: they have opacity, and at most 7 bytes. */
static const golden_blend blends[] = {
    BLEND(over_rgba8888, GOLDEN_OVER),
    BLEND(under_rgb888, GOLDEN_UNDER),
    BLEND(over_rgba8888_residual4, GOLDEN_OVER),
    BLEND(hardware_rgba8888, GOLDEN_OVER),
    BLEND(over_rgb888, GOLDEN_OVER),
    BLEND(over_rgb888_residual4, GOLDEN_OVER),
    BLEND(over_rgb888_residual8, GOLDEN_OVER),
    BLEND(over_rgba8888_residual8, GOLDEN_OVER),
    BLEND(over_rgb565, GOLDEN_OVER),
    BLEND(over_rgba12, GOLDEN_OVER),
    BLEND(over_rgb16, GOLDEN_OVER),
    BLEND(over_rgba16, GOLDEN_OVER),
    BLEND(over_rgb24, GOLDEN_OVER),
    BLEND(over_rgba24, GOLDEN_OVER),
    BLEND(under_rgb16, GOLDEN_UNDER),
    BLEND(under_rgb24, GOLDEN_UNDER),
    BLEND(hardware_rgb888, GOLDEN_OVER),
    BLEND(hardware_rgb565, GOLDEN_OVER),
    BLEND(hardware_rgba12, GOLDEN_OVER),
    BLEND(hand_out_rgba8888, GOLDEN_HAND_OUT),
};

static qv_sequence *const sequences[GOLDEN_SEQUENCES] = {qv_sequence_blocks, qv_sequence_golden,
                                                         qv_sequence_hash, qv_sequence_rounded};

static const qv_technique *const techniques[GOLDEN_TECHNIQUES] = {
    &qv_technique_corrected, &qv_technique_bumped, &qv_technique_ordered, &qv_technique_random,
    &qv_technique_rounded};

static const golden_blends of_slices = {blends, COUNT(blends), sequences, techniques};

const golden_set golden_slices = {.render = golden_render_slices,
                                  .modes = modes,
                                  .mode_count = COUNT(modes),
                                  .blends = &of_slices,
                                  .first = GOLDEN_FIRST_SLICES,
                                  .end = GOLDEN_FIRST_SPLATS};
