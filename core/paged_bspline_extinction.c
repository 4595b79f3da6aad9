#include "paged_march.h"

static const qv_family family = {qv_paged_bspline_weighted, QV_MODEL(qv_extinction_under),
                                 QV_MODEL(qv_extinction_over), 1, 0};

static qv_status prepare_bspline_extinction_extinction(qv_context *context, const qv_scene *scene)
{
    return qv_prepare_paged(context, scene, qv_medium_extinction, QV_SPLINE_TAPS);
}

QV_EACH_PAGED(EXTINCTION, bspline_extinction, &family)
