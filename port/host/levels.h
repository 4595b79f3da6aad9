/*
 * levels.h - the coarser levels of a volume: from the input, or downsampled here.
 */
#ifndef QVOL_HOST_LEVELS_H
#define QVOL_HOST_LEVELS_H

#include "model.h"

struct levels {
    qv_pyramid pyramid;
    void *voxels;       /* that were made here; null: they are the input's */
    const char *filter; /* names of what made them; null: they are the input's */
    const char *domain;
};

/* Makes every level down to one voxel, on the settings' threads. */
void levels_build(struct levels *levels, const qv_volume *volume, const struct model *model,
                  const struct settings *settings);

/* Those that follow the voxels of the input, or else builds them. */
void levels_create(struct levels *levels, const qv_volume *volume, const struct model *model,
                   const struct settings *settings);

void levels_free(struct levels *levels);

#endif
