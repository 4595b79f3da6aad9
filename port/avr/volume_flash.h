/*
 * volume_flash.h - voxels, palettes and scalars in program memory, anywhere in its 128 KB:
 * pointers reach the lower half alone, so addresses are numbers (QV_MEMORY_HEADER).
 */
#ifndef VOLUME_FLASH_H
#define VOLUME_FLASH_H

#include "descriptor_flash.h"

#include <avr/pgmspace.h>

typedef uint_farptr_t qv_address; /* a byte of the flash; 0, the reset vector, is none */
typedef int32_t qv_offset;

/* Where the linker puts what is read by far addresses alone: toolchain/atmega1284p.ld. */
#define FLASH_VOLUME __attribute__((section(".volume")))

/* The address of an object with a name of its own; no constant, as pointers are shorter. */
#define FLASH_ADDRESS(object) (__extension__ pgm_get_far_address(object))

static inline qv_address qv_at(qv_address base, qv_offset offset)
{
    return base + (qv_address)offset;
}

/* Devices of up to 64 KB have no instruction that reads far, and need none. */
#ifdef __AVR_HAVE_ELPM__
#define FLASH_READ(width, address) pgm_read_##width##_far(address)
#else
#define FLASH_READ(width, address) pgm_read_##width((uint16_t)(address))
#endif

static inline uint8_t qv_read8(qv_address address)
{
    return FLASH_READ(byte, address);
}

static inline uint16_t qv_read16(qv_address address)
{
    return FLASH_READ(word, address);
}

static inline uint32_t qv_read32(qv_address address)
{
    return FLASH_READ(dword, address);
}

static inline int qv_aligned(qv_address address, unsigned alignment)
{
    return ((unsigned)address & (alignment - 1u)) == 0;
}

/* What is written is RAM. */
static inline int qv_distance(uintptr_t *distance, const void *written, qv_address read)
{
    (void)distance;
    (void)written;
    (void)read;
    return 0;
}

#endif /* VOLUME_FLASH_H */
