#include "composite.h"
#include "image.h"
#include "pages.h"
#include "pixels.h"
#include "ray.h"

/* Puts the background behind the light and turns both into levels. */
static void finish(qv_pixel *pixel, const qv_light *light, const qv_context *context)
{
    uint32_t transmittance = light->transmittance; /* Q1.31, so 2 * level * T / 2^32 */
    uint32_t covered = QV_LEVEL_ONE - fx_high_product(transmittance, QV_LEVEL_ONE << 1);
    /* background[3] <= 2 * QV_LEVEL_ONE, so no more is added than was taken away */
    uint32_t opacity = covered + fx_high_product(transmittance, context->background[3]);
    for (unsigned c = 0; c < 3; c++) {
        uint32_t level =
            fx_high_product(light->colour[c], QV_FIELD(context->scene.sampling, read_out)) +
            fx_high_product(transmittance, context->background[c]);
        pixel->channel[c] = level < opacity ? level : opacity;
    }
    pixel->channel[3] = opacity;
}

/* A pixel of the frame, and the light there. */
typedef struct spot {
    qv_light light;
    int32_t x, y;
} spot;

/* The light of a pixel's ray. Written into its callers, of which one counts nothing: no frame of
   it lies between them and the ray's march. */
FX_INLINE void trace(spot *at, qv_progress *counts, const qv_context *context)
{
    const qv_light clear = {{0, 0, 0}, QV_CLEAR, 0, 0};
    qv_ray ray;
    at->light = clear;
    int hits = QV_FIELD(context->scene.camera.projection, ray)(&ray, context, at->x, at->y);
    if (hits)
        QV_FIELD(context->scene.sampling, march)(&at->light, &ray, context);
    if (!counts)
        return;
    if (hits)
        counts->samples += ray.all - ray.samples; /* those that were taken */
    counts->skipped += at->light.skipped;
    counts->terminated += (uint32_t)at->light.terminated;
}

/* Its pixel is made when the ray is gone: the stack holds one of them at a time. */
static FX_NOINLINE void put(const qv_image *image, const spot *at, const qv_context *context,
                            const qv_rect *rect)
{
    unsigned column = (unsigned)(at->x - rect->left), line = (unsigned)(at->y - rect->top);
    ptrdiff_t offset = (ptrdiff_t)(line >> QV_FIELD(image->format, line_shift)) * image->stride;
    qv_pixel pixel;
    finish(&pixel, &at->light, context);
    pixel.x = (uint32_t)at->x;
    pixel.y = (uint32_t)at->y;
    QV_FIELD(image->format, store)((uint8_t *)image->pixels + offset, column, line, &pixel);
}

static int is_within(const qv_progress *progress, const qv_rect *rect)
{
    return rect->top + progress->line <= rect->bottom &&
           rect->left + progress->column < rect->right;
}

qv_status qv_render_some(const qv_image *image, qv_progress *progress, const qv_context *context,
                         const qv_rect *rect, uint32_t max_pixels)
{
    qv_status status = context && progress ? qv_image_check(image, rect) : QV_ERROR_NULL;
    if (status == QV_OK && !is_within(progress, rect))
        status = QV_ERROR_RECT;
    if (status != QV_OK)
        return status;
    for (uint32_t left = max_pixels; rect->top + progress->line != rect->bottom; left--) {
        spot at;
        if (left == 0)
            return QV_MORE;
        at.x = rect->left + progress->column;
        at.y = rect->top + progress->line;
        trace(&at, progress, context);
        put(image, &at, context, rect);
        if (at.x + 1 == rect->right) {
            progress->column = 0;
            progress->line++;
        } else {
            progress->column++;
        }
    }
    return qv_pages_status(&context->scene.volume);
}

qv_status qv_render(const qv_image *image, const qv_context *context, const qv_rect *rect)
{
    qv_status status = context ? qv_image_check(image, rect) : QV_ERROR_NULL;
    if (status != QV_OK)
        return status;
    spot at;
    for (at.y = rect->top; at.y != rect->bottom; at.y++)
        for (at.x = rect->left; at.x != rect->right; at.x++) {
            trace(&at, 0, context);
            put(image, &at, context, rect);
        }
    return qv_pages_status(&context->scene.volume);
}
