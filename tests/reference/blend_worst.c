#include "blend_worst.h"

#include "fx_alpha.h"
#include "fx_blend.h"
#include "fx_dither.h"

#include <math.h>
#include <string.h>

#define PHASES_MOST 64

/* A slice in all the units that blends take it in. */
typedef struct slice {
    uint32_t opacity8, opacity12, opacity23, opacity32;
    uint32_t colour, light, light32;
    uint32_t u; /* dither value */
} slice;

typedef uint32_t blended(uint32_t state, const slice *of, uint32_t u);

/* ---- Blends --------------------------------------------------------------- */

static uint32_t rounded_share(uint32_t colour, uint32_t full)
{
    return (2 * colour * full + 255) / 510;
}

FX_INLINE uint32_t plain_5(uint32_t state, const slice *of, uint32_t u)
{
    (void)u;
    return fx_blend_plain(state, rounded_share(of->colour, 31), of->opacity8, 8);
}

FX_INLINE uint32_t plain_6(uint32_t state, const slice *of, uint32_t u)
{
    (void)u;
    return fx_blend_plain(state, rounded_share(of->colour, 63), of->opacity8, 8);
}

FX_INLINE uint32_t plain_8(uint32_t state, const slice *of, uint32_t u)
{
    (void)u;
    return fx_blend_plain(state, of->colour, of->opacity8, 8);
}

FX_INLINE uint32_t associated_8(uint32_t state, const slice *of, uint32_t u)
{
    (void)u;
    return fx_blend_associated(state, fx_divide_by_ones(of->colour * of->opacity8, 8), of->opacity8,
                               8);
}

FX_INLINE uint32_t associated_12(uint32_t state, const slice *of, uint32_t u)
{
    const uint32_t colour = rounded_share(of->colour, 4095);
    (void)u;
    return fx_blend_associated(state, fx_divide_by_ones(colour * of->opacity12, 12), of->opacity12,
                               12);
}

FX_INLINE uint32_t dithered_5(uint32_t state, const slice *of, uint32_t u)
{
    return fx_blend_dithered(state, fx_light_narrow(of->light, FX_FACTOR_5), of->opacity23, u, 0);
}

FX_INLINE uint32_t dithered_6(uint32_t state, const slice *of, uint32_t u)
{
    return fx_blend_dithered(state, fx_light_narrow(of->light, FX_FACTOR_6), of->opacity23, u, 0);
}

FX_INLINE uint32_t dithered_8(uint32_t state, const slice *of, uint32_t u)
{
    return fx_blend_dithered(state, of->light, of->opacity23, u, 0);
}

FX_INLINE uint32_t dithered_8_4(uint32_t state, const slice *of, uint32_t u)
{
    return fx_blend_dithered(state, of->light, of->opacity23, u, 4);
}

FX_INLINE uint32_t dithered_8_8(uint32_t state, const slice *of, uint32_t u)
{
    return fx_blend_dithered(state, of->light, of->opacity23, u, 8);
}

FX_INLINE uint32_t rounded_8_16(uint32_t state, const slice *of, uint32_t u)
{
    (void)u;
    return fx_blend_8_16(state, of->light32, of->opacity32, FX_NO_DITHER);
}

/* ---- One case ------------------------------------------------------------- */

typedef struct run {
    const ref_slice_case *slices;
    slice slice[REF_SLICES_MOST];
    unsigned phases;
} run;

/* A state as it is shown, which has 8 bits or fewer. */
FX_INLINE double shown(uint32_t state, uint32_t full, unsigned fraction)
{
    if (fraction != 0)
        return fx_level_of(state, fraction);
    return full > 255 ? floor(state * 255. / full + .5) : state * 255. / full;
}

/* The largest deviation after any slice, in all phases at once. */
FX_INLINE double deviation(const run *r, blended *blend, uint32_t full, unsigned fraction,
                           unsigned phases)
{
    const ref_slice_case *slices = r->slices;
    uint32_t state[PHASES_MOST];
    double worst = 0;
    for (unsigned phase = 0; phase < phases; phase++)
        state[phase] = rounded_share(slices->start, full) << fraction;
    for (uint32_t n = 0; n < slices->count; n++) {
        uint32_t least = UINT32_MAX, most = 0;
        for (unsigned phase = 0; phase < phases; phase++) {
            const uint32_t u = r->slice[n].u + (uint32_t)(((uint64_t)phase << 32) / phases);
            state[phase] = blend(state[phase], &r->slice[n], u);
            least = state[phase] < least ? state[phase] : least;
            most = state[phase] > most ? state[phase] : most;
        }
        worst = fmax(worst, shown(most, full, fraction) - slices->over[n]);
        worst = fmax(worst, slices->over[n] - shown(least, full, fraction));
    }
    return worst;
}

static double plain(const run *r, ref_state state)
{
    switch (state) {
    case REF_STATE_5:
        return deviation(r, plain_5, 31, 0, 1);
    case REF_STATE_6:
        return deviation(r, plain_6, 63, 0, 1);
    case REF_STATE_8:
        return fmax(deviation(r, plain_8, 255, 0, 1), deviation(r, associated_8, 255, 0, 1));
    case REF_STATE_8_4:
        return deviation(r, associated_12, 4095, 0, 1);
    default:
        return 0;
    }
}

static double dithered(const run *r, ref_state state)
{
    switch (state) {
    case REF_STATE_5:
        return deviation(r, dithered_5, 31, 0, r->phases);
    case REF_STATE_6:
        return deviation(r, dithered_6, 63, 0, r->phases);
    case REF_STATE_8:
        return deviation(r, dithered_8, 255, 0, r->phases);
    case REF_STATE_8_4:
        return deviation(r, dithered_8_4, 255, 4, r->phases);
    case REF_STATE_8_8:
        return deviation(r, dithered_8_8, 255, 8, r->phases);
    default:
        return 0;
    }
}

/* ---- All cases ------------------------------------------------------------ */

typedef struct measurement {
    run run;
    ref_effort effort;
    unsigned number; /* of the case */
    ref_worst (*worst)[REF_ROUNDINGS];
} measurement;

static void prepare(slice *s, const ref_slice_case *slices, uint32_t n)
{
    s->opacity32 = slices->opacity[n];
    s->opacity23 = fx_opacity_q23(s->opacity32);
    s->opacity8 = fx_alpha_rounded(fx_high_product(s->opacity32, 255u << 16));
    s->opacity12 = (fx_high_product(s->opacity32, 4095u << 16) + 32768u) >> 16;
    s->colour = slices->colour[n];
    s->light = fx_light_of_colour(s->colour, s->opacity23);
    s->light32 = fx_light_of_colour32(s->colour, s->opacity32);
}

static void keep(ref_worst *worst, ref_slice_kind kind, double deviation)
{
    worst->any = fmax(worst->any, deviation);
    if (kind == REF_SLICES_CONSTANT)
        worst->fog = fmax(worst->fog, deviation);
}

static void visit(void *user, const ref_slice_case *slices)
{
    static uint32_t (*const sequences[REF_ROUNDINGS])(uint32_t) = {
        NULL, fx_dither_golden, fx_dither_hash, fx_dither_blocks};
    measurement *m = user;
    run *r = &m->run;
    if (m->number++ % m->effort.every != 0)
        return;
    r->slices = slices;
    for (uint32_t n = 0; n < slices->count; n++)
        prepare(&r->slice[n], slices, n);
    for (unsigned state = 0; state < REF_STATE_8_8; state++)
        keep(&m->worst[state][REF_ROUNDING_PLAIN], slices->kind, plain(r, (ref_state)state));
    for (unsigned rounding = REF_ROUNDING_GOLDEN; rounding < REF_ROUNDINGS; rounding++) {
        for (uint32_t n = 0; n < slices->count; n++)
            r->slice[n].u = sequences[rounding](slices->index[n]);
        for (unsigned state = 0; state < REF_STATE_8_16; state++)
            keep(&m->worst[state][rounding], slices->kind, dithered(r, (ref_state)state));
    }
    keep(&m->worst[REF_STATE_8_16][REF_ROUNDING_PLAIN], slices->kind,
         deviation(r, rounded_8_16, 255, 16, 1));
}

void ref_blend_worst(ref_worst worst[REF_STATES][REF_ROUNDINGS], const ref_slice_limits *limits,
                     const ref_effort *effort)
{
    static measurement m;
    memset(worst, 0, sizeof(ref_worst[REF_STATES][REF_ROUNDINGS]));
    m.effort = *effort;
    m.number = 0;
    m.worst = worst;
    m.run.phases = effort->phases;
    ref_each_slice_case_within(visit, &m, limits);
}
