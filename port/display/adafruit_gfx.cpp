/*
 * adafruit_gfx.cpp - a volume on any display of Adafruit GFX, TFT_eSPI and the like: rectangles
 * of 16-bit colours, in the byte order of the machine.
 */
#include <Adafruit_GFX.h>
#include "qvol.h"

/* Renders and draws the display's rows through a strip of whole rows. */
qv_status qvol_gfx_show(Adafruit_GFX &display, const qv_context *context, uint16_t *strip,
                        int16_t rows)
{
    const int16_t width = display.width(), height = display.height();
    const qv_image image = {strip, sizeof *strip * static_cast<size_t>(width * rows),
                            static_cast<ptrdiff_t>(sizeof *strip) * width, &qv_format_rgb565_le};
    for (int16_t top = 0; top < height; top += rows) {
        const int16_t part = rows < height - top ? rows : static_cast<int16_t>(height - top);
        const qv_rect rect = {0, top, width, top + part};
        const qv_status status = qv_render(&image, context, &rect);
        if (status != QV_OK)
            return status;
        display.drawRGBBitmap(0, top, strip, width, part);
    }
    return QV_OK;
}
