/*
 * buffer.h - checks of frame buffers, and where their pixels lie.
 */
#ifndef QV_BUFFER_H
#define QV_BUFFER_H

#include "blend.h"

/* What every function checks of a buffer and its rectangle. QV_OK, QV_ERROR_NULL, _RECT,
   _BUFFER. */
qv_status qv_buffer_check(const qv_buffer *buffer, const qv_rect *rect);

/* The pixel of a column and line of a rectangle, and what lies beside it. */
static inline uint8_t *qv_buffer_pixel(const qv_buffer *buffer, unsigned column, unsigned line)
{
    uint8_t *row = (uint8_t *)buffer->pixels + (ptrdiff_t)line * buffer->stride;
    return row + (size_t)column * QV_FIELD(buffer->blend, bytes);
}

static inline uint8_t *qv_buffer_beside(const qv_buffer *buffer, unsigned column, unsigned line)
{
    if (QV_FIELD(buffer->blend, beside) == 0)
        return 0;
    uint8_t *row = (uint8_t *)buffer->beside + (ptrdiff_t)line * buffer->beside_stride;
    return row + (size_t)column * QV_FIELD(buffer->blend, beside);
}

/* What a pixel of a buffer shows. */
static inline void qv_buffer_read(qv_fragment *fragment, const qv_buffer *buffer, unsigned column,
                                  unsigned line)
{
    const uint8_t *pixel = qv_buffer_pixel(buffer, column, line);
    const uint8_t *beside = qv_buffer_beside(buffer, column, line);
    QV_FIELD(buffer->blend, read)(fragment, pixel, beside);
}

/* ---- Rows ------------------------------------------------------------------- */

/* A pixel of a row that is blended. */
typedef struct qv_place {
    uint8_t *pixel, *beside; /* where nothing lies beside it, the pixel again */
    uint32_t u;              /* its dither value */
} qv_place;

/* The first of a rectangle's line. */
static inline qv_place qv_place_of(const qv_buffer *buffer, const qv_moment *slice,
                                   const qv_rect *rect, unsigned line)
{
    uint32_t shift = qv_dither_shift(slice->spread, rect->left, rect->top + (int32_t)line);
    qv_place place = {qv_buffer_pixel(buffer, 0, line), qv_buffer_beside(buffer, 0, line),
                      slice->slice_u + shift};
    if (QV_FIELD(buffer->blend, beside) == 0)
        place.beside = place.pixel;
    return place;
}

/* To the right, where dither values are more by a step. */
static inline void qv_place_next(qv_place *place, const qv_blend *blend, uint32_t step)
{
    place->pixel += QV_FIELD(blend, bytes);
    place->beside += QV_FIELD(blend, beside);
    place->u += step;
}

/* Blends a fragment into a pixel, to which the moment of the slice is shifted. */
static inline void qv_place_blend(const qv_place *place, const qv_blend *blend,
                                  const qv_fragment *fragment, qv_moment *moment)
{
    qv_moment_at(moment, place->u);
    if (moment->technique)
        qv_moment_opacity(moment, blend, place->pixel, fragment);
    QV_FIELD(blend, blend)(place->pixel, place->beside, fragment, moment);
}

#endif /* QV_BUFFER_H */
