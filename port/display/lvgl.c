/*
 * lvgl.c - a volume as a widget of LVGL 9: its canvas is rendered into the draw buffer (RGB565 or
 * XRGB8888), and a display without widgets has its partial buffers rendered by the flush callback.
 */
#include <lvgl.h>
#include "qvol.h"

/* Fills a draw buffer, for instance a canvas'; lv_obj_invalidate() then shows it. */
qv_status qvol_lvgl_draw(lv_draw_buf_t *buffer, const qv_context *context)
{
    const qv_format *format =
        buffer->header.cf == LV_COLOR_FORMAT_RGB565 ? &qv_format_rgb565_le : &qv_format_bgra8888;
    const qv_image image = {buffer->data, buffer->data_size, buffer->header.stride, format};
    const qv_rect rect = {0, 0, buffer->header.w, buffer->header.h};
    return qv_render(&image, context, &rect);
}

/* Renders what LVGL is about to send: an area whose corners are inside, in RGB565. */
qv_status qvol_lvgl_area(uint8_t *pixels, const lv_area_t *area, const qv_context *context)
{
    const qv_rect rect = {area->x1, area->y1, area->x2 + 1, area->y2 + 1};
    const int32_t stride = 2 * (rect.right - rect.left);
    const size_t bytes = (size_t)stride * (size_t)(rect.bottom - rect.top);
    const qv_image image = {pixels, bytes, stride, &qv_format_rgb565_le};
    return qv_render(&image, context, &rect);
}
