#include "camera.h"
#include "fx_wide.h"
#include "ray.h"

qv_status qv_orthographic(qv_camera *camera, const qv_volume *volume, const qv_view *view)
{
    if (!camera || !volume || !view)
        return QV_ERROR_NULL;
    qv_status status = qv_view_check(volume, view);
    if (status != QV_OK)
        return status;
    for (unsigned axis = 0; axis < 3; axis++) {
        qv_coord pitch = qv_voxels(view->pitch, volume, axis);
        qv_coord pace = qv_voxels(view->step, volume, axis);
        camera->across[axis] = fx_scale_q30(pitch, view->rotation[0][axis]);
        camera->down[axis] = fx_scale_q30(pitch, view->rotation[1][axis]);
        camera->along[axis] = fx_scale_q30(pace, view->rotation[2][axis]);
        camera->pace[axis] = 0;
        camera->origin[axis] =
            volume->size[axis] * (QV_VOXEL / 2) - qv_half_frame(camera, axis, view);
    }
    camera->step = view->step;
    camera->ray = qv_ray_orthographic;
    return QV_OK;
}

void qv_ray_orthographic(struct qv_ray *ray, const struct qv_context *context, int32_t x, int32_t y)
{
    const qv_camera *camera = &context->scene.camera;
    for (unsigned axis = 0; axis < 3; axis++) {
        qv_coord along = camera->along[axis];
        ray->place[axis] = qv_pixel_point(camera->origin, camera, axis, x, y) +
                           qv_phase_of(along, context->scene.phase);
        ray->advance[axis] = along;
    }
    qv_ray_clip(ray, context->scene.volume.size, -QV_GRID_LIMIT);
}
