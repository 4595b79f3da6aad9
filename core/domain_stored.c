#include "qvol.h"

/* The channel itself, 8 or 16 bits. */
static uint32_t same(uint32_t channel, uint8_t storage)
{
    (void)storage;
    return channel;
}

const qv_domain qv_domain_stored = {same, same, 0};
