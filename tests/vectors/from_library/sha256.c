/*
 * sha256.c - FIPS 180-4, sections 5 and 6.2. The constants are fraction bits of the roots of
 * primes.
 */
#include "sha256.h"

#include <stdint.h>
#include <string.h>

enum { BLOCK = 64, LENGTH_AT = 56, ROUNDS = 64, WORDS = 8 };

static const uint32_t start[WORDS] = {0x6A09E667, 0xBB67AE85, 0x3C6EF372, 0xA54FF53A,
                                      0x510E527F, 0x9B05688C, 0x1F83D9AB, 0x5BE0CD19};

static const uint32_t constant[ROUNDS] = {
    0x428A2F98, 0x71374491, 0xB5C0FBCF, 0xE9B5DBA5, 0x3956C25B, 0x59F111F1, 0x923F82A4, 0xAB1C5ED5,
    0xD807AA98, 0x12835B01, 0x243185BE, 0x550C7DC3, 0x72BE5D74, 0x80DEB1FE, 0x9BDC06A7, 0xC19BF174,
    0xE49B69C1, 0xEFBE4786, 0x0FC19DC6, 0x240CA1CC, 0x2DE92C6F, 0x4A7484AA, 0x5CB0A9DC, 0x76F988DA,
    0x983E5152, 0xA831C66D, 0xB00327C8, 0xBF597FC7, 0xC6E00BF3, 0xD5A79147, 0x06CA6351, 0x14292967,
    0x27B70A85, 0x2E1B2138, 0x4D2C6DFC, 0x53380D13, 0x650A7354, 0x766A0ABB, 0x81C2C92E, 0x92722C85,
    0xA2BFE8A1, 0xA81A664B, 0xC24B8B70, 0xC76C51A3, 0xD192E819, 0xD6990624, 0xF40E3585, 0x106AA070,
    0x19A4C116, 0x1E376C08, 0x2748774C, 0x34B0BCB5, 0x391C0CB3, 0x4ED8AA4A, 0x5B9CCA4F, 0x682E6FF3,
    0x748F82EE, 0x78A5636F, 0x84C87814, 0x8CC70208, 0x90BEFFFA, 0xA4506CEB, 0xBEF9A3F7, 0xC67178F2};

static uint32_t turned(uint32_t v, unsigned n)
{
    return v >> n | v << (32u - n);
}

static void schedule(uint32_t w[ROUNDS], const uint8_t block[BLOCK])
{
    for (unsigned t = 0; t < 16; t++)
        w[t] = (uint32_t)block[4 * t] << 24 | (uint32_t)block[4 * t + 1] << 16 |
               (uint32_t)block[4 * t + 2] << 8 | block[4 * t + 3];
    for (unsigned t = 16; t < ROUNDS; t++) {
        uint32_t a = w[t - 15], b = w[t - 2];
        w[t] = w[t - 16] + w[t - 7] + (turned(a, 7) ^ turned(a, 18) ^ a >> 3) +
               (turned(b, 17) ^ turned(b, 19) ^ b >> 10);
    }
}

static void hash_block(uint32_t hash[WORDS], const uint8_t block[BLOCK])
{
    uint32_t w[ROUNDS], v[WORDS];
    schedule(w, block);
    memcpy(v, hash, sizeof v);
    for (unsigned t = 0; t < ROUNDS; t++) {
        uint32_t a = v[0], e = v[4];
        uint32_t choice = (e & v[5]) ^ (~e & v[6]);
        uint32_t majority = (a & v[1]) ^ (a & v[2]) ^ (v[1] & v[2]);
        uint32_t one =
            v[7] + (turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)) + choice + constant[t] + w[t];
        uint32_t two = (turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)) + majority;
        memmove(v + 1, v, (WORDS - 1) * sizeof v[0]);
        v[4] += one;
        v[0] = one + two;
    }
    for (unsigned i = 0; i < WORDS; i++)
        hash[i] += v[i];
}

/* The last bytes, a 1, zeros, and the length in bits. */
static void hash_end(uint32_t hash[WORDS], uint8_t block[BLOCK], size_t used, uint64_t bytes)
{
    block[used++] = 0x80;
    memset(block + used, 0, BLOCK - used);
    if (used > LENGTH_AT) {
        hash_block(hash, block);
        memset(block, 0, BLOCK);
    }
    for (unsigned i = 0; i < 8; i++)
        block[LENGTH_AT + i] = (uint8_t)(bytes * 8 >> (56 - 8 * i));
    hash_block(hash, block);
}

void sha256_of_stream(char text[SHA256_TEXT], FILE *stream)
{
    uint32_t hash[WORDS];
    uint8_t block[BLOCK];
    uint64_t bytes = 0;
    size_t used;
    memcpy(hash, start, sizeof hash);
    while ((used = fread(block, 1, BLOCK, stream)) == BLOCK) {
        hash_block(hash, block);
        bytes += BLOCK;
    }
    hash_end(hash, block, used, bytes + used);
    for (unsigned i = 0; i < WORDS; i++)
        snprintf(text + 8 * i, 9, "%08lx", (unsigned long)hash[i]);
}
