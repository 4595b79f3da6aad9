/*
 * panel.h - the display of a board. The board's own header, which the compiler is told as
 * PANEL_HEADER, includes this one and tells PANEL_WIDTH, PANEL_HEIGHT, PANEL_ROW_BYTES and
 * PANEL_FORMAT, the bytes that the panel takes.
 */
#ifndef PANEL_H
#define PANEL_H

#include <stdint.h>

void panel_start(void);

/* Shows whole rows from `top` down. */
void panel_rows(uint32_t top, const uint8_t *pixels, uint32_t rows);

#endif /* PANEL_H */
