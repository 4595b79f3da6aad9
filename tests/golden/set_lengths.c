#include "set.h"

#define MODES(order, towards)                                                                      \
    OPACITY_MODES(qv_corrected, order, GOLDEN_CORRECTED, towards),                                 \
        OPACITY_MODES(qv_extinction, order, GOLDEN_EXTINCTION, towards),                           \
        EXTINCTION_MODES(qv_extinction, order, GOLDEN_EXTINCTION, towards)

static const golden_mode modes[] = {MODES(, GOLDEN_FRONT_TO_BACK),
                                    MODES(_back_to_front, GOLDEN_BACK_TO_FRONT),
                                    MODES(_levels, GOLDEN_LEVELS)};

const golden_set golden_lengths = {.render = golden_render_rays,
                                   .modes = modes,
                                   .mode_count = COUNT(modes),
                                   .first = GOLDEN_FIRST_LENGTHS,
                                   .end = GOLDEN_FIRST_BSPLINES};
