#include "image.h"

uint32_t qv_row_bytes(const qv_format *format, uint16_t width)
{
    return ((uint32_t)width * format->bits + 7u) >> 3; /* 2^16 pixels of 96 bits: below 2^20 */
}

/* Whether rows of the rectangle fit into the image's memory, side by side. */
static qv_status check_buffer(const qv_image *image, uint16_t width, uint16_t height)
{
    uint32_t row = qv_row_bytes(image->format, width);
    size_t bytes = image->bytes;
    size_t stride = image->stride < 0 ? (size_t)0 - (size_t)image->stride : (size_t)image->stride;
    unsigned gaps = (height - 1u) >> image->format->line_shift; /* rows of bytes less one */
    if (bytes < row || (gaps != 0 && stride < row))
        return QV_ERROR_BUFFER;
    for (bytes -= (size_t)row; gaps != 0; gaps--) {
        if (bytes < stride)
            return QV_ERROR_BUFFER;
        bytes -= stride;
    }
    return QV_OK;
}

qv_status qv_image_check(const qv_image *image, const qv_progress *progress, const qv_rect *rect)
{
    if (!image || !progress || !rect || !image->pixels || !image->format)
        return QV_ERROR_NULL;
    if (rect->left < -QV_PIXEL_MAX || rect->left >= rect->right || rect->right > QV_PIXEL_MAX)
        return QV_ERROR_RECT;
    if (rect->top < -QV_PIXEL_MAX || rect->top >= rect->bottom || rect->bottom > QV_PIXEL_MAX)
        return QV_ERROR_RECT;
    uint16_t width = (uint16_t)(rect->right - rect->left); /* <= 2 QV_PIXEL_MAX < 2^16 */
    uint16_t height = (uint16_t)(rect->bottom - rect->top);
    if (progress->line > height || progress->column >= width)
        return QV_ERROR_RECT;
    return check_buffer(image, width, height);
}
