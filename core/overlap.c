#include "overlap.h"

#include "fx_wide.h"
#include "storage.h"

/* From the lowest byte to the highest; offsets fit a qv_offset, as the volume's check found. */
int qv_voxels_meet(const qv_volume *volume, const void *written, uint64_t bytes)
{
    qv_offset lowest = 0, highest = 0;
    uintptr_t distance;
    for (unsigned axis = 0; axis < 3; axis++) {
        qv_offset extent = (qv_offset)(volume->size[axis] - 1) * (qv_offset)volume->stride[axis];
        if (extent < 0)
            lowest += extent;
        else
            highest += extent;
    }
    uint64_t span = (uint64_t)(highest - lowest) + qv_voxel_bytes(volume->storage);
    return qv_distance(&distance, written, qv_at(volume->voxels, lowest)) &&
           qv_regions_meet(distance, bytes, span);
}

int qv_palette_meets(const qv_volume *volume, const void *written, uint64_t bytes)
{
    uintptr_t distance;
    return volume->palette && qv_distance(&distance, written, volume->palette) &&
           qv_regions_meet(distance, bytes, volume->palette_bytes);
}

int qv_records_meet(const qv_attenuation *attenuation, const void *written, uint64_t bytes)
{
    uintptr_t distance;
    return qv_distance(&distance, written, attenuation->records) &&
           qv_regions_meet(distance, bytes, attenuation->bytes);
}
