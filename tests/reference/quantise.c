#include "reference.h"

#include <math.h>

/* Far above the rounding of doubles, far below a level: lets exact ties go upwards. */
static const double tie = 1e-9;

uint32_t ref_level(double channel, uint32_t highest)
{
    return (uint32_t)floor(fmin(channel, 1) * highest + 0.5 + tie);
}

/* The 8x8 pattern of Bayer, 1973. */
static const uint8_t bayer[8][8] = {
    {0, 32, 8, 40, 2, 34, 10, 42},  {48, 16, 56, 24, 50, 18, 58, 26},
    {12, 44, 4, 36, 14, 46, 6, 38}, {60, 28, 52, 20, 62, 30, 54, 22},
    {3, 35, 11, 43, 1, 33, 9, 41},  {51, 19, 59, 27, 49, 17, 57, 25},
    {15, 47, 7, 39, 13, 45, 5, 37}, {63, 31, 55, 23, 61, 29, 53, 21},
};

/* Place in a pattern of 8 that goes on to both sides of 0. */
static int32_t place(int32_t position)
{
    return (position % 8 + 8) % 8;
}

uint32_t ref_dithered_level(double channel, uint32_t highest, int32_t x, int32_t y)
{
    const double threshold = (bayer[place(y)][place(x)] + 0.5) / 64;
    return (uint32_t)floor(fmin(channel, 1) * highest + threshold + tie);
}

double ref_grey(const double rgba[4])
{
    return (77 * rgba[0] + 150 * rgba[1] + 29 * rgba[2]) / 256;
}
