#include "pixel.h"

#include "blend.h"
#include "fx_alpha.h"
#include "fx_blend.h"

#include <math.h>
#include <stddef.h>

#define ONE 65536u

/* The period is fx_period_of(REF_PIXEL_PERIOD): 2^18 / 32. */
static const fx_alpha simple = {{REF_PIXEL_PERIOD, 8192}, {ONE, ONE}, 255};

ref_pixel_fog ref_pixel_fog_of(double level, uint32_t colour)
{
    ref_pixel_fog fog = {level, colour, (uint32_t)(level * ONE + .5), 0,
                         (uint32_t)(level / 255 * UINT32_MAX + .5)};
    fog.opacity23 = fx_opacity_q23(fog.opacity32);
    return fog;
}

double ref_pixel_exact(const ref_pixel_fog *fog, uint32_t slices)
{
    return fog->colour * (1 - pow(1 - fog->level / 255, slices));
}

ref_moment ref_moment_of(const ref_pixel_technique *by, uint32_t slice, uint32_t shift)
{
    ref_moment at = {qv_phase_shifted(&simple.period, slice % REF_PIXEL_PERIOD, shift), 0};
    if (by->dither != NULL)
        at.u = by->dither(slice) + shift;
    return at;
}

double ref_pixel_shown(const ref_pixel_technique *by, uint32_t state)
{
    return by->fraction == 0 ? state : fx_level_of(state, by->fraction);
}

/* ---- Opacities of 8 bits ---------------------------------------------------- */

static uint32_t plain(uint32_t state, const ref_pixel_fog *fog, uint32_t opacity)
{
    return fx_blend_plain(state, fog->colour, opacity, 8);
}

uint32_t ref_pixel_rounded(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at)
{
    (void)at;
    return plain(state, fog, fx_alpha_rounded(fog->opacity));
}

uint32_t ref_pixel_random(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at)
{
    return plain(state, fog, fx_alpha_random(&simple, fog->opacity, at->u));
}

uint32_t ref_pixel_ordered(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at)
{
    return plain(state, fog, fx_alpha_ordered(&simple, fog->opacity, at->place));
}

/* Over black the state never passes the colour. */
uint32_t ref_pixel_bumped(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at)
{
    const uint32_t value = 255 - (fog->colour - state);
    return plain(state, fog, fx_alpha_bumped(&simple, fog->opacity, at->place, value));
}

uint32_t ref_pixel_corrected(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at)
{
    return plain(state, fog, fx_alpha_corrected(fog->opacity, fog->colour, state, at->u));
}

/* ---- Blends of light ------------------------------------------------------- */

static uint32_t dithered(uint32_t state, const ref_pixel_fog *fog, uint32_t u, unsigned fraction)
{
    return fx_blend_dithered(state, fx_light_of_colour(fog->colour, fog->opacity23), fog->opacity23,
                             u, fraction);
}

uint32_t ref_pixel_8(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at)
{
    return dithered(state, fog, at->u, 0);
}

uint32_t ref_pixel_8_4(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at)
{
    return dithered(state, fog, at->u, 4);
}

uint32_t ref_pixel_8_8(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at)
{
    return dithered(state, fog, at->u, 8);
}

uint32_t ref_pixel_8_16(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at)
{
    (void)at;
    return fx_blend_8_16(state, fx_light_of_colour32(fog->colour, fog->opacity32), fog->opacity32,
                         FX_NO_DITHER);
}
