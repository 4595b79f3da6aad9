#include "march_levels.h"

QV_EACH_CONVERTED(QV_DEFINE_LEVELS, bspline_extinction, &qv_family_bspline_converted)
