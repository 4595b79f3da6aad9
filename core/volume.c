#include "access.h"
#include "layout.h"
#include "palette.h"
#include "storage.h"

/* Dissolves into both checks, since each links only its own. */
FX_INLINE qv_status check_voxels(const qv_volume *volume)
{
    if (!volume || !volume->voxels)
        return QV_ERROR_NULL;
    unsigned storage = volume->storage;
    if (!qv_storage_known(storage))
        return QV_ERROR_STORAGE;
    unsigned alignment = qv_voxel_alignment(storage);
    if (!qv_aligned(volume->voxels, alignment))
        return QV_ERROR_STRIDE;
    qv_status status = qv_layout_check(volume->size, volume->stride, volume->voxels_bytes,
                                       qv_voxel_bytes(storage), alignment);
    if (status == QV_OK)
        status = qv_palette_check(volume, qv_channel_bytes(storage), qv_storage_indexed(storage));
    return status;
}

qv_status qv_voxels_check(const qv_volume *volume)
{
    return check_voxels(volume);
}

qv_status qv_volume_check(const qv_volume *volume)
{
    qv_status status = check_voxels(volume);
    if (status == QV_OK)
        status = qv_spacing_check(volume->spacing);
    return status;
}
