/*
 * panel_show.h - a scene on the board's panel, in strips: the picture never exists as a whole in
 * RAM.
 */
#ifndef PANEL_SHOW_H
#define PANEL_SHOW_H

#include "qvol.h"

/* Renders a scene of PANEL_WIDTH x PANEL_HEIGHT pixels. Each strip goes to the panel and into the
   checksum, a CRC-32; the time of rendering alone is measured. After an error the rows above
   stand, and the checksum is of these. */
qv_status panel_show(uint32_t *checksum, const qv_context *context);

#endif /* PANEL_SHOW_H */
