/*
 * planet_make.h - makes the volume of port/avr/planet.h.
 */
#ifndef PLANET_MAKE_H
#define PLANET_MAKE_H

#include "planet.h"

void planet_make_voxels(uint8_t voxels[PLANET_SIZE][PLANET_SIZE][PLANET_SIZE]);
void planet_make_palette(uint16_t entry[QV_PALETTE_ENTRIES][4]);

#endif /* PLANET_MAKE_H */
