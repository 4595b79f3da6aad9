#include "march_levels.h"

QV_EACH_EXTINCTION(QV_DEFINE_LEVELS, bspline_extinction, &qv_family_bspline_extinction)
