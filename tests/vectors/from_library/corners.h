/*
 * corners.h - the eight entries of a cell, which most samples have as inputs.
 */
#ifndef VECTORS_CORNERS_H
#define VECTORS_CORNERS_H

#include "sample.h"
#include "vector.h"

/* The entries of a cell's corners in the machine's memory. */
typedef struct corners {
    uint8_t narrow[8][4];
    uint16_t wide[8][4];
    qv_address at[8];
} corners;

void set_corners(corners *to, uint64_t channel[4][8], unsigned storage);

/* The weights of a place. */
void set_weights(uint64_t w[8], const uint64_t f[3]);

/* Random corners of four kinds: any, with many numbers next to limits, few with opacity, and
   opaque ones. */
void draw_corners(uint64_t f[3], uint64_t channel[4][8], vector_random *random, unsigned bits);

/* Corners that are alike but for one, at the places of the weights' extremes. */
typedef void add_corners(vector_set *set, const uint64_t f[3], uint64_t channel[4][8]);
void corner_edges(vector_set *set, unsigned bits, add_corners *add);

/* One corner with opacity among those that have none, each in turn. */
void lone_corners(vector_set *set, unsigned bits, add_corners *add);

#define FRACTIONS                                                                                  \
    {                                                                                              \
        "f", 3, 'i', "u8.8", "place between the voxel centres of axis [i]"                         \
    }
#define CORNER_WEIGHTS                                                                             \
    {                                                                                              \
        "w", 8, 'm', "u17.16", "weight of corner [i], as in the stage weights"                     \
    }

#define ENTRIES(format)                                                                            \
    {"r", 8, 'i', format, "red of corner [i]"}, {"g", 8, 'i', format, "green of corner [i]"},      \
        {"b", 8, 'i', format, "blue of corner [i]"},                                               \
    {                                                                                              \
        "a", 8, 'i', format, "opacity of corner [i], or extinction"                                \
    }

#endif
