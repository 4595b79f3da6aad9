#include "reference.h"

#include <string.h>

static double unorm8(const unsigned char *byte)
{
    return *byte / 255.0;
}

static double unorm16(const unsigned char *bytes)
{
    uint16_t value;
    memcpy(&value, bytes, sizeof value);
    return value / 65535.0;
}

static void read_rgba8(double rgba[4], const unsigned char *entry)
{
    for (int channel = 0; channel < 4; channel++) {
        rgba[channel] = unorm8(entry + channel);
    }
}

static void read_rgba16(double rgba[4], const unsigned char *entry)
{
    for (int channel = 0; channel < 4; channel++) {
        rgba[channel] = unorm16(entry + 2 * channel);
    }
}

bool ref_is_wide(uint8_t storage)
{
    return storage == QV_STORAGE_RGBA16 || storage == QV_STORAGE_INDEXED8_16 ||
           storage == QV_STORAGE_RGBT16 || storage == QV_STORAGE_INDEXED8_T16;
}

bool ref_is_indexed(uint8_t storage)
{
    return storage == QV_STORAGE_INDEXED8 || storage == QV_STORAGE_INDEXED8_16 ||
           storage == QV_STORAGE_INDEXED8_T8 || storage == QV_STORAGE_INDEXED8_T16;
}

bool ref_holds_extinction(uint8_t storage)
{
    return storage == QV_STORAGE_RGBT8 || storage == QV_STORAGE_RGBT16 ||
           storage == QV_STORAGE_INDEXED8_T8 || storage == QV_STORAGE_INDEXED8_T16;
}

bool ref_is_associated(uint8_t storage)
{
    return storage == QV_STORAGE_ASSOCIATED8;
}

void ref_voxel(double rgba[4], const qv_volume *volume, const int32_t at[3])
{
    ptrdiff_t offset = 0;
    for (int axis = 0; axis < 3; axis++) {
        offset += (ptrdiff_t)at[axis] * volume->stride[axis];
    }
    const unsigned char *entry = volume->voxels + offset;
    const bool wide = ref_is_wide(volume->storage);
    if (ref_is_indexed(volume->storage)) {
        entry = volume->palette + (wide ? 8 : 4) * *entry;
    }
    if (wide) {
        read_rgba16(rgba, entry);
    } else {
        read_rgba8(rgba, entry);
    }
}
