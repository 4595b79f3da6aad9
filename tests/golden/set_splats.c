#include "set.h"

/* Every storage, opacities for a step and for a unit distance. Those of indexed voxels stand two
   places behind those of their entries, which sample them once they are lit. */
static const golden_mode modes[] = {
    OPACITY_MODES(qv_nearest, , GOLDEN_NEAREST, GOLDEN_FRONT_TO_BACK),
    OPACITY_MODES(qv_extinction, , GOLDEN_EXTINCTION, GOLDEN_FRONT_TO_BACK),
    EXTINCTION_MODES(qv_extinction, , GOLDEN_EXTINCTION, GOLDEN_FRONT_TO_BACK),
};

static const golden_splat splats[] = {
    {"added linear", &qv_splatting_added, &qv_kernel_linear},
    {"added quadratic", &qv_splatting_added, &qv_kernel_quadratic},
    {"over linear", &qv_splatting_over, &qv_kernel_linear},
    {"over quadratic", &qv_splatting_over, &qv_kernel_quadratic},
    {"lit", NULL, NULL},
};

static const qv_order *const orders[GOLDEN_ORDERS] = {&qv_order_linear, &qv_order_morton,
                                                      &qv_order_hilbert};

static const golden_splats of_splats = {splats, COUNT(splats), orders};

const golden_set golden_freevoxels = {.render = golden_render_splats,
                                      .modes = modes,
                                      .mode_count = COUNT(modes),
                                      .splats = &of_splats,
                                      .draw = golden_draw_splats,
                                      .first = GOLDEN_FIRST_SPLATS,
                                      .end = GOLDEN_FIRST_PREWEIGHTED};
