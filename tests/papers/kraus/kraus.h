/*
 * kraus.h - Kraus and Buerger 2008, "Interpolating and Downsampling RGBA Volume Data",
 * recomputed with the library.
 *
 * Each part writes its pictures and curves to a folder and its numbers to a table. tau
 * is the paper's extinction, in base e.
 */
#ifndef PAPERS_KRAUS_H
#define PAPERS_KRAUS_H

#include "papers/paper.h"

/* Section 3: opacity correction, and opacity of extinction. */
void equations(FILE *table);

/* Figures 2 and 3: eight voxels become one. */
void eight_voxels(FILE *table);

/* Figure 4 and section 3.5: a ray through one vertex. */
void one_vertex(FILE *table, const char *folder);

/* Figures 5 and 6: a wall of one voxel. */
void thin_wall(FILE *table, const char *folder);

/* Figure 7: scattered opaque voxels. */
void scattered_voxels(FILE *table, const char *folder);

/* Section 4.2: how far the filters are from a convolution. */
void filters(FILE *table, const char *folder);

/* Section 4: pyramids of a thin shell and of a head. */
void pyramids(FILE *table, const char *folder);

#endif /* PAPERS_KRAUS_H */
