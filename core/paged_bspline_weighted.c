#include "paged_march.h"

static const qv_family family = {qv_paged_bspline_weighted, QV_MODEL(qv_corrected_under),
                                 QV_MODEL(qv_corrected_over), 0, 0};

static qv_status prepare_bspline_weighted_corrected(qv_context *context, const qv_scene *scene)
{
    return qv_prepare_paged(context, scene, qv_medium_corrected, QV_SPLINE_TAPS);
}

QV_EACH_PAGED(CORRECTED, bspline_weighted, &family)
