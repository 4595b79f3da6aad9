#include "march_lengths.h"

QV_EACH_EXTINCTION(QV_DEFINE_LENGTHS, bspline_extinction, &qv_family_bspline_extinction)
