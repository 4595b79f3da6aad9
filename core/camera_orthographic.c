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
    camera->projection = &qv_projection_orthographic;
    return QV_OK;
}

int qv_ray_orthographic(qv_ray *ray, const qv_context *context, int32_t x, int32_t y)
{
    const qv_camera *camera = &context->scene.camera;
    for (unsigned axis = 0; axis < 3; axis++) {
        qv_coord along = camera->along[axis];
        ray->place[axis] = qv_pixel_point(camera->origin, camera, axis, x, y) +
                           qv_phase_of(along, context->scene.phase);
        ray->advance[axis] = along;
    }
    ray->first = -QV_GRID_LIMIT;
    return 1;
}

/* The largest component of a unit vector is at least 1/sqrt(3) > 1/2: every rotation of
   a pace of 2^-8 passes. 4096 voxels are then at most 2^21 samples long. */
static int in_range(const qv_camera *camera)
{
    return qv_largest(camera->pace) == 0 && qv_within(camera->along, QV_MOST_PACE) &&
           qv_largest(camera->along) >= QV_VOXEL >> 9;
}

QV_DESCRIPTOR qv_projection qv_projection_orthographic = {qv_ray_orthographic, in_range};
