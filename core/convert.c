#include "qvol.h"

#include "fx_log.h"
#include "fx_wide.h"
#include "entry.h"

/* The fourth channel, stored either way; 8-bit entries are widened to 16 first. */
typedef fx_unorm16 recode(fx_unorm16 value, uint64_t scale);

/* What to make: `number` is a unit distance or the extinction of the full value. */
typedef struct target {
    void *to;
    size_t bytes;
    unsigned storage;
    uint32_t number;
} target;

/* floor(a * b / 2^32), at most (2^32 - 1)^2 + 2^32 - 2. */
static uint64_t product_shift32(uint64_t a, uint32_t b)
{
    return fx_wide_product((uint32_t)(a >> 32), b) + (fx_wide_product((uint32_t)a, b) >> 32);
}

/*
 * unit * extinction is the full value's depth for the unit distance, Q32.32. Of it the
 * depth of a stretch is the stored value / 65535; 65537 / (2^32 - 1) is 1 / 65535.
 */
static fx_unorm16 extinction_of_opacity(fx_unorm16 opacity, uint64_t full_depth)
{
    return fx_quotient16(65535u * fx_depth_of_unorm16(opacity), full_depth); /* < 2^54 */
}

static fx_unorm16 opacity_of_extinction(fx_unorm16 extinction, uint64_t full_depth)
{
    return fx_unorm16_of_q31(fx_opacity(product_shift32(full_depth, 65537u * extinction)));
}

/*
 * a / b as Q32.32, for b > 0. At most 2^21, with which every depth of an opacity but 0
 * (2^-15.6 or more) passes 32, where fx_opacity is 1, and every extinction but 0 the full
 * value. The lowest bit of b beyond 2^31 moves the ratio by at most 2^-31 of it.
 */
#define RATIO_MOST ((uint64_t)1 << 53)

static uint64_t ratio_of(uint32_t a, uint32_t b)
{
    unsigned cut = (unsigned)(b >> 31);
    uint64_t ratio = fx_divide((uint64_t)a << (32u - cut), b >> cut);
    return ratio < RATIO_MOST ? ratio : RATIO_MOST;
}

/* The depth is at most 16.1, so its product below 17 * 2^53. */
static fx_unorm16 corrected_opacity(fx_unorm16 opacity, uint64_t ratio)
{
    if (opacity == 65535u)
        return opacity;
    fx_depth depth = fx_depth_of_unorm16(opacity);
    uint64_t whole = (uint64_t)fx_multiply((int64_t)ratio, (int32_t)(depth >> 32));
    return fx_unorm16_of_q31(fx_opacity(whole + product_shift32(ratio, (uint32_t)depth)));
}

static fx_unorm16 scaled_extinction(fx_unorm16 extinction, uint64_t ratio)
{
    uint64_t scaled = (product_shift32(ratio, (uint32_t)extinction << 16) + 0x8000u) >> 16;
    return scaled < 65535u ? (fx_unorm16)scaled : 65535u; /* <= 2^37 */
}

/* Storage of 8 or 16 bits, of the kind whose 8 bits are `kind`. */
static int is_kind(unsigned storage, unsigned kind)
{
    return storage - kind <= 1u;
}

/* Of a unit distance or of the extinction of the full value. */
static qv_status check_number(uint32_t number, unsigned kind)
{
    if (number != 0)
        return QV_OK;
    return kind == QV_STORAGE_RGBA8 ? QV_ERROR_UNIT : QV_ERROR_EXTINCTION;
}

static uint32_t number_of(const qv_entries *from, unsigned kind)
{
    return kind == QV_STORAGE_RGBA8 ? from->unit_distance : from->extinction;
}

static qv_status check_source(const qv_entries *from, unsigned kind)
{
    if (!from || !from->entries)
        return QV_ERROR_NULL;
    if (!is_kind(from->storage, kind))
        return QV_ERROR_STORAGE;
    if (!qv_aligned(from->entries, qv_channel_bytes(from->storage)))
        return QV_ERROR_STRIDE;
    return check_number(number_of(from, kind), kind);
}

static qv_status check(const target *t, unsigned kind, const qv_entries *from, unsigned from_kind)
{
    qv_status status = t->to ? check_source(from, from_kind) : QV_ERROR_NULL;
    if (status != QV_OK)
        return status;
    if (!is_kind(t->storage, kind))
        return QV_ERROR_STORAGE;
    if (t->bytes < fx_wide_product(from->count, qv_entry_bytes(t->storage)))
        return QV_ERROR_BUFFER;
    return check_number(t->number, kind);
}

/* An entry is read before it is written, and is never written beyond where it was read
   unless it widens: the source may be overwritten. 0, most of many volumes, stays 0 in every
   conversion, and costs nothing. */
static void convert(const target *t, const qv_entries *from, recode *fourth, uint64_t scale)
{
    uint8_t *to = (uint8_t *)t->to;
    qv_address at = from->entries;
    for (uint32_t i = 0; i < from->count; i++) {
        fx_unorm16 entry[4];
        qv_entry_read(entry, at, from->storage);
        if (entry[3] != 0)
            entry[3] = fourth(entry[3], scale);
        qv_entry_write(to, t->storage, entry);
        at = qv_at(at, (qv_offset)qv_entry_bytes(from->storage));
        to += qv_entry_bytes(t->storage);
    }
}

qv_status qv_opacity_to_extinction(void *to, size_t bytes, uint8_t storage, uint32_t extinction,
                                   const qv_entries *from)
{
    const target t = {to, bytes, storage, extinction};
    qv_status status = check(&t, QV_STORAGE_RGBT8, from, QV_STORAGE_RGBA8);
    if (status == QV_OK)
        convert(&t, from, extinction_of_opacity, fx_wide_product(from->unit_distance, extinction));
    return status;
}

qv_status qv_extinction_to_opacity(void *to, size_t bytes, uint8_t storage, uint32_t unit_distance,
                                   const qv_entries *from)
{
    const target t = {to, bytes, storage, unit_distance};
    qv_status status = check(&t, QV_STORAGE_RGBA8, from, QV_STORAGE_RGBT8);
    if (status == QV_OK)
        convert(&t, from, opacity_of_extinction, fx_wide_product(unit_distance, from->extinction));
    return status;
}

qv_status qv_opacity_to_opacity(void *to, size_t bytes, uint8_t storage, uint32_t unit_distance,
                                const qv_entries *from)
{
    const target t = {to, bytes, storage, unit_distance};
    qv_status status = check(&t, QV_STORAGE_RGBA8, from, QV_STORAGE_RGBA8);
    if (status == QV_OK)
        convert(&t, from, corrected_opacity, ratio_of(unit_distance, from->unit_distance));
    return status;
}

qv_status qv_extinction_to_extinction(void *to, size_t bytes, uint8_t storage, uint32_t extinction,
                                      const qv_entries *from)
{
    const target t = {to, bytes, storage, extinction};
    qv_status status = check(&t, QV_STORAGE_RGBT8, from, QV_STORAGE_RGBT8);
    if (status == QV_OK)
        convert(&t, from, scaled_extinction, ratio_of(from->extinction, extinction));
    return status;
}

/* The least extinction with unit * extinction >= depth, 1 .. 2^32 - 1: one above the
   greatest with less, which is found bit by bit. */
static uint32_t least_extinction(fx_depth depth, uint32_t unit)
{
    uint32_t below = 0;
    for (uint32_t bit = 0x80000000u; bit != 0; bit >>= 1)
        if (fx_wide_product(below | bit, unit) < depth)
            below |= bit;
    return below == 0xFFFFFFFFu ? below : below + 1u;
}

/* The greatest opacity below full, and whether there is a full one. */
static fx_unorm16 greatest_opacity(int *any_opaque, const qv_entries *from)
{
    fx_unorm16 greatest = 0;
    qv_address at = from->entries;
    *any_opaque = 0;
    for (uint32_t i = 0; i < from->count; i++) {
        fx_unorm16 entry[4];
        qv_entry_read(entry, at, from->storage);
        if (entry[3] == 65535u)
            *any_opaque = 1;
        else if (entry[3] > greatest)
            greatest = entry[3];
        at = qv_at(at, (qv_offset)qv_entry_bytes(from->storage));
    }
    return greatest;
}

qv_status qv_extinction_of(uint32_t *extinction, const qv_entries *from, uint32_t opaque)
{
    qv_status status = extinction ? check_source(from, QV_STORAGE_RGBA8) : QV_ERROR_NULL;
    if (status != QV_OK)
        return status;

    int any_opaque;
    fx_unorm16 most = greatest_opacity(&any_opaque, from);
    uint32_t least = least_extinction(fx_depth_of_unorm16(most), from->unit_distance);
    if (opaque == 0)
        opaque = least_extinction(FX_OPAQUE_DEPTH, from->unit_distance);
    *extinction = any_opaque && opaque > least ? opaque : least;
    return QV_OK;
}
