#include "set.h"

#define MODES(order, towards)                                                                      \
    OPACITY_MODES(qv_bspline_weighted, order, GOLDEN_BSPLINE_WEIGHTED, towards),                   \
        OPACITY_MODES(qv_bspline_extinction, order, GOLDEN_BSPLINE_EXTINCTION, towards),           \
        EXTINCTION_MODES(qv_bspline_extinction, order, GOLDEN_BSPLINE_EXTINCTION, towards)

static const golden_mode modes[] = {MODES(, GOLDEN_FRONT_TO_BACK),
                                    MODES(_back_to_front, GOLDEN_BACK_TO_FRONT),
                                    MODES(_levels, GOLDEN_LEVELS)};

const golden_set golden_bsplines = {.render = golden_render_rays,
                                    .modes = modes,
                                    .mode_count = COUNT(modes),
                                    .first = GOLDEN_FIRST_BSPLINES,
                                    .end = GOLDEN_FIRST_SLICES};
