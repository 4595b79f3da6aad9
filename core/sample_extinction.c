#include "march_lengths.h"

QV_EACH_EXTINCTION(QV_DEFINE_LENGTHS, extinction, &qv_family_extinction)
