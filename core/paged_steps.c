#include "paged_march.h"

qv_status qv_prepare_steps_paged(qv_context *context, const qv_scene *scene)
{
    (void)context;
    qv_status status = qv_steps_check(scene);
    return status == QV_OK ? qv_pages_check(&scene->volume, QV_LINEAR_TAPS) : status;
}
