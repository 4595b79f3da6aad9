#include "image.h"

#include "fx_inline.h"

/* What follows dissolves into the check of images, the only one that rays link. */

FX_INLINE uint32_t row_bytes(uint16_t width, unsigned bits)
{
    return ((uint32_t)width * bits + 7u) >> 3; /* 2^16 pixels of 128 bits: below 2^21 */
}

uint32_t qv_row_bytes(const qv_format *format, uint16_t width)
{
    return row_bytes(width, QV_FIELD(format, bits));
}

/* Whether rows of bytes fit into their memory, side by side: one, and so many below it. */
FX_INLINE qv_status check_rows(size_t bytes, ptrdiff_t row_stride, uint32_t row, unsigned gaps)
{
    size_t stride = row_stride < 0 ? (size_t)0 - (size_t)row_stride : (size_t)row_stride;
    if (bytes < row || (gaps != 0 && stride < row))
        return QV_ERROR_BUFFER;
    for (bytes -= (size_t)row; gaps != 0; gaps--) {
        if (bytes < stride)
            return QV_ERROR_BUFFER;
        bytes -= stride;
    }
    return QV_OK;
}

FX_INLINE uint16_t width_of(const qv_rect *rect)
{
    return (uint16_t)(rect->right - rect->left); /* <= 2 QV_PIXEL_MAX < 2^16 */
}

FX_INLINE uint16_t height_of(const qv_rect *rect)
{
    return (uint16_t)(rect->bottom - rect->top);
}

FX_INLINE int in_range(const qv_rect *rect)
{
    return rect->left >= -QV_PIXEL_MAX && rect->left < rect->right && rect->right <= QV_PIXEL_MAX &&
           rect->top >= -QV_PIXEL_MAX && rect->top < rect->bottom && rect->bottom <= QV_PIXEL_MAX;
}

qv_status qv_rect_check(const qv_rect *rect)
{
    if (!rect)
        return QV_ERROR_NULL;
    return in_range(rect) ? QV_OK : QV_ERROR_RECT;
}

qv_status qv_plane_check(const void *pixels, size_t bytes, ptrdiff_t stride, unsigned bits,
                         const qv_rect *rect)
{
    qv_status status = pixels ? qv_rect_check(rect) : QV_ERROR_NULL;
    if (status != QV_OK)
        return status;
    return check_rows(bytes, stride, row_bytes(width_of(rect), bits), height_of(rect) - 1u);
}

qv_status qv_image_check(const qv_image *image, const qv_rect *rect)
{
    if (!image || !rect || !image->pixels || !image->format)
        return QV_ERROR_NULL;
    if (!in_range(rect))
        return QV_ERROR_RECT;
    unsigned gaps = (height_of(rect) - 1u) >> QV_FIELD(image->format, line_shift);
    uint32_t row = qv_row_bytes(image->format, width_of(rect));
    return check_rows(image->bytes, image->stride, row, gaps);
}
