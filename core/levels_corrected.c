#include "march_levels.h"

QV_EACH_CORRECTED(QV_DEFINE_LEVELS, corrected, &qv_family_corrected)
