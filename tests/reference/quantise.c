#include "reference.h"

#include <math.h>

/* Far above the rounding of doubles, far below a level: lets exact ties go upwards. */
static const double tie = 1e-9;

uint32_t ref_level(double channel, uint32_t highest)
{
    return (uint32_t)floor(fmin(channel, 1) * highest + 0.5 + tie);
}

double ref_grey(const double rgba[4])
{
    return (77 * rgba[0] + 150 * rgba[1] + 29 * rgba[2]) / 256;
}
