/*
 * palette.h - the check of a volume's palette.
 */
#ifndef QV_PALETTE_H
#define QV_PALETTE_H

#include "access.h"
#include "fx_inline.h"
#include "qvol.h"

/* Indexed storage has a palette, of so many bytes a channel; other storage has none.
   QV_OK, QV_ERROR_PALETTE. */
FX_INLINE qv_status qv_palette_check(const qv_volume *volume, unsigned channel_bytes, int indexed)
{
    uint32_t expected = indexed ? 4u * QV_PALETTE_ENTRIES * channel_bytes : 0;
    int present = volume->palette != 0;
    if (present != indexed || volume->palette_bytes != expected ||
        !qv_aligned(volume->palette, channel_bytes))
        return QV_ERROR_PALETTE;
    return QV_OK;
}

#endif /* QV_PALETTE_H */
