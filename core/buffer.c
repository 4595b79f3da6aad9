#include "buffer.h"
#include "image.h"

qv_status qv_buffer_check(const qv_buffer *buffer, const qv_rect *rect)
{
    if (!buffer || !buffer->blend)
        return QV_ERROR_NULL;
    const qv_blend *blend = buffer->blend;
    qv_status status = qv_plane_check(buffer->pixels, buffer->bytes, buffer->stride,
                                      8u * QV_FIELD(blend, bytes), rect);
    if (status == QV_OK && QV_FIELD(blend, beside) != 0)
        status = qv_plane_check(buffer->beside, buffer->beside_bytes, buffer->beside_stride,
                                8u * QV_FIELD(blend, beside), rect);
    return status;
}

/* The background, over nothing: associated, from levels with 17 fraction bits. */
static void background_of(qv_fragment *fragment, const qv_context *context)
{
    for (unsigned c = 0; c < 3; c++)
        fragment->light[c] = context->background[c] << 6; /* <= 255 * 2^23 */
    fragment->opacity = (uint32_t)context->scene.background[3] * 0x01010101u;
}

qv_status qv_clear(const qv_buffer *buffer, const qv_context *context, const qv_rect *rect)
{
    qv_status status = context ? qv_buffer_check(buffer, rect) : QV_ERROR_NULL;
    if (status != QV_OK)
        return status;
    unsigned width = (unsigned)(rect->right - rect->left);
    unsigned height = (unsigned)(rect->bottom - rect->top);
    qv_fragment background;
    background_of(&background, context);
    for (unsigned line = 0; line < height; line++)
        for (unsigned column = 0; column < width; column++) {
            uint8_t *pixel = qv_buffer_pixel(buffer, column, line);
            uint8_t *beside = qv_buffer_beside(buffer, column, line);
            QV_FIELD(buffer->blend, clear)(pixel, beside, &background);
        }
    return QV_OK;
}

qv_status qv_combine(const qv_buffer *behind, const qv_buffer *front, const qv_dither *dither,
                     const qv_rect *rect, int32_t slice)
{
    qv_moment moment;
    qv_status status = qv_buffer_check(behind, rect);
    if (status == QV_OK)
        status = QV_FIELD(behind->blend, kind) == QV_UNDER ? QV_ERROR_BUFFER
                                                           : qv_buffer_check(front, rect);
    if (status == QV_OK)
        status = dither ? QV_OK : QV_ERROR_NULL;
    if (status != QV_OK)
        return status;
    qv_dither of_picture = *dither;
    of_picture.technique = &qv_technique_rounded; /* what techniques do was done when it was made */
    status = qv_moment_of(&moment, &of_picture, behind->blend, slice);
    if (status != QV_OK)
        return status;
    uint32_t step = qv_dither_step(moment.spread);
    unsigned width = (unsigned)(rect->right - rect->left);
    unsigned height = (unsigned)(rect->bottom - rect->top);
    for (unsigned line = 0; line < height; line++) {
        qv_place place = qv_place_of(behind, &moment, rect, line);
        for (unsigned column = 0; column < width; column++) {
            qv_fragment fragment;
            qv_buffer_read(&fragment, front, column, line);
            qv_place_blend(&place, behind->blend, &fragment, &moment);
            qv_place_next(&place, behind->blend, step);
        }
    }
    return QV_OK;
}
