/*
 * hash_inverse.h - fx_hash backwards: that there is a way back proves it a bijection.
 */
#ifndef QV_HASH_INVERSE_H
#define QV_HASH_INVERSE_H

#include <stdint.h>

/* The factors are the inverses of the hash's own modulo 2^32. v ^ v >> 15 is undone by
   v ^ v >> 15 ^ v >> 30, and v ^ v >> 16 by itself. */
static inline uint32_t hash_inverse(uint32_t v)
{
    v ^= v >> 16;
    v *= 0x43021123u;
    v ^= (v >> 15) ^ (v >> 30);
    v *= 0x1D69E2A5u;
    return v ^ (v >> 16);
}

#endif /* QV_HASH_INVERSE_H */
