#include "paged_march.h"

static const qv_family family = {qv_paged_bspline_converted, QV_MODEL(qv_extinction_under),
                                 QV_MODEL(qv_extinction_over), 1, 0};

static qv_status prepare_bspline_extinction_converted(qv_context *context, const qv_scene *scene)
{
    return qv_prepare_paged(context, scene, qv_medium_converted, QV_SPLINE_TAPS);
}

QV_EACH_PAGED(CONVERTED, bspline_extinction, &family)
