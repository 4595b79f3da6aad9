/*
 * image.h - checks of where pixels go.
 */
#ifndef QV_IMAGE_H
#define QV_IMAGE_H

#include "qvol.h"

/* Everything that qv_render checks before it writes, but the context.
   QV_OK, QV_ERROR_NULL, _RECT, _BUFFER. */
qv_status qv_image_check(const qv_image *image, const qv_rect *rect);

/* The same of pixels of so many bits that no format describes. */
qv_status qv_plane_check(const void *pixels, size_t bytes, ptrdiff_t stride, unsigned bits,
                         const qv_rect *rect);

/* Whether a rectangle has pixels and lies within +-QV_PIXEL_MAX. QV_OK, QV_ERROR_NULL, _RECT. */
qv_status qv_rect_check(const qv_rect *rect);

#endif /* QV_IMAGE_H */
