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

void ref_voxel(double rgba[4], const qv_volume *volume, const int32_t at[3])
{
    ptrdiff_t offset = 0;
    for (int axis = 0; axis < 3; axis++) {
        offset += (ptrdiff_t)at[axis] * volume->stride[axis];
    }
    const unsigned char *voxel = volume->voxels + offset;
    switch (volume->storage) {
    case QV_STORAGE_RGBA8:
        read_rgba8(rgba, voxel);
        break;
    case QV_STORAGE_RGBA16:
        read_rgba16(rgba, voxel);
        break;
    case QV_STORAGE_INDEXED8:
        read_rgba8(rgba, volume->palette + 4 * *voxel);
        break;
    default:
        read_rgba16(rgba, volume->palette + 8 * *voxel);
        break;
    }
}
