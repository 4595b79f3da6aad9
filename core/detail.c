#include "camera.h"
#include "fx_log.h"
#include "fx_wide.h"
#include "layout.h"
#include "level.h"

/* An eye that qv_init accepts is nearer to the volume's centre: at most 2^20 paces from
   the volume's origin on each axis, and the centre at most 2^19 from there. */
#define MOST_STEPS_Q16 ((uint64_t)1 << 38)

static uint32_t least_spacing(const qv_volume *volume)
{
    uint32_t least = qv_spacing(volume->spacing, 0);
    for (unsigned axis = 1; axis < 3; axis++)
        if (qv_spacing(volume->spacing, axis) < least)
            least = qv_spacing(volume->spacing, axis);
    return least;
}

/* log2(pitch / spacing), Q8.8, to nearest; 0 where the pitch is less. The ratio of
   spacing to pitch is at least 2^-12, so cutting it to 32 bits moves the logarithm by less
   than 2^-19. */
static uint16_t level_of(uint32_t pitch, uint32_t spacing)
{
    if (pitch <= spacing)
        return 0;
    uint32_t ratio = (uint32_t)fx_divide((uint64_t)spacing << 32, pitch);
    return (uint16_t)((fx_depth_of_transmittance(ratio) + ((fx_depth)1 << 23)) >> 24);
}

/* Distance from the eye to the plane that shows at the view's pitch, in steps, Q16; 0
   where it lies behind the eye. The way to any pixel of the plane will do: `along`, at most
   2^20 world units an axis. */
static uint64_t steps_to_plane(const qv_camera *camera, const qv_view *view)
{
    qv_coord distance = 0; /* Q31.32, < 2^55 */
    for (unsigned axis = 0; axis < 3; axis++)
        distance += fx_scale_q30(camera->along[axis], view->rotation[2][axis]);
    uint64_t steps = distance > 0 ? fx_divide((uint64_t)distance, view->step) : 0;
    return steps < MOST_STEPS_Q16 ? steps : MOST_STEPS_Q16;
}

/* Where a pixel is as wide as a voxel: its width grows with the distance. In steps, cut, but
   at least 1. */
static uint32_t distance_of(uint64_t steps, uint32_t pitch, uint32_t spacing)
{
    uint64_t product = (uint64_t)fx_multiply((int64_t)steps, (int32_t)spacing); /* <= 2^62 */
    uint64_t distance = fx_divide(product, pitch) >> 16;
    if (distance > QV_MOST_DISTANCE)
        return QV_MOST_DISTANCE;
    return distance == 0 ? 1u : (uint32_t)distance;
}

qv_status qv_detail(qv_scene *scene, const qv_view *view)
{
    if (!scene || !view || !scene->pyramid)
        return QV_ERROR_NULL;
    qv_status status = qv_view_check(&scene->volume, view);
    if (status == QV_OK)
        status = qv_camera_check(&scene->camera);
    if (status != QV_OK)
        return status;

    uint32_t spacing = least_spacing(&scene->volume);
    if (scene->camera.pace[0] != 0) { /* perspective */
        uint64_t steps = steps_to_plane(&scene->camera, view);
        scene->level = 0;
        scene->level_distance = distance_of(steps, view->pitch, spacing);
    } else {
        uint16_t most = (uint16_t)(scene->pyramid->levels * 256u);
        uint16_t level = level_of(view->pitch, spacing);
        scene->level = level < most ? level : most;
        scene->level_distance = 0;
    }
    return QV_OK;
}
