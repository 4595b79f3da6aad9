/*
 * draw.h - random draws, so that a seed names the same scene everywhere.
 */
#ifndef REFERENCE_DRAW_H
#define REFERENCE_DRAW_H

#include <stdbool.h>
#include <stdint.h>

typedef struct draws {
    uint64_t state;
} draws;

draws draw_seeded(uint32_t seed);

uint32_t draw_bits(draws *from);

/* An integer of 0 .. limit - 1. */
uint32_t draw_below(draws *from, uint32_t limit);

/* True in one of n draws. */
bool draw_once_in(draws *from, uint32_t n);

/* A real number of low .. high, spread evenly, or evenly in its logarithm. */
double draw_real(draws *from, double low, double high);
double draw_scale(draws *from, double low, double high);

#endif /* REFERENCE_DRAW_H */
