/*
 * zephyr.c - a volume on any Zephyr display in PIXEL_FORMAT_RGB_565, strip by strip. (Displays
 * that take the high byte first want qv_format_rgb565_be.)
 */
#include <zephyr/drivers/display.h>
#include "qvol.h"

/* Renders and writes `height` rows of `width` pixels through a strip of whole rows. */
int qvol_zephyr_show(const struct device *display, const qv_context *context, void *strip,
                     size_t strip_bytes, uint16_t width, uint16_t height)
{
    const qv_image image = {strip, strip_bytes, 2 * (ptrdiff_t)width, &qv_format_rgb565_le};
    const uint16_t rows = (uint16_t)(strip_bytes / (2u * width));
    int error = rows == 0 ? -1 : 0;
    for (uint16_t top = 0; top < height && error == 0; top = (uint16_t)(top + rows)) {
        const uint16_t most = (uint16_t)(height - top);
        struct display_buffer_descriptor part = {.width = width, .pitch = width};
        part.height = rows < most ? rows : most;
        part.buf_size = 2u * width * part.height;
        const qv_rect rect = {0, top, width, top + part.height};
        error = qv_render(&image, context, &rect);
        if (error == 0)
            error = display_write(display, 0, top, &part, strip);
    }
    return error;
}
