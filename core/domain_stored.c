#include "qvol.h"

static uint32_t weight(uint16_t channel)
{
    return channel;
}

static uint16_t channel(uint32_t weight_of_mean)
{
    return (uint16_t)weight_of_mean;
}

QV_DESCRIPTOR qv_domain qv_domain_stored = {weight, channel, 0};
