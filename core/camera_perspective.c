#include "camera.h"
#include "eye.h"
#include "fx_root.h"
#include "fx_wide.h"
#include "layout.h"
#include "ray.h"

/* As a power of 2, and in world units: */
#define PACES_TO_EYE 20
#define MOST_ALONG   ((uint32_t)1 << 20)

/* Directions are halved until they have 31 bits, and then normalised. */
#define MOST_HALVED     ((uint64_t)1 << 31)
#define LEAST_DIRECTION ((uint64_t)1 << 16) /* 2^-16 world units */

/* A world length as voxels: v / spacing, to nearest; v in Q31.32, |v| < 2^55, and
   spacing Q16.16 of 2^12 .. 2^24. */
static qv_coord to_voxels(qv_coord v, uint32_t spacing)
{
    uint64_t size = v < 0 ? 0u - (uint64_t)v : (uint64_t)v;
    uint64_t whole = fx_divide(size, spacing); /* Q47.16, < 2^43 */
    /* < spacing, so rest * 2^16 < 2^40 */
    uint64_t rest = size - (uint64_t)fx_multiply((int64_t)whole, (int32_t)spacing);
    uint64_t voxels = (whole << 16) + fx_divide((rest << 16) + (spacing >> 1), spacing);
    return v < 0 ? -(qv_coord)voxels : (qv_coord)voxels;
}

qv_status qv_perspective(qv_camera *camera, const qv_volume *volume, const qv_view *view,
                         qv_angle field_of_view)
{
    if (!camera || !volume || !view)
        return QV_ERROR_NULL;
    qv_status status = qv_view_check(volume, view);
    if (status != QV_OK)
        return status;
    qv_coord distance;
    status = qv_eye_of(&distance, view, field_of_view);
    if (status != QV_OK)
        return status;
    qv_coord pitch = (qv_coord)view->pitch << 16;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t spacing = qv_spacing(volume->spacing, axis);
        int32_t forward = view->rotation[2][axis];
        qv_coord to_centre = to_voxels(fx_scale_q30(distance, forward), spacing);
        camera->origin[axis] = volume->size[axis] * (QV_VOXEL / 2) - to_centre;
        /* v leads to the pixel on the plane through the centre: exact there, whatever the
           rounding of the distance */
        camera->across[axis] = fx_scale_q30(pitch, view->rotation[0][axis]);
        camera->down[axis] = fx_scale_q30(pitch, view->rotation[1][axis]);
        camera->along[axis] = fx_scale_q30(distance, forward) - qv_half_frame(camera, axis, view);
        camera->pace[axis] = qv_voxels(view->step, volume, axis);
    }
    camera->step = view->step;
    camera->projection = &qv_projection_perspective;
    return QV_OK;
}

/* Magnitudes of v, halved alike until each is below 2^31; 0 where v is too short. */
static int halve(uint32_t size[3], const qv_coord v[3])
{
    uint64_t long_size[3], all = 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        long_size[axis] = v[axis] < 0 ? 0u - (uint64_t)v[axis] : (uint64_t)v[axis];
        all |= long_size[axis];
    }
    if (all < LEAST_DIRECTION)
        return 0;
    unsigned shift = 0;
    for (; all >= MOST_HALVED; all >>= 1)
        shift++;
    for (unsigned axis = 0; axis < 3; axis++)
        size[axis] = (uint32_t)(long_size[axis] >> shift);
    return 1;
}

/* Scales a world direction to length 1, Q2.30; 0 where it is too short. */
static int normalise(int32_t unit[3], const qv_coord direction[3])
{
    uint32_t size[3];
    uint64_t square = 0;
    unsigned exponent;
    if (!halve(size, direction))
        return 0;
    for (unsigned axis = 0; axis < 3; axis++)
        square += fx_wide_product(size[axis], size[axis]); /* < 3 * 2^62 */
    uint32_t root = fx_rsqrt(square, &exponent);
    for (unsigned axis = 0; axis < 3; axis++) {
        /* size * root < 2^62; exponent >= 16; the quotient is at most 2^30 and a little */
        uint64_t product = fx_wide_product(size[axis], root) + ((uint64_t)1 << (exponent - 1u));
        int32_t length = (int32_t)(product >> exponent);
        length = length > FX_ONE_Q30 ? FX_ONE_Q30 : length;
        unit[axis] = direction[axis] < 0 ? -length : length;
    }
    return 1;
}

int qv_ray_perspective(qv_ray *ray, const qv_context *context, int32_t x, int32_t y)
{
    const qv_camera *camera = &context->scene.camera;
    qv_coord direction[3];
    int32_t unit[3];
    for (unsigned axis = 0; axis < 3; axis++)
        direction[axis] = qv_pixel_point(camera->along, camera, axis, x, y);
    if (!normalise(unit, direction))
        return 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        ray->advance[axis] = fx_scale_q30(camera->pace[axis], unit[axis]);
        ray->place[axis] =
            camera->origin[axis] + qv_phase_of(ray->advance[axis], context->scene.phase);
    }
    ray->first = 0;
    return 1;
}

/*
 * The eye lies at most 2^20 paces off on each axis; the volume is at most 2^20 of them
 * long, so k stays below sqrt(3) * 2^21 < QV_GRID_LIMIT.
 */
static int in_range(const qv_camera *camera)
{
    if (!qv_within(camera->pace, QV_MOST_PACE))
        return 0;
    for (unsigned axis = 0; axis < 3; axis++) {
        qv_coord pace = camera->pace[axis], origin = camera->origin[axis];
        if (pace < QV_VOXEL >> 8)
            return 0;
        qv_coord reach = pace << PACES_TO_EYE; /* <= 2^60 */
        if (origin > reach || origin < -reach)
            return 0;
    }
    return qv_within(camera->along, MOST_ALONG);
}

QV_DESCRIPTOR qv_projection qv_projection_perspective = {qv_ray_perspective, in_range};
