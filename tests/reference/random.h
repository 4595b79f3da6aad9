/*
 * random.h - a small generator, so that a seed names the same scene everywhere.
 */
#ifndef REFERENCE_RANDOM_H
#define REFERENCE_RANDOM_H

#include <stdbool.h>
#include <stdint.h>

typedef struct ref_random {
    uint64_t state;
} ref_random;

ref_random ref_random_seeded(uint32_t seed);

uint32_t ref_random_next(ref_random *random);

/* An integer of 0 .. limit - 1. */
uint32_t ref_random_below(ref_random *random, uint32_t limit);

/* True in one of n draws. */
bool ref_random_once_in(ref_random *random, uint32_t n);

/* A real number of low .. high, spread evenly, or evenly in its logarithm. */
double ref_random_real(ref_random *random, double low, double high);
double ref_random_scale(ref_random *random, double low, double high);

#endif /* REFERENCE_RANDOM_H */
