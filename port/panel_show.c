/*
 * panel_show.c - strip after strip into the same few rows of RAM.
 */
#include PANEL_HEADER
#include "panel_show.h"
#include "crc32.h"
#include "measure.h"

enum { STRIP_ROWS = 8 };

static uint8_t strip[STRIP_ROWS][PANEL_ROW_BYTES];

qv_status panel_show(uint32_t *checksum, const qv_context *context)
{
    const qv_image image = {strip, sizeof strip, sizeof strip[0], &PANEL_FORMAT};
    *checksum = 0;
    for (int32_t top = 0; top < PANEL_HEIGHT; top += STRIP_ROWS) {
        const qv_rect rows = {0, top, PANEL_WIDTH, top + STRIP_ROWS};
        measure_begin();
        qv_status status = qv_render(&image, context, &rows);
        measure_end();
        if (status != QV_OK)
            return status;
        panel_rows((uint32_t)top, strip[0], STRIP_ROWS);
        *checksum = crc32_update(*checksum, strip, sizeof strip);
    }
    return QV_OK;
}
