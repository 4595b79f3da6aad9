#include "fx_angle.h"

#include "fx_wide.h"

#define EIGHTH_TURN 0x20000000u

/* a*b of two Q0.32 fractions, and Q0.32 to Q2.30, both to nearest. */
#define TIMES fx_high_product

static int32_t to_q30(uint32_t fraction)
{
    return (int32_t)((fraction >> 2) + ((fraction >> 1) & 1u)); /* <= 2^30 */
}

/*
 * Series in u = angle / 45 degrees, 0 <= u < 1, as Q0.32. The coefficients are
 * (pi/4)^n / n! * 2^32; the last one of the sine is less by .93 of the term that
 * is left out. What is left out is below 2^-32 for both. Every bracket lies in
 * 0 .. 1, so no step wraps.
 */
static int32_t sine_of_eighth(uint32_t u)
{
    uint32_t u2 = TIMES(u, u);
    uint32_t s = 0x000265A6u - TIMES(u2, 0x0000053Bu);
    s = 0x00A335E3u - TIMES(u2, s);
    s = 0x14ABBCE6u - TIMES(u2, s);
    s = 0xC90FDAA2u - TIMES(u2, s);
    return to_q30(TIMES(u, s));
}

static int32_t cosine_of_eighth(uint32_t u)
{
    uint32_t u2 = TIMES(u, u);
    uint32_t c = 0x00003C3Fu - TIMES(u2, 0x0000006Au);
    c = 0x00155D3Cu - TIMES(u2, c);
    c = 0x040F07C2u - TIMES(u2, c);
    c = 0x4EF4F327u - TIMES(u2, c);
    return FX_ONE_Q30 - to_q30(TIMES(u2, c));
}

void fx_sine_cosine(int32_t *sine, int32_t *cosine, fx_angle angle)
{
    uint32_t quadrant = angle >> 30;
    uint32_t rest = angle & (FX_QUARTER_TURN - 1u);
    int mirrored = rest > EIGHTH_TURN;
    uint32_t eighth = mirrored ? FX_QUARTER_TURN - rest : rest; /* <= 2^29 */
    uint32_t u = eighth == EIGHTH_TURN ? 0xFFFFFFFFu : eighth << 3;
    int32_t s = sine_of_eighth(u), c = cosine_of_eighth(u);

    /* sin(90 - a) = cos(a); sin(a + 90) = cos(a), cos(a + 90) = -sin(a) */
    int swapped = mirrored != (int)(quadrant & 1u);
    int32_t along = swapped ? s : c, across = swapped ? c : s;
    *cosine = quadrant == 1u || quadrant == 2u ? -along : along;
    *sine = quadrant >= 2u ? -across : across;
}
