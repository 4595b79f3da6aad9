/*
 * advice.c - what the library recommends for a scene's slices.
 */
#include "advice.h"
#include "sampling.h"
#include "settings_slices.h"

#include <math.h>
#include <string.h>

/* 1 as a Q0.32. */
#define OPAQUE UINT32_MAX

/* The fourth channel of a voxel, or of its palette's entry. */
static uint16_t fourth_channel(const qv_volume *volume, const unsigned char *voxel)
{
    qv_storage storage = (qv_storage)volume->storage;
    unsigned bytes = storage_channel_bytes(storage);
    uint16_t value;
    if (storage_is_indexed(storage)) {
        voxel = volume->palette + (size_t)*voxel * 4 * bytes;
    }
    if (bytes == 1) {
        return voxel[3];
    }
    memcpy(&value, voxel + 6, sizeof value);
    return value;
}

/* Of the voxels; 0 where all are 0. */
static uint16_t least_fourth_channel(const qv_volume *volume)
{
    const qv_offset stride[3] = {volume->stride[0], volume->stride[1], volume->stride[2]};
    uint16_t least = 0;
    for (unsigned z = 0; z < volume->size[2]; z++) {
        for (unsigned y = 0; y < volume->size[1]; y++) {
            const unsigned char *row = volume->voxels + z * stride[2] + y * stride[1];
            for (unsigned x = 0; x < volume->size[0]; x++) {
                uint16_t value = fourth_channel(volume, row + x * stride[0]);
                if (value != 0 && (least == 0 || value < least)) {
                    least = value;
                }
            }
        }
    }
    return least;
}

/* nearest takes opacities of voxels as they are; without any, everything is opaque. Between a
   voxel and an empty one interpolation makes any opacity, and so does a short stretch. */
static uint32_t least_opacity(const qv_volume *volume, const struct settings *settings)
{
    qv_storage storage = (qv_storage)volume->storage;
    uint32_t full = storage_channel_bytes(storage) == 1 ? UINT8_MAX : UINT16_MAX;
    uint32_t value;
    if (sampling_mode(settings, storage) != SAMPLING_NEAREST) {
        return 1;
    }
    value = least_fourth_channel(volume);
    return value != 0 ? value * (OPAQUE / full) : OPAQUE; /* both 255 and 65535 divide it */
}

static uint16_t slice_count(const qv_scene *scene, const struct settings *settings)
{
    const qv_volume *volume = &scene->volume;
    double depth = scene_depth(volume->size, volume->spacing, settings) * QV_ONE_Q16;
    return (uint16_t)fmin(fmax(round(depth / scene->camera.step), 1), UINT16_MAX);
}

void advice_ask(struct advice *advice, const qv_scene *scene, const struct settings *settings)
{
    int framebuffer = settings_framebuffer(settings);
    uint8_t bits = (uint8_t)(framebuffer == FRAMEBUFFER_565 ? 5 : framebuffer);
    uint8_t residual = (uint8_t)settings_residual(settings);
    qv_status status;
    advice->slices = slice_count(scene, settings);
    advice->opacity = least_opacity(&scene->volume, settings);
    status = qv_recommend(&advice->recommendation, bits, residual, advice->slices, advice->opacity);
    advice->given = status == QV_OK && settings_back_to_front(settings);
}

int advice_dither(const struct advice *advice)
{
    switch (advice->recommendation.advice) {
    case QV_ADVICE_DITHER:
        return DITHER_ROUNDING;
    case QV_ADVICE_RESIDUAL:
        return DITHER_FEEDBACK;
    default:
        return DITHER_NONE;
    }
}
