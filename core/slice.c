#include "buffer.h"
#include "composite.h"
#include "image.h"
#include "pages.h"
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

/*
 * The ray of a row's next pixel, whose sample 0, of modes that know no lengths, is that of the
 * slice. Rays from an eye are made anew; others but the first of a row follow by addition to
 * `place`, that of the ray before, which is what it was until a mode took the ray's.
 */
static int next_ray(qv_ray *ray, qv_coord place[3], const qv_context *context, int32_t x, int32_t y,
                    int32_t slice, int first)
{
    const qv_camera *camera = &context->scene.camera;
    int32_t sample = QV_FIELD(context->scene.sampling, by_length) ? 0 : slice;
    if (!first && camera->pace[0] == 0) {
        qv_ray_right(ray, place, camera, sample);
        return 1;
    }
    if (!QV_FIELD(camera->projection, ray)(ray, context, x, y))
        return 0;
    if (sample != 0)
        qv_ray_count_from(ray, sample);
    for (unsigned axis = 0; axis < 3; axis++)
        place[axis] = ray->place[axis];
    return 1;
}

/* What a pixel sees of a slice. */
static void see(qv_light *light, const qv_context *context, qv_ray *ray, int32_t slice)
{
    const qv_sampling *sampling = context->scene.sampling;
    int placed = QV_FIELD(sampling, by_length) ? place_stretch(ray, context, slice)
                                               : qv_ray_hold(ray, context);
    if (placed)
        QV_FIELD(sampling, march)(light, ray, context);
}

/* ---- Its pixels --------------------------------------------------------------- */

/* A pixel of a row, and how the slice is blended into it. */
typedef struct spot {
    const qv_blend *blend;
    qv_place place;
    qv_moment moment;
} spot;

/* Whether nothing behind a pixel can be seen, as far as the scene's termination goes. */
static int closed(const spot *at, const qv_context *context)
{
    uint32_t enough = (uint32_t)context->scene.termination << 8; /* Q0.16 to Q0.24 */
    return QV_FIELD(at->blend, kind) == QV_UNDER && qv_bytes_read(at->place.beside, 3) <= enough;
}

static void fragment_of(qv_fragment *fragment, const qv_light *light, uint32_t read_out)
{
    for (unsigned c = 0; c < 3; c++) /* colours stay below 2^31 + 2^22 */
        fragment->light[c] = fx_light_of(light->colour[c], QV_LIGHT_OF(read_out));
    fragment->opacity =
        light->transmittance == 0 ? 0xFFFFFFFFu : (QV_CLEAR - light->transmittance) << 1;
}

/* Blends light into a pixel. The fragment is made when the ray is done: the stack holds one of them
   at a time. */
static FX_NOINLINE void put(spot *at, const qv_light *light, const qv_context *context)
{
    qv_fragment fragment = {{0, 0, 0}, 0};
    if (light->transmittance != QV_CLEAR)
        fragment_of(&fragment, light, QV_FIELD(context->scene.sampling, read_out));
    else if (QV_FIELD(at->blend, kind) != QV_HAND_OUT)
        return;
    qv_place_blend(&at->place, at->blend, &fragment, &at->moment);
}

qv_status qv_slice(const qv_buffer *buffer, const qv_dither *dither, const qv_context *context,
                   const qv_rect *rect, int32_t slice)
{
    spot at;
    qv_status status = context ? qv_buffer_check(buffer, rect) : QV_ERROR_NULL;
    if (status == QV_OK)
        status = qv_moment_of(&at.moment, dither, buffer->blend, slice);
    if (status != QV_OK)
        return status;
    at.blend = buffer->blend;
    for (int32_t y = rect->top; y < rect->bottom; y++) {
        qv_coord start[3] = {0, 0, 0};
        qv_ray ray;
        at.place = qv_place_of(buffer, &at.moment, rect, (unsigned)(y - rect->top));
        for (int32_t x = rect->left; x < rect->right; x++) {
            qv_light light = {{0, 0, 0}, QV_CLEAR, 0, 0};
            int hits = next_ray(&ray, start, context, x, y, slice, x == rect->left);
            if (!closed(&at, context)) {
                if (hits)
                    see(&light, context, &ray, slice);
                put(&at, &light, context);
            }
            qv_place_next(&at.place, at.blend, qv_dither_step(at.moment.spread));
        }
    }
    return qv_pages_status(&context->scene.volume);
}

/* ---- The slices of a rectangle ------------------------------------------------ */

/* Extends a range by the slices that a pixel may see, and one at each end. */
static void extend(int32_t *first, int32_t *end, const qv_context *context, int32_t x, int32_t y)
{
    qv_ray ray;
    if (!QV_FIELD(context->scene.camera.projection, ray)(&ray, context, x, y))
        return;
    qv_path_clip(&ray, context);
    if (ray.samples == 0)
        return;
    int32_t nearest = qv_stretch_of(ray.enter) - 1, farthest = qv_stretch_of(ray.leave) + 1;
    if (nearest < -QV_GRID_LIMIT)
        nearest = -QV_GRID_LIMIT;
    if (farthest >= QV_GRID_LIMIT)
        farthest = QV_GRID_LIMIT - 1;
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
