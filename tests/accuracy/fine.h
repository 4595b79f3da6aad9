/*
 * fine.h - pixels as the renderer finishes them, before a display's format rounds them.
 */
#ifndef ACCURACY_FINE_H
#define ACCURACY_FINE_H

#include "pixels.h"

#include <string.h>

#define FINE_ONE (255.0 * 65536) /* a channel that is 1 */

typedef struct fine_pixel {
    uint32_t channel[4]; /* associated R, G, B and opacity */
} fine_pixel;

static inline void store_fine(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)line;
    memcpy(row + column * sizeof(fine_pixel), pixel->channel, sizeof(fine_pixel));
}

/* Renders the frame of a scene, row by row. */
static inline qv_status render_fine_frame(fine_pixel *pixels, const qv_scene *scene, uint16_t width,
                                          uint16_t height)
{
    static const qv_format format = {store_fine, 8 * sizeof(fine_pixel), 0};
    const qv_rect rect = {0, 0, width, height};
    const size_t row = width * sizeof *pixels;
    const qv_image image = {pixels, row * height, (ptrdiff_t)row, &format};
    qv_context context;
    const qv_status status = qv_init(&context, scene);
    return status == QV_OK ? qv_render(&image, &context, &rect) : status;
}

/* Renders pixel (0, 0) of a scene. */
static inline qv_status render_fine(fine_pixel *pixel, const qv_scene *scene)
{
    return render_fine_frame(pixel, scene, 1, 1);
}

#endif /* ACCURACY_FINE_H */
