/*
 * gradient.h - gradients of scalar volumes: long enough or not, and their
 * normals. Knows differences of values, not where they come from.
 */
#ifndef QV_GRADIENT_H
#define QV_GRADIENT_H

#include <stdint.h>

/* Words of numbers up to 2^96 and below 2^160, the lowest first. */
#define QV_SQUARE_WORDS 4
#define QV_LEAST_WORDS  5

/*
 * What a gradient is measured by. With S the spacing in Q16.16, d[a] the
 * difference between the values after and before a voxel, L the least gradient
 * and W the window, the gradient is g[a] = d[a] * 2^15 / S[a] values per world
 * unit, hence along d[x] * S[y] * S[z], .... It is long enough where
 * |g| * 256 / W >= L; free of divisions and roots, that is
 *   sum of d[a]^2 * square[a] >= least
 *   square[x] = (S[y] * S[z])^2, ...   least = (L * W * S[x]*S[y]*S[z])^2 / 2^46
 * where least is rounded up, which changes nothing for whole numbers. Sums stay below
 * 3 * 2^(32 + 96); a least that none can reach may be any number above.
 */
typedef struct qv_gradient {
    uint64_t scale[3]; /* S[y]*S[z], ...: at most 2^48 */
    uint32_t square[3][QV_SQUARE_WORDS];
    uint32_t least[QV_LEAST_WORDS];
} qv_gradient;

/* Spacings of qv_spacing_check, 0 read as 1; 0 < window < 2^18. */
void qv_gradient_init(qv_gradient *gradient, const uint32_t spacing[3], uint16_t least,
                      uint32_t window);

/*
 * The normal of a gradient, against it, Q2.30; |difference| <= 65535. Returns 0,
 * and no normal, where the gradient is 0 or too short. The decision is exact.
 */
int qv_gradient_normal(int32_t normal[3], const qv_gradient *gradient, const int32_t difference[3]);

#endif /* QV_GRADIENT_H */
