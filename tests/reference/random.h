/*
 * random.h - reproducible numbers for tests: xorshift32 (Marsaglia 2003).
 */
#ifndef QV_RANDOM_H
#define QV_RANDOM_H

#include <stdint.h>

/* The next number; *state is never 0. */
static inline uint32_t random_next(uint32_t *state)
{
    uint32_t v = *state;
    v ^= v << 13;
    v ^= v >> 17;
    v ^= v << 5;
    return *state = v;
}

/* 0 .. count - 1 */
static inline uint32_t random_below(uint32_t *state, uint32_t count)
{
    return random_next(state) % count;
}

#endif /* QV_RANDOM_H */
