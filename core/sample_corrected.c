#include "march_lengths.h"

static const qv_family corrected = {qv_sample_weighted, qv_corrected_under, qv_corrected_over, 0};

QV_EACH_CORRECTED(QV_DEFINE_LENGTHS, corrected, &corrected)
