#include "fx_angle.h"

#include "fx_table.h"
#include "fx_wide.h"

#define EIGHTH_TURN 0x20000000u

/*
 * Series in u = angle / 45 degrees, 0 <= u < 1, as Q0.32: coefficients (pi/4)^n /
 * n! * 2^32, the highest power first. That one is less by .93 of the term left
 * out for the sine. What is left out is below 2^-32 for both.
 */
#define TERMS 5
FX_TABLE uint32_t sine_series[TERMS] = {0x0000053B, 0x000265A6, 0x00A335E3, 0x14ABBCE6,
                                        0xC90FDAA2}; /* u^9 .. u */
FX_TABLE uint32_t cosine_series[TERMS] = {0x0000006A, 0x00003C3F, 0x00155D3C, 0x040F07C2,
                                          0x4EF4F327}; /* u^10 .. u^2 */

/* c[4] - u2 * (c[3] - u2 * (c[2] - ...)); each bracket lies in 0 .. 1. */
static uint32_t alternating(const uint32_t c[TERMS], uint32_t u2)
{
    uint32_t sum = fx_table32(&c[0]);
    for (unsigned i = 1; i < TERMS; i++)
        sum = fx_table32(&c[i]) - fx_high_product(u2, sum);
    return sum;
}

/* Q0.32 to Q2.30, to nearest. */
static int32_t to_q30(uint32_t fraction)
{
    return (int32_t)((fraction >> 2) + ((fraction >> 1) & 1u)); /* <= 2^30 */
}

void fx_sine_cosine(int32_t *sine, int32_t *cosine, fx_angle angle)
{
    uint32_t quadrant = angle >> 30;
    uint32_t rest = angle & (FX_QUARTER_TURN - 1u);
    int mirrored = rest > EIGHTH_TURN;
    uint32_t eighth = mirrored ? FX_QUARTER_TURN - rest : rest; /* <= 2^29 */
    uint32_t u = eighth == EIGHTH_TURN ? 0xFFFFFFFFu : eighth << 3;
    uint32_t u2 = fx_high_product(u, u);
    int32_t s = to_q30(fx_high_product(u, alternating(sine_series, u2)));
    int32_t c = FX_ONE_Q30 - to_q30(fx_high_product(u2, alternating(cosine_series, u2)));

    /* sin(90 - a) = cos(a); sin(a + 90) = cos(a), cos(a + 90) = -sin(a) */
    int swapped = mirrored != (int)(quadrant & 1u);
    int32_t along = swapped ? s : c, across = swapped ? c : s;
    *cosine = quadrant == 1u || quadrant == 2u ? -along : along;
    *sine = quadrant >= 2u ? -across : across;
}
