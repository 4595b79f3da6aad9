#include "bspline.h"
#include "march_lengths.h"

static const qv_family converted = {qv_bspline_converted, qv_extinction_under, qv_extinction_over,
                                    1};

QV_EACH_CONVERTED(QV_DEFINE_LENGTHS, bspline_extinction, &converted)
