#include "adapters.h"
#include <Adafruit_GFX.h>

qv_status qvol_gfx_show(Adafruit_GFX &display, const qv_context *context, uint16_t *strip,
                        int16_t rows);

qv_status show_by_gfx(uint16_t *panel, const qv_context *context, uint16_t *strip, int16_t rows)
{
    Adafruit_GFX display(panel, WIDTH, HEIGHT);
    return qvol_gfx_show(display, context, strip, rows);
}
