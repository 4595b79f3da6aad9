#include "march.h"

QV_EACH_STEPS(QV_DEFINE_STEPS, separate)
