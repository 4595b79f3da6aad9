#include "fx_alpha.h"
#include "fx_blend.h"
#include "fx_wide.h"

#define OPAQUE ((uint32_t)255 << 16)

/* ---- Equation 9 ----------------------------------------------------------- */

static uint32_t beyond_cutoff(const fx_alpha *of, uint32_t opacity)
{
    return opacity > of->cutoff << 16;
}

/* opacity * slope / 2^16 to nearest, limited to 1. Both factors have 8 whole bits, so that the
   product's upper half is that with 16 fraction bits. */
static uint32_t sloped(uint32_t opacity, uint32_t slope)
{
    uint32_t product = fx_high_product(opacity << 8, slope << 8);
    return product < OPAQUE ? product : OPAQUE;
}

/* fx_hits for a bump of 1: at most the period, as the fraction is below 1. */
static uint32_t hits_of_fraction(const fx_alpha *of, uint32_t opacity)
{
    return (of->period.slices * (opacity & 0xFFFFu) + 32768u) >> 16;
}

/* For opacity 1 nothing hits. */
uint32_t fx_alpha_random(const fx_alpha *of, uint32_t opacity, uint32_t u)
{
    if (beyond_cutoff(of, opacity))
        return fx_alpha_rounded(opacity);
    uint32_t wanted = sloped(opacity, of->slope[0]);
    return (wanted >> 16) + fx_hit_random(&of->period, hits_of_fraction(of, wanted), u);
}

uint32_t fx_alpha_ordered(const fx_alpha *of, uint32_t opacity, uint32_t phase)
{
    if (beyond_cutoff(of, opacity))
        return fx_alpha_rounded(opacity);
    uint32_t wanted = sloped(opacity, of->slope[0]);
    return (wanted >> 16) + fx_hit_ordered(&of->period, hits_of_fraction(of, wanted), phase);
}

/* ---- Bumps ---------------------------------------------------------------- */

/* A base, and what some slices of a period have more. */
typedef struct mixture {
    uint32_t base, bump, hits;
} mixture;

/* The first slope holds while the value is below fx_plateau of the whole opacity, at least
   1: while whole * (255 - value) is above 127. */
static uint32_t slope_at(const fx_alpha *of, uint32_t opacity, uint32_t value)
{
    uint32_t whole = opacity >> 16 == 0 ? 1u : opacity >> 16;
    return of->slope[whole * (255u - value) <= 127u];
}

static mixture bumped(const fx_alpha *of, uint32_t opacity, uint32_t value)
{
    mixture m = {fx_alpha_rounded(opacity), 0, 0};
    if (beyond_cutoff(of, opacity))
        return m;
    uint32_t wanted = sloped(opacity, slope_at(of, opacity, value));
    m.base = wanted >> 16;
    m.bump = fx_bump(value, m.base);
    m.hits = fx_hits(&of->period, wanted, m.base, m.bump);
    return m;
}

uint32_t fx_alpha_bumped_random(const fx_alpha *of, uint32_t opacity, uint32_t u, uint32_t value)
{
    mixture m = bumped(of, opacity, value);
    return m.base + (fx_hit_random(&of->period, m.hits, u) ? m.bump : 0);
}

uint32_t fx_alpha_bumped(const fx_alpha *of, uint32_t opacity, uint32_t phase, uint32_t value)
{
    mixture m = bumped(of, opacity, value);
    return m.base + (fx_hit_ordered(&of->period, m.hits, phase) ? m.bump : 0);
}

/* ---- Corrected ------------------------------------------------------------ */

static uint32_t distance(uint32_t a, uint32_t b)
{
    return a < b ? b - a : a - b;
}

/* The greatest opacity, 0 .. 255, whose product with the span is at most `most`. */
static uint32_t greatest_within(uint32_t most, uint32_t span)
{
    uint32_t opacity = 0;
    for (uint32_t step = 128; step != 0; step >>= 1)
        if ((opacity + step) * span <= most)
            opacity += step;
    return opacity;
}

/*
 * The rounded blend moves the value by round(a * span / 255) towards the colour; there are no
 * ties, so this is the wanted change where |a * span - 255 change| <= 127. Some a does it:
 * fx_blend_dithered stays between value and colour, so 255 change / span is at most 255, and
 * rounded it is off by at most span / 2 < 128 when multiplied.
 */
uint32_t fx_alpha_corrected(uint32_t opacity, uint32_t colour, uint32_t value, uint32_t u)
{
    uint32_t exact = fx_opacity_q23(fx_opacity_of_level(opacity));
    uint32_t light = fx_light_of_colour(colour, exact);
    uint32_t change = 255u * distance(fx_blend_dithered(value, light, exact, u, 0), value);
    uint32_t span = distance(colour, value);
    uint32_t rounded = fx_alpha_rounded(opacity);
    if (rounded * span > change + 127u)
        return greatest_within(change + 127u, span);
    if (rounded * span + 127u < change) /* so change >= 255 */
        return greatest_within(change - 128u, span) + 1u;
    return rounded;
}
