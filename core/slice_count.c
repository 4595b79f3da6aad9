#include "qvol.h"

#include "fx_correct.h"
#include "fx_wide.h"

uint32_t qv_opacity_for_slices(uint32_t opacity, uint16_t slices, uint16_t wanted)
{
    return fx_correct_slices(opacity, slices == 0 ? 1u : slices, wanted == 0 ? 1u : wanted);
}

/* 65537 is (2^32 - 1) / 65535; back to 16 bits to nearest, but for 2^-16 of the last place. */
static uint16_t opacity16_for_slices(uint16_t opacity, uint16_t slices, uint16_t wanted)
{
    uint32_t corrected = fx_correct_slices(65537u * opacity, slices, wanted);
    return (uint16_t)fx_high_product(corrected, 65535u);
}

qv_status qv_transfer_for_slices(qv_transfer *to, const qv_transfer *from, uint16_t slices,
                                 uint16_t wanted)
{
    if (!to || !from)
        return QV_ERROR_NULL;
    if (slices == 0 || wanted == 0)
        return QV_ERROR_SLICE;
    for (unsigned v = 0; v < QV_PALETTE_ENTRIES; v++) {
        for (unsigned c = 0; c < 3; c++)
            to->rgba[v][c] = from->rgba[v][c];
        to->rgba[v][3] = opacity16_for_slices(from->rgba[v][3], slices, wanted);
    }
    return QV_OK;
}
