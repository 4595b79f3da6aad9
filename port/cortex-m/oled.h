/*
 * oled.h - the 128x64 OLED panel of the Stellaris LM3S6965 evaluation kit:
 * an SSD0323 controller with 16 greys on the synchronous serial port SSI0. Two pixels a byte, the
 * left one in the high four bits.
 */
#ifndef OLED_H
#define OLED_H

#include "panel.h"

enum { PANEL_WIDTH = 128, PANEL_HEIGHT = 64, PANEL_ROW_BYTES = PANEL_WIDTH / 2 };

#define PANEL_FORMAT qv_format_grey4

#endif /* OLED_H */
