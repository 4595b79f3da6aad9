#include "tally.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void tally_pixel(tally *into, const uint8_t bytes[4], const ref_pixel *pixel)
{
    for (int channel = 0; channel < 4; channel++) {
        const int expected = (int)ref_level(pixel->rgba[channel], 255);
        const uint32_t off = (uint32_t)abs(bytes[channel] - expected);
        const double distance = fabs(bytes[channel] - pixel->rgba[channel] * 255);
        into->channels++;
        into->equal += off == 0;
        into->beyond += off > 1;
        into->worst = off > into->worst ? off : into->worst;
        into->farthest = fmax(into->farthest, distance);
    }
}

void tally_add(tally *into, const tally *other)
{
    into->channels += other->channels;
    into->equal += other->equal;
    into->beyond += other->beyond;
    into->worst = other->worst > into->worst ? other->worst : into->worst;
    into->farthest = fmax(into->farthest, other->farthest);
}

double tally_share(const tally *of)
{
    return of->channels == 0 ? 1 : (double)of->equal / (double)of->channels;
}

void tally_print(const char *name, const tally *of)
{
    printf("# %s: %" PRIu64 " channels, worst %" PRIu32 " of 255, %.4f %% equal, "
           "farthest %.4f levels from real\n",
           name, of->channels, of->worst, 100 * tally_share(of), of->farthest);
}
