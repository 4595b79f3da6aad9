/*
 * buffer.h - checks of frame buffers, and where their pixels lie.
 */
#ifndef QV_BUFFER_H
#define QV_BUFFER_H

#include "blend.h"

/* What every function checks of a buffer and its rectangle. QV_OK, QV_ERROR_NULL, _RECT,
   _BUFFER. */
qv_status qv_buffer_check(const qv_buffer *buffer, const qv_rect *rect);

/* Whether a rectangle has pixels and lies within +-QV_PIXEL_MAX. QV_OK, QV_ERROR_NULL, _RECT. */
qv_status qv_rect_check(const qv_rect *rect);

/* The pixel of a column and line of a rectangle, and what lies beside it. */
static inline uint8_t *qv_buffer_pixel(const qv_buffer *buffer, unsigned column, unsigned line)
{
    uint8_t *row = (uint8_t *)buffer->pixels + (ptrdiff_t)line * buffer->stride;
    return row + (size_t)column * buffer->blend->bytes;
}

static inline uint8_t *qv_buffer_beside(const qv_buffer *buffer, unsigned column, unsigned line)
{
    if (buffer->blend->beside == 0)
        return 0;
    uint8_t *row = (uint8_t *)buffer->beside + (ptrdiff_t)line * buffer->beside_stride;
    return row + (size_t)column * buffer->blend->beside;
}

/* What a pixel of a buffer shows. */
static inline void qv_buffer_read(qv_fragment *fragment, const qv_buffer *buffer, unsigned column,
                                  unsigned line)
{
    buffer->blend->read(fragment, qv_buffer_pixel(buffer, column, line),
                        qv_buffer_beside(buffer, column, line));
}

/* Blends a fragment into a pixel of a rectangle, in the slice's moment. */
void qv_buffer_blend(const qv_buffer *buffer, const qv_fragment *fragment, const qv_moment *slice,
                     const qv_dither *dither, const qv_rect *rect, int32_t x, int32_t y);

#endif /* QV_BUFFER_H */
