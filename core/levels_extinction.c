#include "march_levels.h"

QV_EACH_EXTINCTION(QV_DEFINE_LEVELS, extinction, &qv_family_extinction)
