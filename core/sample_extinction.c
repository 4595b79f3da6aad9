#include "march_lengths.h"

static const qv_family stored = {qv_sample_weighted, qv_extinction_under, qv_extinction_over, 1};

QV_DEFINE_EXTINCTION_SAMPLINGS(extinction, &stored)
