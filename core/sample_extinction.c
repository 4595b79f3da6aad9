#include "march_lengths.h"

static const qv_family stored = {qv_sample_weighted, qv_extinction_under, qv_extinction_over, 1};

QV_EACH_EXTINCTION(QV_DEFINE_LENGTHS, extinction, &stored)
