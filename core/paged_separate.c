#include "paged_march.h"

QV_EACH_PAGED_STEPS(separate)
