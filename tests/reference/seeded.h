/*
 * seeded.h - random scenes for comparisons, each named by a seed and a storage.
 *
 * A seed draws the view (either projection, angles, pitch, step, phase,
 * background), the size and spacing of the volume, the order, signs and gaps of
 * its strides, and what fills it: noise, smooth waves, sparse voxels or one
 * colour. Scenes of one seed differ between storages in their voxels only.
 *
 * Scenes for modes that weigh by length also draw the unit distance, 1/16 to 16 steps,
 * and the extinction of the full value; their steps are longer, and some hold nothing
 * but full opacity and none.
 */
#ifndef REFERENCE_SEEDED_H
#define REFERENCE_SEEDED_H

#include "reference.h"

#define SEEDED_LONGEST_AXIS    24
#define SEEDED_MOST_EDGE       40 /* pixels of a frame */
#define SEEDED_MOST_EXTINCTION 16 /* per world unit */

typedef struct seeded_scene {
    qv_scene scene; /* complete but for the sampling mode; early termination off */
    ref_view view;  /* what its camera was made of */
    const char *filling;
    qv_pyramid pyramid;
    unsigned char *memory, *coarser;
    unsigned char palette[QV_PALETTE16_BYTES];
} seeded_scene;

/* Makes a scene; seeded_free releases its voxels, also after an error. */
qv_status seeded_make(seeded_scene *made, uint32_t seed, qv_storage storage);
qv_status seeded_make_by_length(seeded_scene *made, uint32_t seed, qv_storage storage);

/* Gives a scene all coarser levels and draws the one to be sampled, in some scenes with
   perspective one that rises with the distance. The scene must stay
   where it is from then on. */
qv_status seeded_add_pyramid(seeded_scene *made, uint32_t seed);

void seeded_free(seeded_scene *made);

#endif /* REFERENCE_SEEDED_H */
