#include "buffer.h"
#include "image.h"

/* Rows of a rectangle's pixels, of so many bytes each, as those of an image. */
static qv_status check_plane(void *pixels, size_t bytes, ptrdiff_t stride, unsigned pixel_bytes,
                             const qv_rect *rect)
{
    const qv_format format = {0, (uint8_t)(8u * pixel_bytes), 0};
    const qv_image image = {pixels, bytes, stride, &format};
    const qv_progress none = {0, 0, 0, 0, 0};
    return qv_image_check(&image, &none, rect);
}

qv_status qv_buffer_check(const qv_buffer *buffer, const qv_rect *rect)
{
    if (!buffer || !buffer->blend)
        return QV_ERROR_NULL;
    const qv_blend *blend = buffer->blend;
    qv_status status =
        check_plane(buffer->pixels, buffer->bytes, buffer->stride, blend->bytes, rect);
    if (status == QV_OK && blend->beside != 0)
        status = check_plane(buffer->beside, buffer->beside_bytes, buffer->beside_stride,
                             blend->beside, rect);
    return status;
}

/* Pixels without bytes have room anywhere. */
qv_status qv_rect_check(const qv_rect *rect)
{
    uint8_t anywhere;
    return check_plane(&anywhere, 1, 0, 0, rect);
}

void qv_buffer_blend(const qv_buffer *buffer, const qv_fragment *fragment, const qv_moment *slice,
                     const qv_dither *dither, const qv_rect *rect, int32_t x, int32_t y)
{
    unsigned column = (unsigned)(x - rect->left), line = (unsigned)(y - rect->top);
    uint8_t *pixel = qv_buffer_pixel(buffer, column, line);
    qv_moment moment = *slice;
    qv_moment_shift(&moment, slice, dither, x, y);
    if (moment.technique)
        qv_moment_opacity(&moment, buffer->blend, pixel, fragment);
    buffer->blend->blend(pixel, qv_buffer_beside(buffer, column, line), fragment, &moment);
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
        for (unsigned column = 0; column < width; column++)
            buffer->blend->clear(qv_buffer_pixel(buffer, column, line),
                                 qv_buffer_beside(buffer, column, line), &background);
    return QV_OK;
}

qv_status qv_combine(const qv_buffer *behind, const qv_buffer *front, const qv_dither *dither,
                     const qv_rect *rect, int32_t slice)
{
    qv_moment moment;
    qv_status status = qv_buffer_check(behind, rect);
    if (status == QV_OK)
        status = qv_buffer_check(front, rect);
    if (status == QV_OK)
        status = qv_moment_of(&moment, dither, behind->blend, slice);
    if (status != QV_OK)
        return status;
    for (int32_t y = rect->top; y < rect->bottom; y++)
        for (int32_t x = rect->left; x < rect->right; x++) {
            qv_fragment fragment;
            qv_buffer_read(&fragment, front, (unsigned)(x - rect->left), (unsigned)(y - rect->top));
            qv_buffer_blend(behind, &fragment, &moment, dither, rect, x, y);
        }
    return QV_OK;
}
