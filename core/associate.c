#include "fx_wide.h"
#include "entry.h"

/* Colour * opacity of 16 bits in 8 bits, to nearest: 65535 * 257 is 65535^2 / 255, and odd, so
   there are no ties. The product is below 2^32. */
static uint8_t associated(fx_unorm16 colour, fx_unorm16 opacity)
{
    return (uint8_t)fx_quotient16((uint32_t)colour * opacity, 65535u * (uint64_t)257u);
}

static void associate(uint8_t *to, qv_address from, unsigned storage)
{
    fx_unorm16 entry[4];
    qv_entry_read(entry, from, storage);
    for (unsigned c = 0; c < 3; c++)
        to[c] = associated(entry[c], entry[3]);
    to[3] = fx_unorm16_to_unorm8(entry[3]);
}

static qv_status check(const void *to, size_t bytes, const qv_entries *from)
{
    if (!to || !from || !from->entries)
        return QV_ERROR_NULL;
    if (from->storage != QV_STORAGE_RGBA8 && from->storage != QV_STORAGE_RGBA16)
        return QV_ERROR_STORAGE;
    if (!qv_aligned(from->entries, qv_channel_bytes(from->storage)))
        return QV_ERROR_STRIDE;
    return bytes < fx_wide_product(from->count, 4) ? QV_ERROR_BUFFER : QV_OK;
}

/* An entry is read before one is written, which is never longer: the source may be overwritten. */
qv_status qv_opacity_to_associated(void *to, size_t bytes, const qv_entries *from)
{
    qv_status status = check(to, bytes, from);
    if (status != QV_OK)
        return status;
    uint8_t *entry = (uint8_t *)to;
    qv_address at = from->entries;
    for (uint32_t i = 0; i < from->count; i++, entry += 4) {
        associate(entry, at, from->storage);
        at = qv_at(at, (qv_offset)qv_entry_bytes(from->storage));
    }
    return QV_OK;
}
