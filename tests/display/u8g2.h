/*
 * u8g2.h - what port/display/u8g2.c needs of u8g2, with its names and types.
 */
#ifndef U8G2_H
#define U8G2_H

#include <stdint.h>

typedef struct u8g2_struct {
    uint8_t *tile_buf_ptr;
    uint8_t tile_buf_height, tile_curr_row;
    uint8_t tile_width, tile_height; /* of the panel */
    uint8_t *panel;
} u8g2_t;

#define u8g2_GetBufferPtr(u8g2)         ((u8g2)->tile_buf_ptr)
#define u8g2_GetBufferTileWidth(u8g2)   ((u8g2)->tile_width)
#define u8g2_GetBufferTileHeight(u8g2)  ((u8g2)->tile_buf_height)
#define u8g2_GetBufferCurrTileRow(u8g2) ((u8g2)->tile_curr_row)

void u8g2_FirstPage(u8g2_t *u8g2);
uint8_t u8g2_NextPage(u8g2_t *u8g2);

#endif /* U8G2_H */
