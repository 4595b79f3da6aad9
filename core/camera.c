#include "camera.h"

#include "fx_angle.h"
#include "fx_inline.h"
#include "fx_wide.h"
#include "layout.h"

#define LEAST_PITCH (QV_ONE_Q16 >> 12)
#define MOST_PITCH  (QV_ONE_Q16 << 8)
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

/* Dissolves into both checks, since each links only its own. */
FX_INLINE int frame_in_range(const qv_view *view)
{
    return view->width != 0 && view->width <= QV_PIXEL_MAX && view->height != 0 &&
           view->height <= QV_PIXEL_MAX && view->pitch >= LEAST_PITCH && view->pitch <= MOST_PITCH;
}

qv_status qv_frame_check(const qv_volume *volume, const qv_view *view)
{
    return frame_in_range(view) ? qv_spacing_check(volume->spacing) : QV_ERROR_VIEW;
}

qv_status qv_view_check(const qv_volume *volume, const qv_view *view)
{
    if (!frame_in_range(view))
        return QV_ERROR_VIEW;
    if (view->step < LEAST_STEP || view->step > MOST_STEP)
        return QV_ERROR_STEP;
    return qv_spacing_check(volume->spacing);
}

qv_coord qv_voxels(uint32_t length, const qv_volume *volume, unsigned axis)
{
    uint32_t spacing = qv_spacing(volume->spacing, axis);
    return (qv_coord)fx_divide(((uint64_t)length << 32) + (spacing >> 1), spacing);
}

qv_coord qv_half_frame(const qv_camera *camera, unsigned axis, const qv_view *view)
{
    /* each below 2^45 * 2^15 */
    qv_coord width = fx_multiply(camera->across[axis], view->width - 1);
    qv_coord height = fx_multiply(camera->down[axis], view->height - 1);
    return fx_shift_floor(width + height + 1, 1);
}
