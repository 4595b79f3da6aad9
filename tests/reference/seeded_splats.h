/*
 * seeded_splats.h - random pictures of splats, each named by a seed and a storage.
 *
 * Volume, view and coarser levels are those of seeded.h; the same seed also draws the kernel,
 * lamps, levels, the detail at which they change, and whether light goes by the nearest
 * direction.
 */
#ifndef REFERENCE_SEEDED_SPLATS_H
#define REFERENCE_SEEDED_SPLATS_H

#include "freevoxels.h"
#include "seeded.h"

typedef struct seeded_splats {
    seeded_scene drawn;
    int levels; /* coarser ones that there are */
    qv_volume level[REF_LEVELS];
    qv_splat_scene scene; /* complete but for splatting and inside */
    ref_splats real;      /* complete but for depths */
} seeded_splats;

/* May not move; seeded_splats_free releases it, also after an error. */
qv_status seeded_splats_make(seeded_splats *made, uint32_t seed, qv_storage storage);
void seeded_splats_free(seeded_splats *made);

#endif /* REFERENCE_SEEDED_SPLATS_H */
