#include "bspline.h"
#include "march_levels.h"

static const qv_family stored = {qv_bspline_weighted, qv_extinction_under, qv_extinction_over, 1};

QV_EACH_EXTINCTION(QV_DEFINE_LEVELS, bspline_extinction, &stored)
