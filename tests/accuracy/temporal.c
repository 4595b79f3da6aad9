/*
 * The phase of the dither advances from frame to frame: how far the mean of 4096 frames is
 * from exact blending (bias), how far that of as many in a row as a period has (mean), and
 * the largest difference between frames (flicker). Fogs of constant opacity and colour over
 * black, one pixel, in levels of 8 bits as they are shown.
 */
#include "check.h"
#include "blend.h"
#include "fx_alpha.h"
#include "fx_blend.h"
#include "fx_dither.h"

#include <math.h>
#include <stdio.h>

#define ONE       65536u
#define PERIOD    32
#define FRAMES    4096
#define READ_OUTS 3

/* After so many slices the level is read. */
static const uint32_t read_outs[READ_OUTS] = {50, 200, 1000};

/* A number of a slice near the middle of a volume, as the renderer counts them. */
#define MIDDLE 0x400000u

/* A fog in all the units that blends take it in. */
typedef struct fog {
    double level;
    uint32_t colour;
    uint32_t opacity, opacity23, opacity32; /* the first a level with 16 fraction bits */
} fog;

/* A slice's place in the period and its dither value, of a frame. */
typedef struct moment {
    uint32_t place;
    uint32_t u;
} moment;

typedef struct technique {
    const char *name;
    uint32_t (*blend)(uint32_t state, const fog *of, const moment *at);
    uint32_t (*dither)(uint32_t slice);
    unsigned fraction;
    double most[3]; /* bias, mean, flicker */
} technique;

/* ---- Techniques ----------------------------------------------------------- */

/* Of fx_period_of(PERIOD): 2^18 / 32. */
static const fx_alpha simple = {{PERIOD, 8192}, {ONE, ONE}, 255};

static uint32_t rounded(uint32_t state, const fog *of, const moment *at)
{
    (void)at;
    return fx_blend_plain(state, of->colour, fx_alpha_rounded(of->opacity), 8);
}

static uint32_t at_random(uint32_t state, const fog *of, const moment *at)
{
    return fx_blend_plain(state, of->colour, fx_alpha_random(&simple, of->opacity, at->u), 8);
}

static uint32_t ordered(uint32_t state, const fog *of, const moment *at)
{
    return fx_blend_plain(state, of->colour, fx_alpha_ordered(&simple, of->opacity, at->place), 8);
}

static uint32_t bumped(uint32_t state, const fog *of, const moment *at)
{
    const uint32_t value = 255 - (of->colour - state); /* never above the colour */
    const uint32_t opacity = fx_alpha_bumped(&simple, of->opacity, at->place, value);
    return fx_blend_plain(state, of->colour, opacity, 8);
}

static uint32_t corrected(uint32_t state, const fog *of, const moment *at)
{
    return fx_blend_plain(state, of->colour,
                          fx_alpha_corrected(of->opacity, of->colour, state, at->u), 8);
}

static uint32_t dithered(uint32_t state, const fog *of, uint32_t u, unsigned fraction)
{
    return fx_blend_dithered(state, of->colour * of->opacity23, of->opacity23, u, fraction);
}

static uint32_t dithered_8(uint32_t state, const fog *of, const moment *at)
{
    return dithered(state, of, at->u, 0);
}

static uint32_t dithered_8_4(uint32_t state, const fog *of, const moment *at)
{
    return dithered(state, of, at->u, 4);
}

static uint32_t dithered_8_8(uint32_t state, const fog *of, const moment *at)
{
    return dithered(state, of, at->u, 8);
}

static uint32_t rounded_8_16(uint32_t state, const fog *of, const moment *at)
{
    (void)at;
    return fx_blend_8_16(state, fx_light_of_colour32(of->colour, of->opacity32), of->opacity32,
                         FX_NO_DITHER);
}

/* ---- Frames --------------------------------------------------------------- */

/* levels[r][frame] as shown after read_outs[r] slices. */
typedef double film[READ_OUTS][FRAMES];

/* As qv_slice makes it, of the pixel (0, 0). */
static moment moment_of(const technique *by, uint32_t n, uint32_t frame)
{
    const uint32_t slice = MIDDLE - n, shift = fx_dither_at(0, 0, 0, frame);
    moment at = {qv_phase_shifted(&simple.period, slice % PERIOD, shift), 0};
    if (by->dither != NULL)
        at.u = by->dither(slice) + shift;
    return at;
}

static void render(film levels, uint32_t frame, const technique *by, const fog *of)
{
    uint32_t state = 0, n = 0;
    for (unsigned r = 0; r < READ_OUTS; r++) {
        for (; n < read_outs[r]; n++) {
            const moment at = moment_of(by, n, frame);
            state = by->blend(state, of, &at);
        }
        levels[r][frame] = by->fraction == 0 ? state : fx_level_of(state, by->fraction);
    }
}

typedef struct measures {
    double bias, mean, flicker;
} measures;

/* Sums over a period move along: exact, as they are of integers. */
static measures measure_row(const double *levels, double exact)
{
    double all = 0, some = 0, low = levels[0], high = levels[0];
    measures m = {0, 0, 0};
    for (uint32_t f = 0; f < FRAMES; f++) {
        all += levels[f];
        some += levels[f] - (f < PERIOD ? 0 : levels[f - PERIOD]);
        low = fmin(low, levels[f]);
        high = fmax(high, levels[f]);
        if (f + 1 >= PERIOD)
            m.mean = fmax(m.mean, fabs(some / PERIOD - exact));
    }
    m.bias = fabs(all / FRAMES - exact);
    m.flicker = high - low;
    return m;
}

static void add_fog(measures *worst, const technique *by, const fog *of)
{
    static film levels;
    for (uint32_t frame = 0; frame < FRAMES; frame++)
        render(levels, frame, by, of);
    for (unsigned r = 0; r < READ_OUTS; r++) {
        const double exact = of->colour * (1 - pow(1 - of->level / 255, read_outs[r]));
        const measures m = measure_row(levels[r], exact);
        worst->bias = fmax(worst->bias, m.bias);
        worst->mean = fmax(worst->mean, m.mean);
        worst->flicker = fmax(worst->flicker, m.flicker);
    }
}

static void check_technique(const technique *by)
{
    static const double levels[] = {.03, .1, .25, .5, .75, 1, 1.5, 2.3, 5, 20};
    static const uint32_t colours[] = {255, 100};
    measures worst = {0, 0, 0};
    for (unsigned i = 0; i < 2 * sizeof levels / sizeof *levels; i++) {
        const double level = levels[i / 2];
        fog of = {level, colours[i % 2], (uint32_t)(level * ONE + .5), 0,
                  (uint32_t)(level / 255 * UINT32_MAX + .5)};
        of.opacity23 = fx_opacity_q23(of.opacity32);
        add_fog(&worst, by, &of);
    }
    printf("# %-24s bias %6.2f, mean of %u frames %6.2f, flicker %3.0f\n", by->name, worst.bias,
           PERIOD, worst.mean, worst.flicker);
    if (worst.bias > by->most[0] || worst.mean > by->most[1] || worst.flicker > by->most[2])
        fail_msg("%s: beyond its bounds", by->name);
}

static void check_all(const technique *techniques, size_t count)
{
    for (size_t i = 0; i < count; i++)
        check_technique(&techniques[i]);
}

#define CHECK_ALL(techniques) check_all(techniques, sizeof(techniques) / sizeof *(techniques))

static void of_hardware(void **state)
{
    static const technique techniques[] = {
        {"rounded", rounded, NULL, 0, {160, 160, 0}},
        {"random, hash", at_random, fx_dither_hash, 0, {122, 122, 38}},
        {"ordered", ordered, NULL, 0, {122, 122, 1}},
        {"bumped", bumped, NULL, 0, {122, 122, 2}},
        {"corrected, golden ratio", corrected, fx_dither_golden, 0, {.52, 2.4, 6}},
        {"corrected, hash", corrected, fx_dither_hash, 0, {.35, 1.6, 41}},
        {"corrected, blocks", corrected, fx_dither_blocks, 0, {.55, .8, 8}},
    };
    (void)state;
    CHECK_ALL(techniques);
}

/*
 * Wanted is a bias of .25. Dither whose values lie evenly runs ahead by up to half a level: the
 * rest that a rounding leaves is kept by the order of the values, not by the pixel, which so
 * blends as if there were none.
 */
static void of_8_bits(void **state)
{
    static const technique techniques[] = {
        {"8 bits, golden ratio", dithered_8, fx_dither_golden, 0, {.52, 2.4, 6}},
        {"8 bits, hash", dithered_8, fx_dither_hash, 0, {.35, 1.6, 41}},
        {"8 bits, blocks", dithered_8, fx_dither_blocks, 0, {.55, .8, 8}},
    };
    (void)state;
    CHECK_ALL(techniques);
}

/* Read out to nearest: half a level is that. */
static void of_more_bits(void **state)
{
    static const technique techniques[] = {
        {"8.4, blocks", dithered_8_4, fx_dither_blocks, 4, {.5, .51, 1}},
        {"8.8, golden ratio", dithered_8_8, fx_dither_golden, 8, {.5, .51, 1}},
        {"8.8, hash", dithered_8_8, fx_dither_hash, 8, {.5, .51, 1}},
        {"8.8, blocks", dithered_8_8, fx_dither_blocks, 8, {.5, .51, 1}},
        {"8.16", rounded_8_16, NULL, 16, {.51, .51, 0}},
    };
    (void)state;
    CHECK_ALL(techniques);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(of_hardware),
        cmocka_unit_test(of_8_bits),
        cmocka_unit_test(of_more_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
