#include "access.h"
#include "layout.h"
#include "storage.h"

static qv_status check_palette(const qv_volume *volume)
{
    int indexed = qv_storage_indexed(volume->storage);
    uint32_t expected = indexed ? QV_PALETTE_ENTRIES * qv_entry_bytes(volume->storage) : 0;
    int present = volume->palette != 0;
    if (present != indexed || volume->palette_bytes != expected ||
        !qv_aligned(volume->palette, qv_channel_bytes(volume->storage)))
        return QV_ERROR_PALETTE;
    return QV_OK;
}

qv_status qv_volume_check(const qv_volume *volume)
{
    if (!volume || !volume->voxels)
        return QV_ERROR_NULL;
    if (volume->storage < QV_STORAGE_RGBA8 || volume->storage > QV_STORAGE_INDEXED8_16)
        return QV_ERROR_STORAGE;
    if (volume->occupancy)
        return QV_ERROR_RESERVED;
    if (!qv_aligned(volume->voxels, qv_voxel_alignment(volume->storage)))
        return QV_ERROR_STRIDE;
    qv_status status =
        qv_layout_check(volume->size, volume->stride, volume->voxels_bytes,
                        qv_voxel_bytes(volume->storage), qv_voxel_alignment(volume->storage));
    if (status == QV_OK)
        status = check_palette(volume);
    if (status == QV_OK)
        status = qv_spacing_check(volume->spacing);
    return status;
}
