#include "march.h"

QV_DEFINE_SAMPLINGS(nearest, qv_march)
