/*
 * entry.h - R,G,B,A and R,G,B,T entries, one by one.
 */
#ifndef QV_ENTRY_H
#define QV_ENTRY_H

#include "fx_unorm.h"
#include "access.h"
#include "storage.h"

/* Reads an entry; 8 bits become 16, exactly. */
static inline void qv_entry_read(fx_unorm16 entry[4], qv_address from, unsigned storage)
{
    int wide = qv_channel_bytes(storage) == 2;
    for (unsigned channel = 0; channel < 4; channel++) {
        qv_address at = qv_at(from, (qv_offset)(wide ? 2u * channel : channel));
        entry[channel] = wide ? qv_read16(at) : fx_unorm8_to_unorm16(qv_read8(at));
    }
}

/* The fourth channel of an entry, likewise. */
static inline fx_unorm16 qv_entry_fourth(qv_address from, unsigned storage)
{
    if (qv_channel_bytes(storage) == 2)
        return qv_read16(qv_at(from, 6));
    return fx_unorm8_to_unorm16(qv_read8(qv_at(from, 3)));
}

/* Writes an entry, which needs no alignment; 8-bit channels to nearest. */
static inline void qv_entry_write(uint8_t *to, unsigned storage, const fx_unorm16 entry[4])
{
    if (qv_channel_bytes(storage) == 2) {
        memcpy(to, entry, 4 * sizeof entry[0]);
        return;
    }
    for (unsigned channel = 0; channel < 4; channel++)
        to[channel] = fx_unorm16_to_unorm8(entry[channel]);
}

#endif /* QV_ENTRY_H */
