#include "access.h"
#include "layout.h"
#include "storage.h"

/* Indexed storage has a palette, of so many bytes a channel; other storage has none. */
static qv_status check_palette(const qv_volume *volume, unsigned channel_bytes, int indexed)
{
    uint32_t expected = indexed ? 4u * QV_PALETTE_ENTRIES * channel_bytes : 0;
    int present = volume->palette != 0;
    if (present != indexed || volume->palette_bytes != expected ||
        !qv_aligned(volume->palette, channel_bytes))
        return QV_ERROR_PALETTE;
    return QV_OK;
}

qv_status qv_volume_check(const qv_volume *volume)
{
    if (!volume || !volume->voxels)
        return QV_ERROR_NULL;
    unsigned storage = volume->storage;
    if (storage - QV_STORAGE_RGBA8 > QV_STORAGE_INDEXED8_T16 - QV_STORAGE_RGBA8)
        return QV_ERROR_STORAGE;
    unsigned alignment = qv_voxel_alignment(storage);
    if (!qv_aligned(volume->voxels, alignment))
        return QV_ERROR_STRIDE;
    qv_status status = qv_layout_check(volume->size, volume->stride, volume->voxels_bytes,
                                       qv_voxel_bytes(storage), alignment);
    if (status == QV_OK)
        status = check_palette(volume, qv_channel_bytes(storage), qv_storage_indexed(storage));
    if (status == QV_OK)
        status = qv_spacing_check(volume->spacing);
    return status;
}
