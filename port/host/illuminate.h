/*
 * illuminate.h - light from outside on the voxels that are to be ray cast.
 */
#ifndef QVOL_HOST_ILLUMINATE_H
#define QVOL_HOST_ILLUMINATE_H

#include "model.h"

/* Replaces the voxels by entries in the light of the settings' lamps. Attenuation is built for the
   directions that the lamps shine between, and freed. Opacities without a unit distance hold for
   the step, Q16.16. */
void illuminate(qv_volume *volume, struct model *model, uint32_t step,
                const struct settings *settings);

#endif
