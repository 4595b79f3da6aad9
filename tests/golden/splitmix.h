/*
 * splitmix.h - the seeded numbers of the golden scenes.
 */
#ifndef GOLDEN_SPLITMIX_H
#define GOLDEN_SPLITMIX_H

#include <stdint.h>

/* 16 random bits: SplitMix (Steele, Lea and Flood 2014) with the 32-bit finaliser
   of MurmurHash3. Any state will do, neighbouring ones too. */
static inline uint16_t random16(uint32_t *state)
{
    uint32_t z = *state += 0x9E3779B9u; /* 2^32 by the golden ratio */
    z = (z ^ (z >> 16)) * 0x85EBCA6Bu;
    z = (z ^ (z >> 13)) * 0xC2B2AE35u;
    return (uint16_t)(z >> 16);
}

/* A number from 0 up to, but not including, the bound; 1 <= bound <= 65536. */
static inline uint32_t random_below(uint32_t *state, uint32_t bound)
{
    return random16(state) * bound >> 16;
}

#endif /* GOLDEN_SPLITMIX_H */
