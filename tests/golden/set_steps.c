#include "set.h"

#define MODES(order, towards)                                                                      \
    OPACITY_MODES(qv_nearest, order, GOLDEN_NEAREST, towards),                                     \
        OPACITY_MODES(qv_separate, order, GOLDEN_SEPARATE, towards),                               \
        OPACITY_MODES(qv_weighted, order, GOLDEN_WEIGHTED, towards)

static const golden_mode modes[] = {MODES(, GOLDEN_FRONT_TO_BACK),
                                    MODES(_back_to_front, GOLDEN_BACK_TO_FRONT)};

const golden_set golden_steps = {.render = golden_render_rays,
                                 .modes = modes,
                                 .mode_count = COUNT(modes),
                                 .first = 0,
                                 .end = GOLDEN_FIRST_LENGTHS};
