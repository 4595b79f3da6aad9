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

/* The light of a pixel's ray. */
static void trace(qv_light *light, qv_progress *progress, const qv_context *context,
                  const qv_rect *rect)
{
    int32_t x = rect->left + progress->column, y = rect->top + progress->line;
    qv_ray ray;
    if (QV_FIELD(context->scene.camera.projection, ray)(&ray, context, x, y)) {
        QV_FIELD(context->scene.sampling, march)(light, &ray, context);
        progress->samples += ray.all - ray.samples; /* those that were taken */
    }
    progress->skipped += light->skipped;
    progress->terminated += (uint32_t)light->terminated;
}

/* Its pixel is made when the ray is gone: the stack holds one of them at a time. */
static FX_NOINLINE void put_light(const qv_image *image, const qv_progress *at,
                                  const qv_context *context, const qv_light *light,
                                  const qv_rect *rect)
{
    unsigned column = at->column, line = at->line;
    ptrdiff_t offset = (ptrdiff_t)(line >> QV_FIELD(image->format, line_shift)) * image->stride;
    qv_pixel pixel;
    finish(&pixel, light, context);
    pixel.x = (uint32_t)(rect->left + at->column);
    pixel.y = (uint32_t)(rect->top + at->line);
    QV_FIELD(image->format, store)((uint8_t *)image->pixels + offset, column, line, &pixel);
}

static void render_next(const qv_image *image, qv_progress *progress, const qv_context *context,
                        const qv_rect *rect)
{
    qv_light light = {{0, 0, 0}, QV_CLEAR, 0, 0};
    trace(&light, progress, context, rect);
    put_light(image, progress, context, &light, rect);
}

qv_status qv_render_some(const qv_image *image, qv_progress *progress, const qv_context *context,
                         const qv_rect *rect, uint32_t max_pixels)
{
    qv_status status = context ? qv_image_check(image, progress, rect) : QV_ERROR_NULL;
    if (status != QV_OK)
        return status;
    for (uint32_t left = max_pixels; rect->top + progress->line != rect->bottom; left--) {
        if (left == 0)
            return QV_MORE;
        render_next(image, progress, context, rect);
        if (rect->left + ++progress->column == rect->right) {
            progress->column = 0;
            progress->line++;
        }
    }
    return qv_pages_status(&context->scene.volume);
}

qv_status qv_render(const qv_image *image, const qv_context *context, const qv_rect *rect)
{
    qv_progress progress;
    progress.column = 0;
    progress.line = 0;
    progress.terminated = 0;
    progress.samples = 0;
    progress.skipped = 0;
    return qv_render_some(image, &progress, context, rect, 0xFFFFFFFFu);
}
