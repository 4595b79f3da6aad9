/*
 * freevoxels.h - "FreeVoxels: attenuation stored per voxel", recomputed with the library.
 *
 * Each part writes its pictures and curves to a folder and its numbers to a table. Depths are
 * in base 2, errors in levels of 8 bits.
 */
#ifndef PAPERS_FREEVOXELS_H
#define PAPERS_FREEVOXELS_H

#include "attenuated.h"

/* A table of what comes out in two ways. */
void pairs_begin(FILE *table, const char *title, const char *left, const char *right);
void pairs_add(FILE *table, const char *what, double left, double right);

/* Sections 2.1 and 3.1, figure 2: attenuation of a uniform cube along three directions. */
void uniform_cube(FILE *table, const char *folder);

/* Section 4.1, figure 6: the leak of splats that are blended. */
void leak(FILE *table, const char *folder);

/* Section 3.1: what a byte costs. */
void store(FILE *table);

/* Section 3.2: the mean of eight voxels. */
void means(FILE *table);

/* Section 3.1: light from between 26 directions. */
void directions(FILE *table);

/* The head from between the directions. */
void between(const char *folder);

/* Section 3.3: the viewer in the volume. */
void inside(FILE *table, const char *folder);

/* Section 3.2: levels, of the geometric mean and built anew. */
void hierarchy(FILE *table, const char *folder);

/* Section 4.3, figure 7: a head in red light. */
void lit_head(FILE *table, const char *folder);

/* Section 4.4, figure 8: work of many nodes. */
void nodes(FILE *table, const char *folder);

#endif /* PAPERS_FREEVOXELS_H */
