#include "march_lengths.h"

QV_EACH_CORRECTED(QV_DEFINE_LENGTHS, corrected, &qv_family_corrected)
