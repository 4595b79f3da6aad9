#include "march_levels.h"

QV_EACH_CONVERTED(QV_DEFINE_LEVELS, extinction, &qv_family_converted)
