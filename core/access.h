/*
 * access.h - how voxels, palettes and scalars are read.
 *
 * Every such access goes through these functions and qv_at; a port maps them to
 * its program memory (see QV_MEMORY_HEADER in qvol.h) and no kernel changes.
 */
#ifndef QV_ACCESS_H
#define QV_ACCESS_H

#include "qvol.h"

#ifndef QV_MEMORY_HEADER

static inline qv_address qv_at(qv_address base, qv_offset offset)
{
    return base + offset;
}

static inline uint8_t qv_read8(qv_address address)
{
    return *address;
}

/* The caller's memory may have been written as bytes: 16-bit reads may alias them. */
#if defined(__GNUC__)
typedef uint16_t __attribute__((may_alias)) qv_word;
#else
typedef uint16_t qv_word;
#endif

/* A uint16_t in the machine's byte order, at an even address. */
static inline uint16_t qv_read16(qv_address address)
{
    const void *aligned = address;
    return *(const qv_word *)aligned;
}

#if defined(__GNUC__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
typedef uint32_t __attribute__((may_alias)) qv_long_word;

/* Four bytes, the first in the lowest bits, at an address that is a multiple of 4. */
static inline uint32_t qv_read32(qv_address address)
{
    const void *aligned = address;
    return *(const qv_long_word *)aligned;
}
#else
static inline uint32_t qv_read32(qv_address address)
{
    return (uint32_t)address[3] << 24 | (uint32_t)address[2] << 16 | (uint32_t)address[1] << 8 |
           address[0];
}
#endif

/* Whether an address is a multiple of the alignment, 1, 2 or 4. */
static inline int qv_aligned(qv_address address, unsigned alignment)
{
    return ((uintptr_t)address & (alignment - 1u)) == 0;
}

/* From memory that is written to an address that is read, modulo the address space. Returns 0,
   and leaves the distance, where the two are memories of their own. */
static inline int qv_distance(uintptr_t *distance, const void *written, qv_address read)
{
    *distance = (uintptr_t)read - (uintptr_t)written;
    return 1;
}

#endif

/*
 * The only functions of the C library that may be called. They are declared here
 * since a freestanding compiler brings no <string.h>.
 */
void *memcpy(void *restrict to, const void *restrict from, size_t count);
void *memset(void *to, int value, size_t count);

#endif /* QV_ACCESS_H */
