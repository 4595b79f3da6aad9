/*
 * How far blends in few bits lie from exact ones: over all kinds of slices and 16 phases
 * of the dither, after every slice, in levels of 8 bits as they are shown. The bounds are
 * what was reached, also on denser grids of opacities, colours and phases, rounded up.
 */
#include "check.h"
#include "fx_blend.h"
#include "fx_dither.h"
#include "slice_cases.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>

#define PHASES 16

/* A slice in all the units that blends take it in. */
typedef struct slice {
    uint32_t colour;
    uint32_t opacity8, opacity23, opacity32;
    uint32_t light, light32;
    uint32_t before, after; /* transmittance on either side, front to back */
} slice;

typedef struct technique {
    const char *name;
    uint32_t (*blend)(uint32_t state, const slice *of, uint32_t u);
    uint32_t (*dither)(uint32_t index);
    unsigned fraction; /* of the state */
    uint32_t full;     /* of the state; 0: 255 and the fraction */
    bool front_to_back;
    double most[REF_SLICE_KINDS]; /* levels off */
} technique;

/* ---- Blends --------------------------------------------------------------- */

static uint32_t plain(uint32_t state, const slice *of, uint32_t u)
{
    (void)u;
    return fx_blend_plain(state, of->colour, of->opacity8, 8);
}

static uint32_t dithered_5(uint32_t state, const slice *of, uint32_t u)
{
    return fx_blend_dithered(state, fx_light_narrow(of->light, FX_FACTOR_5), of->opacity23, u, 0);
}

static uint32_t dithered_6(uint32_t state, const slice *of, uint32_t u)
{
    return fx_blend_dithered(state, fx_light_narrow(of->light, FX_FACTOR_6), of->opacity23, u, 0);
}

static uint32_t dithered_8(uint32_t state, const slice *of, uint32_t u)
{
    return fx_blend_dithered(state, of->light, of->opacity23, u, 0);
}

static uint32_t dithered_8_4(uint32_t state, const slice *of, uint32_t u)
{
    return fx_blend_dithered(state, of->light, of->opacity23, u, 4);
}

static uint32_t dithered_8_8(uint32_t state, const slice *of, uint32_t u)
{
    return fx_blend_dithered(state, of->light, of->opacity23, u, 8);
}

static uint32_t rounded_8_16(uint32_t state, const slice *of, uint32_t u)
{
    (void)u;
    return fx_blend_8_16(state, of->light32, of->opacity32, FX_NO_DITHER);
}

static uint32_t front_colour_8(uint32_t state, const slice *of, uint32_t u)
{
    (void)u;
    return fx_front_colour(state, of->colour, of->before, of->after, 0);
}

static uint32_t front_colour_8_8(uint32_t state, const slice *of, uint32_t u)
{
    (void)u;
    return fx_front_colour(state, of->colour, of->before, of->after, 8);
}

static uint32_t front_light_8(uint32_t state, const slice *of, uint32_t u)
{
    return fx_front_light(state, of->light32, of->before, of->after, u, 0);
}

static uint32_t front_light_8_8(uint32_t state, const slice *of, uint32_t u)
{
    return fx_front_light(state, of->light32, of->before, of->after, u, 8);
}

static uint32_t front_light_8_16(uint32_t state, const slice *of, uint32_t u)
{
    (void)u;
    return fx_front_light(state, of->light32, of->before, of->after, FX_NO_DITHER, 16);
}

/* ---- Cases ---------------------------------------------------------------- */

typedef struct measurement {
    const technique *of;
    double worst[REF_SLICE_KINDS], squares[REF_SLICE_KINDS], count[REF_SLICE_KINDS];
    ref_slice_case farthest; /* of all kinds that miss their bound: the case, for the message */
    bool missed;
} measurement;

static slice slice_of(const ref_slice_case *slices, uint32_t n, uint32_t before)
{
    slice s = {slices->colour[n], 0, 0, slices->opacity[n], 0, 0, before, 0};
    s.opacity8 = (uint32_t)(((uint64_t)s.opacity32 * 255 + 0x80000000u) >> 32);
    s.opacity23 = fx_opacity_q23(s.opacity32);
    s.light = fx_light_of_colour(s.colour, s.opacity23);
    s.light32 = fx_light_of_colour32(s.colour, s.opacity32);
    s.after = fx_transmit(before, s.opacity32);
    return s;
}

static uint32_t first_state(const technique *of, const ref_slice_case *slices)
{
    if (of->front_to_back)
        return 0;
    return of->full == 0 ? slices->start << of->fraction : (slices->start * of->full + 127) / 255;
}

static double shown_level(const technique *of, uint32_t state)
{
    if (of->full != 0)
        return state * 255.0 / of->full;
    return of->fraction == 0 ? state : fx_level_of(state, of->fraction);
}

/* A case in all phases at once. */
static void measure(void *user, const ref_slice_case *slices)
{
    measurement *m = user;
    const technique *of = m->of;
    const double *exact = of->front_to_back ? slices->under : slices->over;
    const unsigned phases = of->dither == NULL ? 1 : PHASES;
    uint32_t state[PHASES], transmittance = FX_CLEAR_Q24;
    double worst = 0, squares = 0;
    for (unsigned phase = 0; phase < phases; phase++)
        state[phase] = first_state(of, slices);
    for (uint32_t n = 0; n < REF_SLICES; n++) {
        const slice s = slice_of(slices, n, transmittance);
        const uint32_t u = of->dither == NULL ? 0 : of->dither(slices->index[n]);
        for (unsigned phase = 0; phase < phases; phase++) {
            state[phase] = of->blend(state[phase], &s, u + (phase << 28));
            const double off = fabs(shown_level(of, state[phase]) - exact[n]);
            worst = off > worst ? off : worst;
            squares += off * off;
        }
        transmittance = s.after;
    }
    m->squares[slices->kind] += squares;
    m->count[slices->kind] += (double)phases * REF_SLICES;
    if (worst > of->most[slices->kind] && worst > m->worst[slices->kind]) {
        m->farthest = *slices;
        m->missed = true;
    }
    m->worst[slices->kind] = fmax(m->worst[slices->kind], worst);
}

static void check_technique(const technique *of)
{
    static measurement m;
    m = (measurement){.of = of};
    ref_each_slice_case(measure, &m);
    printf("# %-32s", of->name);
    for (unsigned kind = 0; kind < REF_SLICE_KINDS; kind++)
        printf(" %8.2f /%6.2f", m.worst[kind], sqrt(m.squares[kind] / m.count[kind]));
    printf("\n");
    if (m.missed)
        fail_msg("%s: %s, opacity %g, parameter %u, beyond its bound", of->name,
                 ref_slice_kind_names[m.farthest.kind], m.farthest.named, m.farthest.parameter);
}

static void print_head(void)
{
    printf("# %-32s", "levels off, worst / RMS");
    for (unsigned kind = 0; kind < REF_SLICE_KINDS; kind++)
        printf(" %16s", ref_slice_kind_names[kind]);
    printf("\n");
}

static void check_all(const technique *techniques, size_t count)
{
    print_head();
    for (size_t i = 0; i < count; i++)
        check_technique(&techniques[i]);
}

#define CHECK_ALL(techniques) check_all(techniques, sizeof(techniques) / sizeof *(techniques))

/* Bounds in the order of ref_slice_kind: constant, sparse, random, gaps, two fogs, surface,
   ramp. */

static void strictly_8_bits(void **state)
{
    static const technique techniques[] = {
        {"8 bits, plain", plain, NULL, 0, 0, false, {219, 160, 155, 180, 160, 160, 160}},
        {"8 bits, golden ratio",
         dithered_8,
         fx_dither_golden,
         0,
         0,
         false,
         {5.5, 150, 22, 25, 8, 5, 6}},
        {"8 bits, hash", dithered_8, fx_dither_hash, 0, 0, false, {24, 34, 27, 29, 29, 23, 24}},
        {"8 bits, blocks",
         dithered_8,
         fx_dither_blocks,
         0,
         0,
         false,
         {5.5, 31, 21, 25, 13.5, 5.5, 6.6}},
    };
    (void)state;
    CHECK_ALL(techniques);
}

static void of_5_and_6_bits(void **state)
{
    static const technique techniques[] = {
        {"5 bits, blocks",
         dithered_5,
         fx_dither_blocks,
         0,
         31,
         false,
         {25.5, 105, 80, 82, 72, 29, 26}},
        {"6 bits, blocks",
         dithered_6,
         fx_dither_blocks,
         0,
         63,
         false,
         {15.5, 72, 52, 52, 46, 17, 17.5}},
    };
    (void)state;
    CHECK_ALL(techniques);
}

static void with_residual_or_16_bits(void **state)
{
    static const technique techniques[] = {
        {"8.4, blocks",
         dithered_8_4,
         fx_dither_blocks,
         4,
         0,
         false,
         {1.1, 4.8, 2.6, 3.2, 1.8, 1.15, 1.4}},
        {"8.8, golden ratio",
         dithered_8_8,
         fx_dither_golden,
         8,
         0,
         false,
         {.6, 1.7, .65, .67, .62, .57, .63}},
        {"8.8, hash", dithered_8_8, fx_dither_hash, 8, 0, false, {.7, .73, .7, .7, .7, .68, .68}},
        {"8.8, blocks",
         dithered_8_8,
         fx_dither_blocks,
         8,
         0,
         false,
         {.6, .73, .65, .67, .61, .58, .58}},
    };
    (void)state;
    CHECK_ALL(techniques);
}

static void of_24_bits(void **state)
{
    static const technique techniques[] = {
        {"8.16", rounded_8_16, NULL, 16, 0, false, {.51, .51, .51, .51, .51, .51, .51}},
    };
    (void)state;
    CHECK_ALL(techniques);
}

static void front_to_back(void **state)
{
    static const technique techniques[] = {
        {"front to back, 8 bits, colour",
         front_colour_8,
         NULL,
         0,
         0,
         true,
         {.51, .51, 28, .51, 33, 3, .51}},
        {"front to back, 8.8, colour",
         front_colour_8_8,
         NULL,
         8,
         0,
         true,
         {.51, .51, .65, .51, .68, .52, .51}},
        {"front to back, 8 bits, light",
         front_light_8,
         fx_dither_blocks,
         0,
         0,
         true,
         {9, 48, 25, 42, 25, 9, 9}},
        {"front to back, 8.8, light",
         front_light_8_8,
         fx_dither_blocks,
         8,
         0,
         true,
         {.62, .75, .68, .72, .66, .62, .62}},
        {"front to back, 8.16, light",
         front_light_8_16,
         NULL,
         16,
         0,
         true,
         {.51, .51, .51, .51, .51, .51, .51}},
    };
    (void)state;
    CHECK_ALL(techniques);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strictly_8_bits),
        cmocka_unit_test(of_5_and_6_bits),
        cmocka_unit_test(with_residual_or_16_bits),
        cmocka_unit_test(of_24_bits),
        cmocka_unit_test(front_to_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
