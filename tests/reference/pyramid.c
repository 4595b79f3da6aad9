#include "reference.h"

/* The storage of a level: the channels of the volume or of its palette. */
static uint8_t level_storage(uint8_t storage)
{
    if (ref_holds_extinction(storage)) {
        return ref_is_wide(storage) ? QV_STORAGE_RGBT16 : QV_STORAGE_RGBT8;
    }
    return ref_is_wide(storage) ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBA8;
}

/* Makes the next coarser level of a volume, its voxels at an address and tightly packed. */
static void coarsen(qv_volume *level, qv_address voxels)
{
    level->voxels = voxels;
    level->storage = level_storage(level->storage);
    level->palette = NULL;
    level->palette_bytes = 0;
    int32_t stride = ref_is_wide(level->storage) ? 8 : 4;
    for (int axis = 0; axis < 3; axis++) {
        const uint32_t spacing = level->spacing[axis] == 0 ? QV_ONE_Q16 : level->spacing[axis];
        level->size[axis] = (uint16_t)((level->size[axis] + 1) / 2);
        level->spacing[axis] = 2 * spacing;
        level->stride[axis] = stride;
        stride *= level->size[axis];
    }
    level->voxels_bytes = (uint64_t)stride;
}

void ref_pyramid_level(qv_volume *level, const qv_scene *scene, int number)
{
    *level = scene->volume;
    for (int i = 1; i <= number; i++) {
        /* level 1 begins the pyramid, each other where the one before it ends */
        coarsen(level, i == 1 ? scene->pyramid->voxels : level->voxels + level->voxels_bytes);
    }
}
