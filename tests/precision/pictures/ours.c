#include "pictures.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Rounds a channel into memory; returns where the next one goes. */
static uint8_t *put_channel(uint8_t *to, double channel, bool wide)
{
    const uint16_t value = (uint16_t)floor(channel * (wide ? 65535 : 255) + 0.5);
    if (!wide) {
        *to = (uint8_t)value;
        return to + 1;
    }
    memcpy(to, &value, sizeof value);
    return to + sizeof value;
}

/* RGBA of the real voxels. */
static void fill(uint8_t *to, const picture_scene *from, bool wide)
{
    for (size_t i = 0; i < from->voxels; i++) {
        for (int channel = 0; channel < 4; channel++) {
            to = put_channel(to, from->rgba[i][channel], wide);
        }
    }
}

/* Colours are weighted by the library, of 16 bits. */
static void associate(ours_volume *made, size_t voxels)
{
    const qv_entries from = {
        .entries = made->voxels, .count = (uint32_t)voxels, .storage = QV_STORAGE_RGBA16};
    paper_require(qv_opacity_to_associated(made->voxels, 8 * voxels, &from) == QV_OK,
                  "cannot weight colours");
}

void ours_make(ours_volume *made, const picture_scene *from, const our_mode *by)
{
    const bool associated = ref_is_associated((uint8_t)by->storage);
    const bool wide = associated || ref_is_wide((uint8_t)by->storage);
    made->scene = from->scene;
    made->voxels = paper_memory(from->voxels, 8);
    fill(made->voxels, from, wide);
    if (associated) {
        associate(made, from->voxels);
    }
    qv_volume *volume = &made->scene.volume;
    int32_t stride = wide && !associated ? 8 : 4;
    volume->storage = (uint8_t)by->storage;
    volume->voxels = made->voxels;
    volume->voxels_bytes = from->voxels * (uint64_t)stride;
    for (int axis = 0; axis < 3; axis++) {
        volume->stride[axis] = stride;
        stride *= volume->size[axis];
    }
    made->scene.sampling = by->sampling;
}

void ours_free(ours_volume *made)
{
    free(made->voxels);
    made->voxels = NULL;
}

void ours_picture(paper_picture *made, const picture_scene *from, const our_mode *by)
{
    ours_volume volume;
    ours_make(&volume, from, by);
    paper_render(made, &volume.scene, from->edge, from->edge);
    ours_free(&volume);
}
