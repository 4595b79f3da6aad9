/*
 * transfer_text.h - transfer functions by name or from a text file.
 *
 * The text has one control point a line, `#` starts a comment:
 *
 *     index red green blue opacity
 *
 * with the index 0 .. 255 in rising order, colours 0 .. 255 and the opacity
 * 0 .. 1 for one sample step, as a decimal of any length (0.00005). Between
 * points all four are linear. A line
 *
 *     shading ambient diffuse specular exponent gradient
 *
 * sets what --shade does with the material: three coefficients 0 .. 1, the
 * highlight's exponent (1, 2, 4 .. 128), and the least gradient that is a
 * surface, as a share of the window per voxel.
 */
#ifndef QVOL_HOST_TRANSFER_TEXT_H
#define QVOL_HOST_TRANSFER_TEXT_H

#include "qvol.h"

struct transfer {
    const char *name;
    qv_control_point points[QV_PALETTE_ENTRIES];
    uint16_t count;
    qv_shading shading; /* coefficients; directions are 0 */
};

/* A preset of that name, or else the file. Errors end the command. */
void transfer_read(struct transfer *transfer, const char *name);

struct preset {
    const char *name;
    const char *summary;
    const char *text;
};

/* Ends with a null name. */
extern const struct preset presets[];

#endif
