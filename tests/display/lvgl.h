/*
 * lvgl.h - what port/display/lvgl.c needs of LVGL 9, with its names and types.
 */
#ifndef LVGL_H
#define LVGL_H

#include <stdint.h>

typedef enum { LV_COLOR_FORMAT_XRGB8888 = 0x11, LV_COLOR_FORMAT_RGB565 = 0x12 } lv_color_format_t;

typedef struct {
    uint32_t magic : 8;
    uint32_t cf : 8;
    uint32_t flags : 16;
    uint32_t w : 16;
    uint32_t h : 16;
    uint32_t stride : 16;
    uint32_t reserved_2 : 16;
} lv_image_header_t;

typedef struct {
    lv_image_header_t header;
    uint32_t data_size;
    uint8_t *data;
    void *unaligned_data;
} lv_draw_buf_t;

typedef struct {
    int32_t x1, y1, x2, y2;
} lv_area_t;

#endif /* LVGL_H */
