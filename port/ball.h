/*
 * ball.h - a small volume of FreeVoxels: a striped ball in a fog, with the bytes of all 26
 * directions. Devices keep it in program memory.
 */
#ifndef BALL_H
#define BALL_H

#include "qvol.h"

/* Voxels on each axis: as many as leave the bytes within 64 KB of flash; odd, so that one voxel
   is in the middle. */
#define BALL_SIZE        13
#define BALL_VOXELS      ((uint32_t)BALL_SIZE * BALL_SIZE * BALL_SIZE)
#define BALL_ATTENUATION (BALL_VOXELS * QV_DIRECTIONS)

/* A palette, one without opacity, voxels of QV_STORAGE_INDEXED8, and bytes of attenuation in linear
   order. Where it lies is the machine's business. */
qv_address ball_data(void);

#define BALL_PALETTE_AT     0
#define BALL_CLEAR_AT       QV_PALETTE8_BYTES
#define BALL_VOXELS_AT      (2 * QV_PALETTE8_BYTES)
#define BALL_ATTENUATION_AT (BALL_VOXELS_AT + BALL_VOXELS)
#define BALL_BYTES          (BALL_ATTENUATION_AT + BALL_ATTENUATION)

/* Describe it; of the volume, opacities hold for a unit distance of one voxel. */
void ball_volume(qv_volume *volume);
void ball_attenuation(qv_attenuation *attenuation);

#endif /* BALL_H */
