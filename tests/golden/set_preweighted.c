#include "set.h"

static const golden_mode modes[] = {
    MODE(qv_preweighted_associated8, GOLDEN_PREWEIGHTED, GOLDEN_FRONT_TO_BACK),
    MODE(qv_preweighted_associated8_back_to_front, GOLDEN_PREWEIGHTED, GOLDEN_BACK_TO_FRONT),
};

const golden_set golden_preweighted = {.render = golden_render_rays,
                                       .modes = modes,
                                       .mode_count = COUNT(modes),
                                       .first = GOLDEN_FIRST_PREWEIGHTED,
                                       .end = GOLDEN_SCENES};
