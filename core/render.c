#include "camera.h"
#include "composite.h"
#include "fx_unorm.h"
#include "pixels.h"
#include "ray.h"

/* ---- Scene to context ---------------------------------------------------- */

/* Levels with 16 fraction bits of colour * opacity: p * 65536 / 255 for p <=
   255^2, as 65536 = 255 * 257 + 1. At most 255 * 65536. */
static uint32_t associated_level(uint8_t colour, uint8_t opacity)
{
    uint32_t p = (uint32_t)colour * opacity;
    return p * 257u + fx_div255_round(p);
}

static qv_status check_scene(const qv_scene *scene)
{
    qv_status status = qv_volume_check(&scene->volume);
    if (status != QV_OK)
        return status;
    if (!scene->sampling)
        return QV_ERROR_NULL;
    if (scene->sampling->storage != scene->volume.storage)
        return QV_ERROR_STORAGE;
    if (scene->volume.unit_distance != 0 && scene->volume.unit_distance != scene->camera.step)
        return QV_ERROR_UNIT;
    return qv_camera_check(&scene->camera);
}

qv_status qv_init(qv_context *context, const qv_scene *scene)
{
    if (!context || !scene)
        return QV_ERROR_NULL;
    qv_status status = check_scene(scene);
    if (status != QV_OK)
        return status;
    const uint8_t *background = scene->background;
    context->volume = scene->volume;
    context->camera = scene->camera;
    context->sampling = scene->sampling;
    for (unsigned c = 0; c < 4; c++)
        context->background[c] = associated_level(c < 3 ? background[c] : 255, background[3]);
    context->termination = (uint32_t)scene->termination << 15;
    context->phase = scene->phase;
    return QV_OK;
}

/* ---- One pixel ------------------------------------------------------------ */

/* Puts the background behind the light and turns both into levels. */
static void finish(qv_pixel *pixel, const qv_light *light, const qv_context *context)
{
    uint32_t transmittance = light->transmittance; /* Q1.31, so level * T * 2 / 2^32 */
    uint32_t covered = QV_LEVEL_ONE - fx_high_product(transmittance, QV_LEVEL_ONE << 1);
    uint32_t opacity = covered + fx_high_product(transmittance, context->background[3] << 1);
    if (opacity > QV_LEVEL_ONE)
        opacity = QV_LEVEL_ONE;
    for (unsigned c = 0; c < 3; c++) {
        uint32_t level = fx_high_product(light->colour[c], context->sampling->read_out) +
                         fx_high_product(transmittance, context->background[c] << 1);
        pixel->channel[c] = level < opacity ? level : opacity;
    }
    pixel->channel[3] = opacity;
}

static void render_pixel(qv_pixel *pixel, qv_progress *progress, const qv_context *context,
                         int32_t x, int32_t y)
{
    qv_ray ray;
    qv_light light = {{0, 0, 0}, QV_CLEAR, 0, 0};
    context->camera.ray(&ray, context, x, y);
    progress->samples += ray.samples;
    if (ray.samples != 0)
        context->sampling->march(&light, &ray, context);
    progress->samples -= ray.samples; /* those that were not taken */
    progress->skipped += light.skipped;
    progress->terminated += (uint32_t)light.terminated;
    finish(pixel, &light, context);
    pixel->x = (uint32_t)x;
    pixel->y = (uint32_t)y;
}

/* ---- Rows and rectangles --------------------------------------------------- */

size_t qv_row_bytes(const qv_format *format, uint16_t width)
{
    return (size_t)(((uint32_t)width * format->bits + 7u) >> 3);
}

static qv_status check_rect(const qv_rect *rect)
{
    if (rect->left < -QV_PIXEL_MAX || rect->right > QV_PIXEL_MAX || rect->left >= rect->right)
        return QV_ERROR_RECT;
    if (rect->top < -QV_PIXEL_MAX || rect->bottom > QV_PIXEL_MAX || rect->top >= rect->bottom)
        return QV_ERROR_RECT;
    return QV_OK;
}

/* Whether rows of the rectangle fit into the image's memory, side by side. */
static qv_status check_buffer(const qv_image *image, uint16_t width, uint16_t height)
{
    const qv_format *format = image->format;
    size_t row = qv_row_bytes(format, width), bytes = image->bytes;
    uint32_t gaps = (uint32_t)(height - 1) >> format->line_shift; /* rows of bytes less one */
    size_t stride = image->stride < 0 ? (size_t)0 - (size_t)image->stride : (size_t)image->stride;
    if (bytes < row)
        return QV_ERROR_BUFFER;
    if (gaps == 0)
        return QV_OK;
    if (stride < row || stride > bytes)
        return QV_ERROR_BUFFER;
    for (size_t left = bytes - row; gaps != 0; gaps--) {
        if (left < stride)
            return QV_ERROR_BUFFER;
        left -= stride;
    }
    return QV_OK;
}

static qv_status check_render(const qv_image *image, const qv_progress *progress,
                              const qv_context *context, const qv_rect *rect)
{
    if (!image || !progress || !context || !rect || !image->pixels || !image->format)
        return QV_ERROR_NULL;
    qv_status status = check_rect(rect);
    if (status != QV_OK)
        return status;
    if (progress->line > rect->bottom - rect->top || progress->column >= rect->right - rect->left)
        return QV_ERROR_RECT;
    return check_buffer(image, (uint16_t)(rect->right - rect->left),
                        (uint16_t)(rect->bottom - rect->top));
}

static void render_next(const qv_image *image, qv_progress *progress, const qv_context *context,
                        const qv_rect *rect)
{
    const qv_format *format = image->format;
    uint16_t column = progress->column, line = progress->line;
    uint8_t *row = (uint8_t *)image->pixels + (line >> format->line_shift) * image->stride;
    qv_pixel pixel;
    render_pixel(&pixel, progress, context, rect->left + column, rect->top + line);
    format->store(row, column, line, &pixel);
    progress->column++;
    if (progress->column == rect->right - rect->left) {
        progress->column = 0;
        progress->line++;
    }
}

qv_status qv_render_some(const qv_image *image, qv_progress *progress, const qv_context *context,
                         const qv_rect *rect, uint32_t max_pixels)
{
    qv_status status = check_render(image, progress, context, rect);
    if (status != QV_OK)
        return status;
    while (progress->line != rect->bottom - rect->top) {
        render_next(image, progress, context, rect);
        if (max_pixels <= 1)
            break;
        max_pixels--;
    }
    return progress->line != rect->bottom - rect->top ? QV_MORE : QV_OK;
}

qv_status qv_render(const qv_image *image, const qv_context *context, const qv_rect *rect)
{
    qv_progress progress = {0, 0, 0, 0, 0};
    return qv_render_some(image, &progress, context, rect, 0xFFFFFFFFu);
}
