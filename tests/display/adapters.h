/*
 * adapters.h - the adapters of port/display/, whose sources are examples without headers.
 */
#ifndef ADAPTERS_H
#define ADAPTERS_H

#include "qvol.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { WIDTH = 40, HEIGHT = 24 };

/* Adafruit GFX draws into a panel of WIDTH x HEIGHT pixels, by strips of so many rows. */
qv_status show_by_gfx(uint16_t *panel, const qv_context *context, uint16_t *strip, int16_t rows);

#ifdef __cplusplus
}
#endif

#endif /* ADAPTERS_H */
