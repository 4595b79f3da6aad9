#include "march_levels.h"

QV_EACH_CORRECTED(QV_DEFINE_LEVELS, bspline_weighted, &qv_family_bspline_corrected)
