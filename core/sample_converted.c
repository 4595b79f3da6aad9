#include "march_lengths.h"

QV_EACH_CONVERTED(QV_DEFINE_LENGTHS, extinction, &qv_family_converted)
