/*
 * seeded.h - random scenes for comparisons, each named by a seed and a storage.
 *
 * A seed draws the view (either projection, angles, pitch, step, phase,
 * background), the size and spacing of the volume, the order, signs and gaps of
 * its strides, and what fills it: noise, smooth waves, sparse voxels or one
 * colour. Scenes of one seed differ between storages in their voxels only.
 */
#ifndef REFERENCE_SEEDED_H
#define REFERENCE_SEEDED_H

#include "reference.h"

#define SEEDED_LONGEST_AXIS 24

typedef struct seeded_scene {
    qv_scene scene; /* complete but for the sampling mode; early termination off */
    ref_view view;  /* what its camera was made of */
    const char *filling;
    unsigned char *memory;
    unsigned char palette[QV_PALETTE16_BYTES];
} seeded_scene;

/* Makes a scene; seeded_free releases its voxels, also after an error. */
qv_status seeded_make(seeded_scene *made, uint32_t seed, qv_storage storage);
void seeded_free(seeded_scene *made);

#endif /* REFERENCE_SEEDED_H */
