#include "buffer.h"
#include "image.h"
#include "pixels.h"

/* A level with 23 fraction bits, to nearest with 16. */
static uint32_t level_of(uint32_t light)
{
    return (light + 64u) >> 7;
}

/* Levels of what a pixel of a frame buffer shows; front to back, the background behind it. */
static void finish(qv_pixel *pixel, const qv_fragment *fragment, const qv_context *context,
                   int background)
{
    uint32_t behind = background ? 0xFFFFFFFFu - fragment->opacity : 0u;
    uint32_t opacity = level_of(fx_light_of_colour32(255, fragment->opacity));
    opacity += fx_high_product(behind, context->background[3]) >> 1;
    for (unsigned c = 0; c < 3; c++) {
        uint32_t level =
            level_of(fragment->light[c]) + (fx_high_product(behind, context->background[c]) >> 1);
        pixel->channel[c] = level < opacity ? level : opacity;
    }
    pixel->channel[3] = opacity;
}

qv_status qv_read_out(const qv_image *image, const qv_buffer *buffer, const qv_context *context,
                      const qv_rect *rect)
{
    qv_status status = context ? qv_buffer_check(buffer, rect) : QV_ERROR_NULL;
    if (status == QV_OK)
        status = qv_image_check(image, rect);
    if (status != QV_OK)
        return status;
    unsigned width = (unsigned)(rect->right - rect->left);
    unsigned height = (unsigned)(rect->bottom - rect->top);
    for (unsigned line = 0; line < height; line++) {
        ptrdiff_t offset = (ptrdiff_t)(line >> QV_FIELD(image->format, line_shift)) * image->stride;
        for (unsigned column = 0; column < width; column++) {
            qv_fragment fragment;
            qv_pixel pixel;
            qv_buffer_read(&fragment, buffer, column, line);
            finish(&pixel, &fragment, context, QV_FIELD(buffer->blend, kind) == QV_UNDER);
            pixel.x = (uint32_t)rect->left + column;
            pixel.y = (uint32_t)rect->top + line;
            QV_FIELD(image->format, store)((uint8_t *)image->pixels + offset, column, line, &pixel);
        }
    }
    return QV_OK;
}
