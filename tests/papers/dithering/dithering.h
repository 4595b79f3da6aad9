/*
 * dithering.h - Williams, Frank and LaMar, "Alpha dithering to correct low-opacity 8 bit
 * compositing errors", recomputed with the library.
 *
 * Opacities and levels are 0 .. 255, as in the paper. Each part writes data of plots and
 * pictures to FOLDER/data, and its numbers to FOLDER/numbers.txt.
 */
#ifndef PAPERS_DITHERING_H
#define PAPERS_DITHERING_H

#include "fog.h"
#include "papers/paper.h"

/* ---- What the parts share ------------------------------------------------- */

/* Curves of a figure. Where a figure shows something else, its data say so. */
typedef enum curve {
    EXACT,
    PLAIN,   /* rounded, without dither */
    ORDERED, /* the paper's dithers of the opacity */
    RANDOM,
    OURS, /* dithered rounding in 8 bits, in blocks of 8 slices */
    WIDE, /* the same with more bits in the frame buffer */
    CURVES
} curve;

/* A set of curves. */
#define SHOWS(curve) (1u << (curve))

/* values[curve][n] and how far that is off, 0 <= n <= slices. */
typedef struct plot {
    const char *names[CURVES];
    unsigned shown;
    uint32_t slices;
    double values[CURVES][REF_FOG_SLICES_MAX + 1];
    double errors[CURVES][REF_FOG_SLICES_MAX + 1];
} plot;

/* The error of the largest amount, with its sign. */
double worst_of(const double *errors, uint32_t slices);

/* Writes a figure's curves to FOLDER/data, and a line about it to the index: name, kind of
   plot, title, caption. */
typedef struct figure_text {
    int number;
    const char *kind, *title, *caption;
} figure_text;

void write_plot(const char *folder, FILE *index, const figure_text *text, const plot *of);

/* A line of numbers.txt: a number of the paper beside the one computed. */
void numbers_add(FILE *numbers, const char *place, const char *what, const char *paper,
                 double computed);

/* ---- Parts ------------------------------------------------------------------ */

/* Section 5, figure 39: colour and opacity dithered apart. Goes on with the lines that
   numbers_add begins. */
void colour_figure(FILE *numbers, FILE *index, const char *folder);

/* Figures 5 to 56 but 39: one fog, or two bricks of it. */
void fog_figures(FILE *numbers, FILE *index, const char *folder);

/* Figures 40 and 41: opacities of the head by its histogram (equation 12). Goes on with the
   same lines. */
void histogram_figures(FILE *numbers, const char *folder);

/* Tables 1 and 3. */
void tables(const char *folder);

/* Section 9, and what else has a value in double precision: FOLDER/table.md. */
void techniques_of_section_9(const char *folder);

#endif /* PAPERS_DITHERING_H */
