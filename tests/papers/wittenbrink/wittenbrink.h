/*
 * wittenbrink.h - Wittenbrink, Malzbender, Goss 1998, "Opacity-Weighted Color
 * Interpolation for Volume Sampling", recomputed with the library.
 *
 * Each part writes its pictures and curves to a folder and its numbers to a table.
 */
#ifndef PAPERS_WITTENBRINK_H
#define PAPERS_WITTENBRINK_H

#include "papers/paper.h"

/* Sections 2 to 4: three samples, the phase curve of figure 6, the general formulas. */
void border_rays(FILE *table, const char *folder);

/* Figures 7 and 10 to 12: the scenes corner, graze and phase. */
void border_scenes(FILE *table, const char *folder);

/* Figure 8: the torus. */
void torus(FILE *table, const char *folder);

/* RMS error of the two modes, in levels of 255, over the pixels of the volume. */
typedef struct comparison {
    double exact, ours; /* over the lattice of pixels that the reference renders */
    double frame;       /* ours, over all pixels */
} comparison;

/*
 * Renders a scene separately and weighted, writes FOLDER/NAME-separate.ppm, -weighted,
 * -difference and -equalised, and adds a row. `paper` is the paper's RMS error.
 */
comparison compare_modes(FILE *table, const char *folder, const char *name, const char *paper,
                         qv_scene *scene, uint16_t edge);

/* Section 7: colours weighted in 8 bits. */
void preweighted(FILE *table);

#endif /* PAPERS_WITTENBRINK_H */
