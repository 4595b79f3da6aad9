/*
 * search.h - the worst error of a stage whose inputs are too many to try them all.
 *
 * Random inputs first, for the RMS, more of stages of one number: half of them uniform, half of
 * random magnitude. From the worst of them hill climbing: each number moves by powers of 2, to its
 * ends and to random places as long as the error grows. Always the same inputs.
 */
#ifndef SEARCH_H
#define SEARCH_H

#include "stages.h"

#define SEARCH_NUMBERS 24

#define NO_SUCH_INPUT ((double)NAN)

/* The error for an input, or NO_SUCH_INPUT. */
typedef double search_error(const uint64_t input[], unsigned parameter);

/* Writes the input of the worst error, as measured_input does. */
typedef void search_tell(measured *m, const uint64_t input[], unsigned parameter);

typedef struct search {
    search_error *error;
    search_tell *tell;
    unsigned numbers;
    uint64_t most[SEARCH_NUMBERS]; /* each is 0 .. most */
} search;

void search_worst(measured *m, const search *s, unsigned parameter);

/* SplitMix64 (Steele, Lea and Flood 2014). */
uint64_t random64(uint64_t *state);

#endif /* SEARCH_H */
