/*
 * bochs_display.h - a colour panel of 320x240 pixels on the emulated board virt: QEMU's Bochs
 * display in PCI slot 1. Four bytes a pixel: B, G, R and one that nobody looks at.
 */
#ifndef BOCHS_DISPLAY_H
#define BOCHS_DISPLAY_H

#include "panel.h"

enum { PANEL_WIDTH = 320, PANEL_HEIGHT = 240, PANEL_ROW_BYTES = PANEL_WIDTH * 4 };

#define PANEL_FORMAT qv_format_bgra8888

#endif /* BOCHS_DISPLAY_H */
