#include "buffer.h"
#include "composite.h"
#include "stretch.h"

/* ---- The ray of one slice --------------------------------------------------- */

/* One stretch, from border to border, or from the eye. */
static int place_stretch(qv_ray *ray, const qv_context *context, int32_t slice)
{
    int64_t begin = qv_path_begin(ray, &context->scene);
    ray->enter = slice * QV_STEP - QV_HALF_STEP;
    ray->leave = slice * QV_STEP + QV_HALF_STEP;
    if (ray->enter < begin)
        ray->enter = begin;
    ray->first = QV_ONE_SLICE;
    return ray->enter < ray->leave;
}

/* What a pixel sees of a slice; 0 where that is nothing. */
static int see(qv_fragment *fragment, const qv_context *context, int32_t x, int32_t y,
               int32_t slice)
{
    const qv_sampling *sampling = context->scene.sampling;
    qv_ray ray;
    qv_light light = {{0, 0, 0}, QV_CLEAR, 0, 0};
    if (!context->scene.camera.projection->ray(&ray, context, x, y))
        return 0;
    int placed = sampling->by_length ? place_stretch(&ray, context, slice)
                                     : qv_ray_place(&ray, context, slice);
    if (!placed)
        return 0;
    sampling->march(&light, &ray, context);
    if (light.transmittance == QV_CLEAR)
        return 0;
    for (unsigned c = 0; c < 3; c++) /* colours stay below 2^31 + 2^22 */
        fragment->light[c] = 2u * fx_high_product(light.colour[c], QV_LIGHT_OF(sampling->read_out));
    fragment->opacity =
        light.transmittance == 0 ? 0xFFFFFFFFu : (QV_CLEAR - light.transmittance) << 1;
    return 1;
}

/* Whether nothing behind a pixel can be seen, as far as the scene's termination goes. */
static int closed(const qv_buffer *buffer, const qv_context *context, unsigned column,
                  unsigned line)
{
    uint32_t enough = (uint32_t)context->scene.termination << 8; /* Q0.16 to Q0.24 */
    return buffer->blend->kind == QV_UNDER &&
           qv_bytes_read(qv_buffer_beside(buffer, column, line), 3) <= enough;
}

qv_status qv_slice(const qv_buffer *buffer, const qv_dither *dither, const qv_context *context,
                   const qv_rect *rect, int32_t slice)
{
    qv_moment moment;
    qv_status status = context ? qv_buffer_check(buffer, rect) : QV_ERROR_NULL;
    if (status == QV_OK)
        status = qv_moment_of(&moment, dither, buffer->blend, slice);
    if (status != QV_OK)
        return status;
    for (int32_t y = rect->top; y < rect->bottom; y++)
        for (int32_t x = rect->left; x < rect->right; x++) {
            qv_fragment fragment = {{0, 0, 0}, 0};
            if (closed(buffer, context, (unsigned)(x - rect->left), (unsigned)(y - rect->top)))
                continue;
            if (see(&fragment, context, x, y, slice) || buffer->blend->kind == QV_HAND_OUT)
                qv_buffer_blend(buffer, &fragment, &moment, dither, rect, x, y);
        }
    return QV_OK;
}

/* ---- The slices of a rectangle ------------------------------------------------ */

/* Extends a range by the slices that a pixel may see, and one at each end. */
static void extend(int32_t *first, int32_t *end, const qv_context *context, int32_t x, int32_t y)
{
    qv_ray ray;
    if (!context->scene.camera.projection->ray(&ray, context, x, y))
        return;
    qv_path_clip(&ray, context);
    if (ray.samples == 0)
        return;
    int32_t nearest = qv_stretch_of(ray.enter) - 1, farthest = qv_stretch_of(ray.leave) + 1;
    if (*first == *end) {
        *first = nearest;
        *end = farthest + 1;
    }
    if (nearest < *first)
        *first = nearest;
    if (farthest >= *end)
        *end = farthest + 1;
}

qv_status qv_slice_range(int32_t *first, int32_t *end, const qv_context *context,
                         const qv_rect *rect)
{
    qv_status status = first && end && context ? qv_rect_check(rect) : QV_ERROR_NULL;
    if (status != QV_OK)
        return status;
    *first = 0;
    *end = 0;
    for (int32_t y = rect->top; y < rect->bottom; y++)
        for (int32_t x = rect->left; x < rect->right; x++)
            extend(first, end, context, x, y);
    return QV_OK;
}
