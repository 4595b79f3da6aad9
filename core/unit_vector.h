/*
 * unit_vector.h - unit vectors in Q2.30 for shading.
 */
#ifndef QV_UNIT_VECTOR_H
#define QV_UNIT_VECTOR_H

#include <stdint.h>

/*
 * The unit vector along (v[a] * scale[a]), which must not be 0 on all axes;
 * |v[a]| * scale[a] < 2^64. Every component is within 2^-27 of the exact one and
 * at most 1.
 */
void qv_unit_vector(int32_t unit[3], const int32_t v[3], const uint64_t scale[3]);

/* The scalar product of two unit vectors in Q2.30, clamped to 0 .. 1. */
uint32_t qv_unit_cosine(const int32_t a[3], const int32_t b[3]);

#endif /* QV_UNIT_VECTOR_H */
