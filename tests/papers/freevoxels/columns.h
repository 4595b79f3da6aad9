/*
 * columns.h - a pixel before columns of white voxels, of which it takes equal shares.
 */
#ifndef PAPERS_COLUMNS_H
#define PAPERS_COLUMNS_H

#include "papers/paper.h"

/*
 * The farthest that the library's picture of 1, 2, .. layers is from exact, in levels. The columns
 * are size[0] by size[2], and size[1] deep; the pixel has this pitch, and lies in their middle.
 */
double columns_off(const qv_splatting *splatting, double opacity, const uint16_t size[3],
                   double share);

#endif /* PAPERS_COLUMNS_H */
