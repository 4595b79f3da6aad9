#include "thickness.h"

#include "storage.h"

/* Powers of 2: of a step to the unit distance, either way, and of the full value's depth for it. */
#define MOST_RATIO_BITS 12
#define MOST_DEPTH_BITS 12

#define MOST_SHIFT 63

/* v * 2^-shift, v not 0, with a factor of 32 bits, cut. */
static void normalise(qv_thickness *thickness, uint64_t v, unsigned shift)
{
    for (; v >> 32 != 0; v >>= 1)
        shift--;
    thickness->factor = (uint32_t)v;
    thickness->shift = (uint8_t)shift;
}

/*
 * Weights are depths for the unit distance, Q8.24, so in Q32.32 they are to be multiplied by
 * 2^8 length / unit distance. That is 2 * length / unit for the numbers in Q9.23 and Q16.16.
 */
static qv_status of_opacity(qv_thickness *thickness, uint32_t unit, uint32_t length)
{
    if (unit == 0) {
        thickness->factor = (uint32_t)1 << 31;
        thickness->shift = 31 - 8;
        return QV_OK;
    }
    uint64_t scaled = (uint64_t)unit << 7; /* Q9.23 too */
    if (scaled << MOST_RATIO_BITS < length || (uint64_t)length << MOST_RATIO_BITS < scaled)
        return QV_ERROR_UNIT;
    unsigned cut = (unsigned)(unit >> 31); /* a unit of 32 bits is halved, and the length with it */
    uint64_t quotient = fx_divide((((uint64_t)length << 32) + unit / 2u) >> cut, unit >> cut);
    normalise(thickness, quotient, 31); /* 2^27 .. 2^51 */
    return QV_OK;
}

/*
 * Weights are stored values, 65535 being the full one: its depth is extinction * length in
 * Q25.39, and in Q32.32 2^-7 of that number. 1/65535 is 1/2^16 + 1/2^32 and 2^-48 of itself.
 */
static qv_status of_extinction(qv_thickness *thickness, uint32_t extinction, uint32_t length)
{
    uint64_t depth = fx_wide_product(extinction, length);
    if (depth == 0 || depth >> (MOST_DEPTH_BITS + 39) != 0)
        return QV_ERROR_EXTINCTION;
    unsigned shift = 7 + 16;
    for (; depth >> (MOST_DEPTH_BITS + 38) == 0 && shift < MOST_SHIFT; depth <<= 1)
        shift++;
    normalise(thickness, depth + (depth >> 16) + (depth >> 32), shift); /* below 2^52 */
    return QV_OK;
}

qv_status qv_thickness_of(qv_thickness *thickness, const qv_volume *volume, uint32_t length)
{
    if (qv_storage_extinction(volume->storage))
        return of_extinction(thickness, volume->extinction, length);
    return of_opacity(thickness, volume->unit_distance, length);
}
