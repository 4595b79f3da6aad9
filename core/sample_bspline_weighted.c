#include "march_lengths.h"

QV_EACH_CORRECTED(QV_DEFINE_LENGTHS, bspline_weighted, &qv_family_bspline_corrected)
