#include "march.h"

QV_DEFINE_SAMPLINGS(separate, qv_march)
