#include "qvol.h"

#include "fx_log.h"
#include "storage.h"

/* Extinction of an opacity, Q8.24. Opacities of 8 bits take the way of those of 16, to
   which they widen exactly, rather than a table of their own. */
static uint32_t extinction_of(uint32_t opacity, uint8_t storage)
{
    uint32_t wide = qv_channel_bytes(storage) == 1 ? opacity * 257u : opacity;
    return fx_extinction_of_unorm16((fx_unorm16)wide);
}

static uint32_t opacity_of(uint32_t extinction, uint8_t storage)
{
    fx_unorm16 opacity = fx_opacity16(extinction);
    return qv_channel_bytes(storage) == 1 ? fx_unorm16_to_unorm8(opacity) : opacity;
}

const qv_domain qv_domain_extinction = {extinction_of, opacity_of, 1};
