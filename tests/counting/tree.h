/*
 * tree.h - the binary-tree forms of trilinear interpolation, for their operation
 * counts and as a second way to the same numbers. Source: Wittenbrink,
 * Malzbender, Goss 1998, section 6.
 *
 * Exact: a channel of 8 bits gains 8 fraction bits in each of the three levels,
 * an associated colour starts with 16.
 */
#ifndef TREE_H
#define TREE_H

#include <stdint.h>

#include "fx_weight.h"

/* Structures, so that nothing is computed past the counted operations. */
typedef struct {
    int64_t bits;
} tree_number;

/* Separate: four trees of seven interpolations, 28M 56A. Unit: 255 * 2^24. */
void tree_separate(tree_number result[4], uint8_t rgba[8][4], const uint8_t fraction[3]);

/* Opacity-weighted: 24 products before the trees, 52M 56A. Unit of the colours:
   255 * 255 * 2^24, of the opacity: 255 * 2^24. */
void tree_weighted(tree_number result[4], uint8_t rgba[8][4], const uint8_t fraction[3]);

#endif /* TREE_H */
