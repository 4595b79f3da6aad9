/*
 * planet.h - the volume that firmware_planet.c shows, and the picture that it leaves. Where the
 * volume lies is the machine's business: planet_flash.c on an AVR.
 */
#ifndef PLANET_H
#define PLANET_H

#include "qvol.h"

#define PLANET_SIZE   32 /* voxels on each axis */
#define PLANET_VOXELS ((uint32_t)PLANET_SIZE * PLANET_SIZE * PLANET_SIZE)
#define PLANET_WIDTH  64 /* pixels */
#define PLANET_HEIGHT 64

/* Of QV_STORAGE_INDEXED8_16, as tests/device/planet.c makes them. */
qv_address planet_voxels(void);
qv_address planet_palette(void);

extern uint8_t planet_frame[PLANET_HEIGHT][PLANET_WIDTH][3]; /* R, G, B */

#endif /* PLANET_H */
