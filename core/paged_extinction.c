#include "paged_march.h"

static const qv_family family = {qv_paged_weighted, QV_MODEL(qv_extinction_under),
                                 QV_MODEL(qv_extinction_over), 1, qv_paged_bring};

static qv_status prepare_extinction_extinction(qv_context *context, const qv_scene *scene)
{
    return qv_prepare_paged(context, scene, qv_medium_extinction, QV_LINEAR_TAPS);
}

QV_EACH_PAGED(EXTINCTION, extinction, &family)
