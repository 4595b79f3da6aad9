/*
 * u8g2.c - a volume on a monochrome panel by u8g2's page loop: a page's byte is 8 rows of one
 * column, the topmost in the lowest bit, which is qv_format_mono_vertical.
 */
#include <u8g2.h>
#include "qvol.h"

qv_status qvol_u8g2_show(u8g2_t *u8g2, const qv_context *context)
{
    const int32_t width = 8 * u8g2_GetBufferTileWidth(u8g2);
    const int32_t tiles = u8g2_GetBufferTileHeight(u8g2);
    qv_status status = QV_OK;
    u8g2_FirstPage(u8g2);
    do {
        const int32_t top = 8 * u8g2_GetBufferCurrTileRow(u8g2);
        const qv_image image = {u8g2_GetBufferPtr(u8g2), (size_t)(width * tiles), width,
                                &qv_format_mono_vertical};
        const qv_rect page = {0, top, width, top + 8 * tiles};
        if (status == QV_OK)
            status = qv_render(&image, context, &page);
    } while (u8g2_NextPage(u8g2));
    return status;
}
