/*
 * planet_flash.c - the volume in program memory. It is included as a file: no object of C may
 * have more than 32767 bytes where pointers have 16 bits.
 */
#include "planet.h"

__asm__(".section .volume,\"a\"\n"
        ".balign 2\n"
        "planet_volume:\n"
        ".incbin \"planet.volume\"\n" /* see tests/device/planet_write.c */
        ".previous\n");

extern const uint8_t planet_volume[];

qv_address planet_voxels(void)
{
    return FLASH_ADDRESS(planet_volume);
}

qv_address planet_palette(void)
{
    return qv_at(planet_voxels(), PLANET_VOXELS);
}
