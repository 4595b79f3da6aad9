#include "paged_march.h"

static const qv_family family = {qv_paged_weighted, QV_MODEL(qv_corrected_under),
                                 QV_MODEL(qv_corrected_over), 0, qv_paged_bring};

static qv_status prepare_corrected_corrected(qv_context *context, const qv_scene *scene)
{
    return qv_prepare_paged(context, scene, qv_medium_corrected, QV_LINEAR_TAPS);
}

QV_EACH_PAGED(CORRECTED, corrected, &family)
