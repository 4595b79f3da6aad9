/*
 * scalar_view.h - a scan as the library's scalars.
 *
 * 8- and 16-bit values stay where they are and are turned to the world's axes
 * by strides. Signed 8-bit values are widened. Others, and values that the file
 * scales, become 16 bits over the window:
 *
 *     round(65535 * (value - low) / (high - low)), clamped; not a number is 0
 */
#ifndef QVOL_HOST_SCALAR_VIEW_H
#define QVOL_HOST_SCALAR_VIEW_H

#include "settings.h"

struct scalar_view {
    qv_scalars scalars;
    int32_t low, high; /* the window, in the scalars' values */
    double window[2];  /* the same in the file's values */
    bool converted;    /* to 16 bits over the window */
    double world_unit;
};

/* Takes over the scan's values, or replaces them. */
void scalar_view_create(struct scalar_view *view, struct scan *scan,
                        const struct settings *settings);

#endif
