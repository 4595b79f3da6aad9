/*
 * storage.h - what a qv_storage means in bytes. The argument is a constant in
 * the sampling modes, so these fold away there.
 */
#ifndef QV_STORAGE_H
#define QV_STORAGE_H

#include "fx_inline.h"
#include "qvol.h"

/* Whether there is such a storage. */
FX_INLINE int qv_storage_known(unsigned storage)
{
    return storage - QV_STORAGE_RGBA8 <= QV_STORAGE_ASSOCIATED8 - QV_STORAGE_RGBA8;
}

/* Whether colours are stored weighted by opacity. */
FX_INLINE int qv_storage_associated(unsigned storage)
{
    return storage == QV_STORAGE_ASSOCIATED8;
}

/* Whether the fourth channel is extinction. */
FX_INLINE int qv_storage_extinction(unsigned storage)
{
    return storage >= QV_STORAGE_RGBT8 && !qv_storage_associated(storage);
}

FX_INLINE int qv_storage_indexed(unsigned storage)
{
    return ((storage - 1u) & 2u) != 0;
}

/* Bytes of one channel, 1 or 2. */
FX_INLINE unsigned qv_channel_bytes(unsigned storage)
{
    return (storage & 1u) != 0 ? 1u : 2u;
}

/* Bytes of one R,G,B,A entry, in the volume or in its palette. */
FX_INLINE unsigned qv_entry_bytes(unsigned storage)
{
    return 4u * qv_channel_bytes(storage);
}

FX_INLINE unsigned qv_voxel_bytes(unsigned storage)
{
    return qv_storage_indexed(storage) ? 1u : qv_entry_bytes(storage);
}

/* The storage of entries by themselves, without a palette. */
FX_INLINE unsigned qv_entry_storage(unsigned storage)
{
    return qv_storage_indexed(storage) ? storage - 2u : storage;
}

FX_INLINE unsigned qv_voxel_alignment(unsigned storage)
{
    if (qv_storage_associated(storage))
        return 4u;
    return (storage & 3u) == QV_STORAGE_RGBA16 ? 2u : 1u;
}

#endif /* QV_STORAGE_H */
