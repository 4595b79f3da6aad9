/*
 * How far opacities of 8 bits for blending hardware (fx_alpha.h) lead from exact blending: each
 * technique over all kinds of slices, in 2 to 8 phases of its dither, after every slice, in
 * levels of 8 bits. The bounds are what was reached, rounded up.
 */
#include "check.h"
#include "fx_alpha.h"
#include "fx_blend.h"
#include "slice_cases.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#define ONE        65536u
#define PERIODS    4
#define PHASES_MAX 8
#define CHANNELS   3

static const uint32_t periods[PERIODS] = {8, 16, 32, 64};

/* A slice, and what its dither is made of in one phase. */
typedef struct moment {
    uint32_t opacity; /* level with 16 fraction bits */
    uint32_t opacity32;
    uint32_t u;
    uint32_t place; /* in the period */
} moment;

typedef struct technique {
    const char *name;
    uint32_t (*opacity)(const fx_alpha *of, const moment *at, uint32_t colour, uint32_t value);
    uint32_t (*dither)(uint32_t index);
    uint32_t period; /* 0: has none */
    bool published;  /* slopes */
    unsigned phases;
} technique;

typedef double bounds[REF_SLICE_KINDS]; /* levels off */

/* ---- Techniques ----------------------------------------------------------- */

static uint32_t rounded(const fx_alpha *of, const moment *at, uint32_t colour, uint32_t value)
{
    (void)of, (void)colour, (void)value;
    return fx_alpha_rounded(at->opacity);
}

static uint32_t at_random(const fx_alpha *of, const moment *at, uint32_t colour, uint32_t value)
{
    (void)colour, (void)value;
    return fx_alpha_random(of, at->opacity, at->u);
}

static uint32_t ordered(const fx_alpha *of, const moment *at, uint32_t colour, uint32_t value)
{
    (void)colour, (void)value;
    return fx_alpha_ordered(of, at->opacity, at->place);
}

/* As published: bumps for colour 255. */
static uint32_t bumped_for_255(const fx_alpha *of, const moment *at, uint32_t colour,
                               uint32_t value)
{
    (void)colour;
    return fx_alpha_bumped(of, at->opacity, at->place, value);
}

static uint32_t distance(uint32_t a, uint32_t b)
{
    return a < b ? b - a : a - b;
}

/* Bumps for the slice's own colour. */
static uint32_t bumped(const fx_alpha *of, const moment *at, uint32_t colour, uint32_t value)
{
    return fx_alpha_bumped(of, at->opacity, at->place, 255 - distance(colour, value));
}

static uint32_t corrected(const fx_alpha *of, const moment *at, uint32_t colour, uint32_t value)
{
    (void)of;
    return fx_alpha_corrected(at->opacity, colour, value, at->u);
}

/* Figures 23 to 32: opacity, slopes, and the deviation over 1000 slices as recomputed. */
#define FIGURES 11
static const double figures[FIGURES][4] = {
    {.03, .75, 1, 2.9}, {.1, 1, 1, 10.8},       {.25, .8, .9, 11.5}, {.5, .75, 1, 9.7},
    {.75, .75, 1, 9.7}, {1, .85, .9, 13.3},     {1.1, .85, .9, 14},  {1.25, .8, 1.5, 8.9},
    {1.5, 1, 1.3, 9},   {1.75, 1, 1.686, 26.3}, {2, .9, 1.4, 33}};

static uint32_t q16(double v)
{
    return (uint32_t)(v * ONE + .5);
}

/* Slopes of the figure whose opacity is the nearest by ratio, within a third; else 1. */
static void set_slopes(fx_alpha *of, uint32_t opacity)
{
    const double level = opacity / (double)ONE;
    unsigned nearest = 0;
    of->slope[0] = of->slope[1] = ONE;
    if (level < .02 || level > 3)
        return;
    for (unsigned i = 1; i < FIGURES; i++)
        if (level * level > figures[i][0] * figures[i - 1][0])
            nearest = i;
    of->slope[0] = q16(figures[nearest][1]);
    of->slope[1] = q16(figures[nearest][2]);
}

static fx_alpha alpha_of(const technique *by)
{
    fx_alpha of = {{0, 0}, {ONE, ONE}, 255};
    if (by->period != 0)
        of.period = fx_period_of(by->period);
    return of;
}

static moment moment_of(const technique *by, const ref_slice_case *slices, uint32_t n,
                        unsigned phase)
{
    const uint32_t opacity32 = slices->opacity[n], index = slices->index[n];
    moment at = {fx_high_product(opacity32, 255 * ONE), opacity32, 0, 0};
    if (by->period != 0)
        at.place = (index + phase * by->period / by->phases) % by->period;
    if (by->dither != NULL)
        at.u = by->dither(index) + (phase << 29);
    return at;
}

/* ---- What is measured ----------------------------------------------------- */

typedef struct measurement {
    const technique *by;
    fx_alpha of;
    const double *most;
    double worst[REF_SLICE_KINDS], squares[REF_SLICE_KINDS], count[REF_SLICE_KINDS];
    ref_slice_case farthest; /* of all kinds that miss their bound: the case, for the message */
    bool missed;
} measurement;

static void add(measurement *m, const ref_slice_case *slices, double worst, double squares,
                double count)
{
    const ref_slice_kind kind = slices->kind;
    m->squares[kind] += squares;
    m->count[kind] += count;
    if (worst > m->most[kind] && worst > m->worst[kind]) {
        m->farthest = *slices;
        m->missed = true;
    }
    m->worst[kind] = worst > m->worst[kind] ? worst : m->worst[kind];
}

/* One channel. */
static void measure(void *user, const ref_slice_case *slices)
{
    measurement *m = user;
    const technique *by = m->by;
    uint32_t value[PHASES_MAX];
    double worst = 0, squares = 0;
    for (unsigned phase = 0; phase < by->phases; phase++)
        value[phase] = slices->start;
    for (uint32_t n = 0; n < REF_SLICES; n++)
        for (unsigned phase = 0; phase < by->phases; phase++) {
            const moment at = moment_of(by, slices, n, phase);
            const uint32_t colour = slices->colour[n];
            if (by->published && phase == 0)
                set_slopes(&m->of, at.opacity);
            const uint32_t opacity = by->opacity(&m->of, &at, colour, value[phase]);
            value[phase] = fx_blend_plain(value[phase], colour, opacity, 8);
            const double off = fabs(value[phase] - slices->over[n]);
            worst = off > worst ? off : worst;
            squares += off * off;
        }
    add(m, slices, worst, squares, (double)by->phases * REF_SLICES);
}

static void check(const technique *by, ref_slice_visitor *visit, const double *most)
{
    static measurement m;
    m = (measurement){.by = by, .of = alpha_of(by), .most = most};
    ref_each_slice_case(visit, &m);
    printf("# %-32s", by->name);
    if (by->period == 0)
        printf("   ");
    else
        printf(" %2u", by->period);
    for (unsigned kind = 0; kind < REF_SLICE_KINDS; kind++)
        printf(" %7.2f /%6.2f", m.worst[kind], sqrt(m.squares[kind] / m.count[kind]));
    printf("\n");
    if (m.missed)
        fail_msg("%s: %s, opacity %g, parameter %u, beyond its bound", by->name,
                 ref_slice_kind_names[m.farthest.kind], m.farthest.named, m.farthest.parameter);
}

static void print_head(void)
{
    printf("# %-32s  P", "levels off, worst / RMS");
    for (unsigned kind = 0; kind < REF_SLICE_KINDS; kind++)
        printf(" %15s", ref_slice_kind_names[kind]);
    printf("\n");
}

static void check_periods(technique by, const bounds *most)
{
    for (unsigned i = 0; i < PERIODS; i++) {
        by.period = periods[i];
        check(&by, measure, most[i]);
    }
}

/* ---- One channel ---------------------------------------------------------- */

/* Bounds in the order of ref_slice_kind: constant, sparse, random, gaps, two fogs, surface,
   ramp. Those of several periods in the order of `periods`. */

static void without_dither(void **state)
{
    static const technique by = {"rounded", rounded, NULL, 0, false, 1};
    static const bounds most = {219, 160, 151, 176, 160, 160, 160};
    (void)state;
    print_head();
    check(&by, measure, most);
}

static void simple_dither(void **state)
{
    static const technique random = {"random, hash", at_random, fx_dither_hash, 0, false, 2};
    static const technique in_order = {"ordered", ordered, NULL, 0, false, 2};
    static const bounds most_random[PERIODS] = {{125, 125, 106, 124, 122, 125, 110},
                                                {125, 125, 106, 124, 122, 125, 110},
                                                {125, 125, 106, 124, 122, 125, 110},
                                                {125, 125, 106, 124, 122, 125, 110}};
    static const bounds most_in_order[PERIODS] = {{125, 242, 106, 124, 169, 125, 110},
                                                  {125, 242, 106, 124, 164, 125, 110},
                                                  {125, 242, 106, 124, 164, 125, 110},
                                                  {125, 242, 106, 124, 164, 125, 110}};
    (void)state;
    check_periods(random, most_random);
    check_periods(in_order, most_in_order);
}

static void bumps(void **state)
{
    static const technique alone = {"bumped", bumped, NULL, 0, false, 4};
    static const technique with_slopes = {"bumped, slopes", bumped, NULL, 0, true, 4};
    static const technique published = {"as published", bumped_for_255, NULL, 32, true, 4};
    static const bounds most_alone[PERIODS] = {{126, 242, 45, 124, 169, 126, 61},
                                               {125, 242, 43, 124, 160, 125, 61},
                                               {83, 242, 44, 124, 154, 125, 60},
                                               {100, 242, 43, 124, 154, 125, 59}};
    static const bounds most_with_slopes[PERIODS] = {{126, 252, 37, 53, 124, 44, 41},
                                                     {126, 252, 36, 55, 115, 43, 31},
                                                     {126, 252, 35, 49, 94, 43, 32},
                                                     {102, 250, 38, 48, 94, 43, 31}};
    static const bounds most_published = {252, 252, 106, 124, 117, 252, 114};
    (void)state;
    check_periods(alone, most_alone);
    check_periods(with_slopes, most_with_slopes);
    check(&published, measure, most_published);
}

/* As exact as dithered rounding (blends.c), since it is that: fx_alpha_corrected. */
static void corrected_opacities(void **state)
{
    static const technique golden = {
        "corrected, golden ratio", corrected, fx_dither_golden, 0, false, 8};
    static const technique hash = {"corrected, hash", corrected, fx_dither_hash, 0, false, 8};
    static const technique blocks = {"corrected, blocks", corrected, fx_dither_blocks, 0, false, 8};
    static const bounds most_golden = {5.5, 150, 22, 25, 8, 5, 6};
    static const bounds most_hash = {24, 34, 27, 29, 29, 23, 24};
    static const bounds most_blocks = {5.5, 31, 21, 25, 13.5, 5.5, 6.6};
    (void)state;
    check(&golden, measure, most_golden);
    check(&hash, measure, most_hash);
    check(&blocks, measure, most_blocks);
}

/* Of colour 255 in phase 0 the published slopes do as well per pixel as by slices counted. */
static void published_slopes(void **state)
{
    (void)state;
    for (unsigned i = 0; i < FIGURES; i++) {
        const double *f = figures[i];
        const fx_alpha of = {fx_period_of(32), {q16(f[1]), q16(f[2])}, 255};
        uint32_t value = 0;
        double worst = 0;
        for (uint32_t n = 0; n < REF_SLICES; n++) {
            const uint32_t opacity = fx_alpha_bumped(&of, q16(f[0]), n % 32, value);
            value = fx_blend_plain(value, 255, opacity, 8);
            worst = fmax(worst, fabs(value - 255 * (1 - pow(1 - f[0] / 255, n + 1))));
        }
        printf("# opacity %g, slopes %g and %g: %.2f levels off\n", f[0], f[1], f[2], worst);
        assert_true(fabs(worst - f[3]) <= .051);
    }
}

/* ---- Three channels that share an opacity ---------------------------------- */

/* The channel whose colour is farthest, which the technique goes by. */
static unsigned farthest(const uint32_t *colours, const uint32_t *values)
{
    unsigned which = 0;
    for (unsigned c = 1; c < CHANNELS; c++)
        if (distance(colours[c], values[c]) > distance(colours[which], values[which]))
            which = c;
    return which;
}

/* Where by->opacity is null, each channel has dithered rounding of its own. */
static void blend_pixel(const measurement *m, const moment *at, const uint32_t *colours,
                        uint32_t *values)
{
    const unsigned which = farthest(colours, values);
    const uint32_t opacity23 = fx_opacity_q23(at->opacity32);
    uint32_t opacity = 0;
    if (m->by->opacity != NULL)
        opacity = m->by->opacity(&m->of, at, colours[which], values[which]);
    for (unsigned c = 0; c < CHANNELS; c++)
        if (m->by->opacity == NULL)
            values[c] = fx_blend_dithered(values[c], colours[c] * opacity23, opacity23, at->u, 0);
        else
            values[c] = fx_blend_plain(values[c], colours[c], opacity, 8);
}

/* A level of the case, its inverse, and half of it. */
static void set_channels(uint32_t *channels, uint32_t level)
{
    channels[0] = level;
    channels[1] = 255 - level;
    channels[2] = level / 2;
}

static void measure_three(void *user, const ref_slice_case *slices)
{
    measurement *m = user;
    uint32_t values[CHANNELS], colours[CHANNELS];
    double exact[CHANNELS], worst = 0, squares = 0;
    set_channels(values, slices->start);
    for (unsigned c = 0; c < CHANNELS; c++)
        exact[c] = values[c];
    for (uint32_t n = 0; n < REF_SLICES; n++) {
        const moment at = moment_of(m->by, slices, n, 0);
        set_channels(colours, slices->colour[n]);
        if (m->by->published)
            set_slopes(&m->of, at.opacity);
        blend_pixel(m, &at, colours, values);
        for (unsigned c = 0; c < CHANNELS; c++) {
            exact[c] += at.opacity32 / (double)UINT32_MAX * (colours[c] - exact[c]);
            const double off = fabs(values[c] - exact[c]);
            worst = off > worst ? off : worst;
            squares += off * off;
        }
    }
    add(m, slices, worst, squares, (double)CHANNELS * REF_SLICES);
}

/*
 * What one opacity for all costs: a channel nearer to its colour than the farthest may come to
 * rest before it, as without dither, and takes part in bumps that it does not need.
 */
static void three_channels(void **state)
{
    static const technique alone = {"three channels, bumped", bumped, NULL, 32, true, 1};
    static const technique shared = {
        "three channels, corrected", corrected, fx_dither_blocks, 0, false, 1};
    static const technique apart = {
        "three channels, dithered blends", NULL, fx_dither_blocks, 0, false, 1};
    static const bounds most_alone = {126, 250, 63, 65, 94, 63, 65};
    static const bounds most_shared = {67, 77, 66, 69, 69, 67, 67};
    static const bounds most_apart = {5.5, 31, 21, 26, 13.5, 5.5, 6.6};
    (void)state;
    check(&alone, measure_three, most_alone);
    check(&shared, measure_three, most_shared);
    check(&apart, measure_three, most_apart);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_dither),
        cmocka_unit_test(simple_dither),
        cmocka_unit_test(bumps),
        cmocka_unit_test(corrected_opacities),
        cmocka_unit_test(published_slopes),
        cmocka_unit_test(three_channels),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
