/*
 * oled.h - the 128x64 OLED panel of the Stellaris LM3S6965 evaluation kit:
 * an SSD0323 controller with 16 greys on the synchronous serial port SSI0.
 */
#ifndef OLED_H
#define OLED_H

#include <stdint.h>

enum { OLED_WIDTH = 128, OLED_HEIGHT = 64, OLED_ROW_BYTES = OLED_WIDTH / 2 };

void oled_start(void);

/* Sends whole rows from `top` down, two pixels a byte, the left one in the high
   four bits (qv_format_grey4). */
void oled_rows(uint32_t top, const uint8_t *pixels, uint32_t rows);

#endif /* OLED_H */
