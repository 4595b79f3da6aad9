#include "march_levels.h"

static const qv_family converted = {qv_sample_converted, qv_extinction_under, qv_extinction_over,
                                    1};

QV_EACH_CONVERTED(QV_DEFINE_LEVELS, extinction, &converted)
