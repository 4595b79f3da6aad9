#include "camera.h"

#include "fx_angle.h"
#include "fx_wide.h"
#include "layout.h"

#define LEAST_PITCH (QV_ONE_Q16 >> 12)
#define MOST_PITCH  (QV_ONE_Q16 << 12)
#define LEAST_STEP  (QV_ONE_Q16 / 16u)
#define MOST_STEP   (QV_ONE_Q16 * 16u)

static int32_t times_q30(int32_t a, int32_t b)
{
    return (int32_t)fx_scale_q30(a, b);
}

void qv_rotation(int32_t rotation[3][3], qv_angle azimuth, qv_angle elevation, qv_angle roll)
{
    int32_t sa, ca, se, ce, sr, cr;
    fx_sine_cosine(&sa, &ca, azimuth);
    fx_sine_cosine(&se, &ce, elevation);
    fx_sine_cosine(&sr, &cr, roll);

    const int32_t right[3] = {ca, sa, 0};
    const int32_t down[3] = {times_q30(sa, se), -times_q30(ca, se), -ce};
    const int32_t forward[3] = {-times_q30(sa, ce), times_q30(ca, ce), -se};
    for (unsigned axis = 0; axis < 3; axis++) {
        rotation[0][axis] = times_q30(right[axis], cr) + times_q30(down[axis], sr);
        rotation[1][axis] = times_q30(down[axis], cr) - times_q30(right[axis], sr);
        rotation[2][axis] = forward[axis];
    }
}

qv_coord qv_to_voxels(qv_coord v, uint32_t spacing)
{
    uint64_t size = v < 0 ? 0u - (uint64_t)v : (uint64_t)v;
    uint64_t whole = fx_divide(size, spacing);
    /* rest < spacing, so rest * 2^16 < 2^40; whole * 2^16 < 2^62 */
    uint64_t rest = size - whole * spacing;
    uint64_t voxels = (whole << 16) + fx_divide((rest << 16) + (spacing >> 1), spacing);
    return v < 0 ? -(qv_coord)voxels : (qv_coord)voxels;
}

static qv_status check_frame(const qv_view *view)
{
    if (view->width == 0 || view->width > QV_PIXEL_MAX)
        return QV_ERROR_VIEW;
    if (view->height == 0 || view->height > QV_PIXEL_MAX)
        return QV_ERROR_VIEW;
    if (view->pitch < LEAST_PITCH || view->pitch > MOST_PITCH)
        return QV_ERROR_VIEW;
    if (view->step < LEAST_STEP || view->step > MOST_STEP)
        return QV_ERROR_STEP;
    for (unsigned i = 0; i < 9; i++) {
        int32_t v = view->rotation[i / 3u][i % 3u];
        if (v < -FX_ONE_Q30 || v > FX_ONE_Q30)
            return QV_ERROR_CAMERA;
    }
    return QV_OK;
}

qv_status qv_view_check(const qv_volume *volume, const qv_view *view)
{
    qv_status status = check_frame(view);
    if (status == QV_OK)
        status = qv_spacing_check(volume->spacing);
    for (unsigned axis = 0; status == QV_OK && axis < 3; axis++) {
        uint32_t spacing = qv_spacing(volume->spacing, axis);
        qv_coord pitch = qv_to_voxels((qv_coord)view->pitch << 16, spacing);
        qv_coord pace = qv_to_voxels((qv_coord)view->step << 16, spacing);
        if (volume->size[axis] == 0 || volume->size[axis] > QV_AXIS_MAX)
            status = QV_ERROR_SIZE;
        else if (pitch > QV_MOST_PITCH)
            status = QV_ERROR_VIEW;
        else if (pace < QV_LEAST_PACE || pace > QV_MOST_PACE)
            status = QV_ERROR_STEP;
    }
    return status;
}

qv_coord qv_half_frame(const qv_camera *camera, unsigned axis, const qv_view *view)
{
    /* below 2 * 2^44 * 2^15 */
    qv_coord span = camera->across[axis] * (view->width - 1) + camera->down[axis] * (view->height - 1);
    return fx_shift_floor(span + 1, 1);
}
