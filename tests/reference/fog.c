#include "fog.h"

#include "fx_alpha.h"
#include "fx_blend.h"

#include <math.h>

/* To nearest. */
static uint32_t rounded(double value)
{
    return (uint32_t)floor(value + .5);
}

/* ---- Rounded blends --------------------------------------------------------- */

static void accumulate_plain(double *levels, uint32_t count, double opacity, unsigned bits)
{
    const uint32_t full = ((uint32_t)1 << bits) - 1u;
    const uint32_t given = rounded(opacity / 255 * full);
    uint32_t value = 0;
    for (uint32_t n = 1; n <= count; n++) {
        value = fx_blend_plain(value, full, given, bits);
        levels[n] = 255. * value / full;
    }
}

/* ---- The paper's dithers ------------------------------------------------------ */

uint32_t ref_fog_dithered(const ref_fog *fog, uint32_t slice, uint32_t value)
{
    const fx_alpha how = {fx_period_of(REF_FOG_PERIOD),
                          {rounded(fog->slope[0] * 65536), rounded(fog->slope[1] * 65536)},
                          255};
    const uint32_t opacity = rounded(fog->opacity * 65536);
    const uint32_t u = fx_dither_at(fx_dither_hash(slice), fog->pixel, 0, 0);
    const uint32_t phase = (slice + fog->pixel) % REF_FOG_PERIOD;
    if (fog->technique == REF_FOG_RANDOM) {
        return fog->bumping ? fx_alpha_bumped_random(&how, opacity, u, value)
                            : fx_alpha_random(&how, opacity, u);
    }
    return fog->bumping ? fx_alpha_bumped(&how, opacity, phase, value)
                        : fx_alpha_ordered(&how, opacity, phase);
}

static void accumulate_hits(double *levels, uint32_t count, const ref_fog *fog)
{
    uint32_t value = 0;
    for (uint32_t n = 0; n < count; n++) {
        value = fx_blend_plain(value, 255, ref_fog_dithered(fog, n, value), 8);
        levels[n + 1] = value;
    }
}

/* ---- Dithered rounding -------------------------------------------------------- */

static void accumulate_dithered(double *levels, uint32_t count, const ref_fog *fog,
                                unsigned fraction)
{
    const uint32_t opacity = rounded(fog->opacity / 255 * FX_ONE_Q23);
    const uint32_t light = fx_light_of_colour(255, opacity);
    uint32_t state = 0;
    for (uint32_t n = 0; n < count; n++) {
        const uint32_t u = fx_dither_at(fx_dither_blocks(n), fog->pixel, 0, 0);
        state = fx_blend_dithered(state, light, opacity, u, fraction);
        levels[n + 1] = ldexp(state, -(int)fraction);
    }
}

void ref_fog_accumulate(double *levels, uint32_t count, const ref_fog *fog)
{
    levels[0] = 0;
    switch (fog->technique) {
    case REF_FOG_PLAIN:
        accumulate_plain(levels, count, fog->opacity, 8);
        break;
    case REF_FOG_PLAIN_12:
        accumulate_plain(levels, count, fog->opacity, 12);
        break;
    case REF_FOG_ORDERED:
    case REF_FOG_RANDOM:
        accumulate_hits(levels, count, fog);
        break;
    case REF_FOG_ROUNDING:
        accumulate_dithered(levels, count, fog, 0);
        break;
    case REF_FOG_ROUNDING_8_4:
        accumulate_dithered(levels, count, fog, 4);
        break;
    case REF_FOG_ROUNDING_8_8:
        accumulate_dithered(levels, count, fog, 8);
        break;
    }
}

/* ---- Errors --------------------------------------------------------------------- */

double ref_fog_exact(double opacity, uint32_t slices)
{
    return 255 * (1 - pow(1 - opacity / 255, slices));
}

double ref_fog_deviation(const double *levels, uint32_t count, double opacity)
{
    double worst = 0;
    for (uint32_t n = 0; n <= count; n++) {
        worst = fmax(worst, fabs(levels[n] - ref_fog_exact(opacity, n)));
    }
    return worst;
}

double ref_fog_over(double near, double far)
{
    return near + (1 - near / 255) * far;
}

double ref_fog_brick_error(const double *levels, uint32_t count, uint32_t n)
{
    return 100 * (ref_fog_over(levels[n], levels[count - n]) / levels[count] - 1);
}

double ref_fog_seam(const double *levels, uint32_t count)
{
    double worst = 0;
    for (uint32_t n = 0; n <= count; n++) {
        const double error = ref_fog_brick_error(levels, count, n);
        if (fabs(error) > fabs(worst))
            worst = error;
    }
    return worst;
}
