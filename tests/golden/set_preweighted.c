#include "set.h"

static const golden_mode modes[] = {
    MODE(DIRECT8, qv_preweighted_associated8, GOLDEN_PREWEIGHTED, GOLDEN_FRONT_TO_BACK),
    MODE(DIRECT8, qv_preweighted_associated8_back_to_front, GOLDEN_PREWEIGHTED,
         GOLDEN_BACK_TO_FRONT),
};

/* From near by, so that each of few scenes covers enough of its picture. */
static void draw_nearer(golden_scene *golden, const golden_set *set, uint32_t mode, uint32_t *state)
{
    (void)set;
    (void)mode;
    (void)state;
    golden->pitch = golden->pitch / 4 * 3;
}

const golden_set golden_preweighted = {.render = golden_render_rays,
                                       .modes = modes,
                                       .mode_count = COUNT(modes),
                                       .draw = draw_nearer,
                                       .first = GOLDEN_FIRST_PREWEIGHTED,
                                       .end = GOLDEN_SCENES};
