/*
 * classify_reference.h - transfer functions, classification and reduction in
 * real numbers, from the declarations of qvol.h alone.
 */
#ifndef CLASSIFY_REFERENCE_H
#define CLASSIFY_REFERENCE_H

#include "qvol.h"

/* To the nearest integer, ties upwards. */
double ref_nearest(double v);

/* An entry of the table between control points, 0 .. 65535, not rounded. */
void ref_transfer_entry(double rgba[4], const qv_control_point *points, uint16_t count,
                        unsigned index);

/* The value at (x, y, z), or the nearest one inside the volume. */
double ref_scalar(const qv_scalars *scalars, int x, int y, int z);

/* The table index of a value. */
int ref_table_index(double s, const qv_classifier *classifier);

/* Shades a colour of 0 .. 65535; gradient in values per world unit. */
void ref_shade(double rgba[4], const double gradient[3], const qv_shading *shading, double window);

/* The gradient at a voxel in values per world unit. */
void ref_gradient(double gradient[3], const qv_scalars *scalars, int x, int y, int z);

/* The colour of a voxel, 0 .. 65535: looked up, and shaded where asked for. */
void ref_classify(double rgba[4], const qv_classifier *classifier, int x, int y, int z);

/* The mean that a voxel of the reduced volume stands for, not rounded. */
double ref_mean(const qv_scalars *scalars, const uint8_t factor[3], int x, int y, int z);

#endif /* CLASSIFY_REFERENCE_H */
