/*
 * scenes.h - the scenes over which `make advise` measures errors: a scan of a head, a faint fog,
 * waves of mixed colours, and a ball with a border of three voxels.
 *
 * Each is a volume of 8-bit values and a table of 16-bit RGBA entries, whose opacities hold for a
 * voxel. What a storage keeps is made of that.
 */
#ifndef ADVISE_SCENES_H
#define ADVISE_SCENES_H

#include "qvol.h"

typedef struct advise_scene {
    const char *name;
    uint16_t size[3];
    uint8_t *values; /* x fastest */
    uint16_t entries[QV_PALETTE_ENTRIES][4];
} advise_scene;

enum { ADVISE_SCENES = 4 };

/* Makes scene 0 .. ADVISE_SCENES - 1; the caller frees its values. Ends the program where the
   head's file is missing. */
void advise_scene_make(advise_scene *made, unsigned number);

/* A volume of a scene as a storage keeps it. Opacities hold for the unit distance, Q16.16, or for
   the step where that is 0: then `step`, Q16.16, is that step. */
typedef struct advise_volume {
    qv_volume volume;
    uint16_t entries[QV_PALETTE_ENTRIES][4]; /* as stored: of 8 bits, the first half */
    uint8_t *memory;                         /* null: the voxels are the scene's values */
} advise_volume;

void advise_volume_make(advise_volume *made, const advise_scene *of, qv_storage storage,
                        uint32_t unit_distance, uint32_t step);
void advise_volume_free(advise_volume *made);

#endif /* ADVISE_SCENES_H */
