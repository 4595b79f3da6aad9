#include "slice_cases.h"

#include "random.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#define COUNT(array) (sizeof(array) / sizeof *(array))

const char *const ref_slice_kind_names[REF_SLICE_KINDS] = {"constant", "sparse",  "random", "gaps",
                                                           "two fogs", "surface", "ramp"};

/* Levels: the paper's opacities and some above. */
static const double opacities[] = {.003, .01,  .03, .1, .25, .5, .75, 1,  1.1, 1.25,
                                   1.5,  1.75, 2,   3,  5,   8,  12,  20, 40,  100};

/* Opacities so far below the least are left out: all lists are denser. */
#define FAR_BELOW 8

typedef struct walk {
    ref_slice_case slices;
    double least;
    uint32_t seed;
    ref_slice_visitor *visit;
    void *user;
} walk;

static double uniform(walk *w)
{
    return ldexp(random_next(&w->seed), -32);
}

static bool is_left_out(const walk *w, double opacity)
{
    return FAR_BELOW * opacity < w->least;
}

static void begin(walk *w, ref_slice_kind kind, uint32_t start, double opacity, uint32_t parameter)
{
    w->slices.kind = kind;
    w->slices.start = start;
    w->slices.named = opacity;
    w->slices.parameter = parameter;
}

/* The opacity in levels, in steps of Q0.32. */
static void set(walk *w, uint32_t n, uint32_t index, double opacity, uint32_t colour)
{
    w->slices.index[n] = index;
    w->slices.opacity[n] = (uint32_t)(fmin(fmax(opacity, w->least) / 255, 1) * UINT32_MAX + .5);
    w->slices.colour[n] = (uint8_t)colour;
}

static void finish(walk *w)
{
    ref_slice_case *slices = &w->slices;
    double over = slices->start, under = 0, clear = 1;
    for (uint32_t n = 0; n < slices->count; n++) {
        const double a = (double)slices->opacity[n] / UINT32_MAX;
        over += a * (slices->colour[n] - over);
        under += clear * a * slices->colour[n];
        clear *= 1 - a;
        slices->over[n] = over;
        slices->under[n] = under;
    }
    w->visit(w->user, slices);
}

static void constant(walk *w)
{
    const uint32_t count = 150;
    for (uint32_t i = 0; i < count; i++)
        for (uint32_t c = 0; c < 256; c += 15) {
            const double a = .003 * pow(255 / .003, (double)i / (count - 1));
            if (is_left_out(w, a))
                continue;
            begin(w, REF_SLICES_CONSTANT, c < 128 && i % 2 ? 255 : 0, a, c);
            for (uint32_t n = 0; n < w->slices.count; n++)
                set(w, n, n, a, c);
            finish(w);
        }
}

static void sparse(walk *w)
{
    for (uint32_t k = 2; k <= 300; k++)
        for (size_t i = 0; i < 17; i++) { /* opacities below 13: others need no thousand slices */
            if (is_left_out(w, opacities[i]))
                continue;
            const uint32_t first = random_below(&w->seed, 1000);
            const uint32_t colour = k & 1 ? 255 - random_below(&w->seed, 200) : 255;
            begin(w, REF_SLICES_SPARSE, 0, opacities[i], k);
            for (uint32_t n = 0; n < w->slices.count; n++)
                set(w, n, first + n * k, opacities[i], colour);
            finish(w);
        }
}

/* Opacity and colour of a random slice: how says what is random. */
static void set_random(walk *w, uint32_t n, double most, uint32_t colour, unsigned how)
{
    const uint32_t any = random_below(&w->seed, 256);
    const double share = uniform(w);
    switch (how) {
    case 0:
        set(w, n, n, most * share, any);
        break;
    case 1:
        set(w, n, n, most * share, any & 1 ? 255 : 0);
        break;
    case 2:
        set(w, n, n, most * share, colour);
        break;
    case 3:
        set(w, n, n, most, any);
        break;
    default:
        set(w, n, n, share < .5 ? most : most / 10, any & 1 ? 255 : 100);
        break;
    }
}

static const double greatest[] = {.03, .1, .3, .5, 1, 1.5, 2, 4, 8, 16, 64, 255};

static void random_slices(walk *w)
{
    for (size_t i = 0; i < COUNT(greatest); i++)
        for (unsigned repeat = 0; repeat < 60 && !is_left_out(w, greatest[i]); repeat++) {
            const uint32_t colour = 155 + random_below(&w->seed, 101);
            begin(w, REF_SLICES_RANDOM, repeat & 1 ? random_below(&w->seed, 256) : 0, greatest[i],
                  repeat % 5);
            for (uint32_t n = 0; n < w->slices.count; n++)
                set_random(w, n, greatest[i], colour, repeat % 5);
            finish(w);
        }
}

static void gaps(walk *w)
{
    for (size_t i = 0; i < COUNT(greatest); i++)
        for (uint32_t repeat = 0; repeat < 20 && !is_left_out(w, greatest[i]); repeat++) {
            const uint32_t colour = 155 + random_below(&w->seed, 101);
            uint32_t index = 0;
            begin(w, REF_SLICES_GAPS, 0, greatest[i], repeat);
            for (uint32_t n = 0; n < w->slices.count; n++) {
                set(w, n, index, greatest[i], colour);
                index += 1 + random_below(&w->seed, 8);
            }
            finish(w);
        }
}

static void two_fogs(walk *w)
{
    static const uint8_t colours[][2] = {{255, 0}, {255, 128}, {200, 50},
                                         {0, 255}, {255, 254}, {128, 10}};
    static const uint32_t runs[] = {1, 2, 3, 5, 8, 13, 16, 32, 55, 100, 233, 500};
    static const double ratios[] = {1, .37, 2.5, .1};
    for (size_t pair = 0; pair < COUNT(colours); pair++)
        for (size_t run = 0; run < COUNT(runs); run++)
            for (size_t i = 0; i < COUNT(opacities) * COUNT(ratios); i++) {
                const double one = opacities[i / COUNT(ratios)];
                const double other = one * ratios[i % COUNT(ratios)];
                if (is_left_out(w, one))
                    continue;
                begin(w, REF_SLICES_TWO_FOGS, 0, one, runs[run]);
                for (uint32_t n = 0; n < w->slices.count; n++) {
                    const uint32_t second = n / runs[run] & 1;
                    set(w, n, n, second ? other : one, colours[pair][second]);
                }
                finish(w);
            }
}

static void surface(walk *w)
{
    static const uint32_t places[] = {0, 150, 400}, fogs[] = {0, 255, 50, 128, 254};
    static const double solid[] = {255, 200, 128};
    for (size_t i = 0; i < COUNT(opacities); i++)
        for (size_t fog = 0; fog < COUNT(fogs); fog++)
            for (size_t s = 0; s < COUNT(solid) * COUNT(places) && !is_left_out(w, opacities[i]);
                 s++)
                for (uint32_t colour = 0; colour < 256; colour += 51) {
                    const uint32_t place = places[s / COUNT(solid)] % w->slices.count;
                    begin(w, REF_SLICES_SURFACE, 0, opacities[i], place);
                    for (uint32_t n = 0; n < w->slices.count; n++)
                        set(w, n, n, opacities[i], fogs[fog]);
                    set(w, place, place, solid[s % COUNT(solid)], colour);
                    finish(w);
                }
}

/* t is 0 .. 1 */
static double ramp_at(unsigned form, double t)
{
    switch (form) {
    case 0:
        return t;
    case 1:
        return 1 - t;
    case 2:
        return fabs(1 - 2 * t);
    default:
        return pow(.001, t);
    }
}

static void ramp(walk *w)
{
    static const uint32_t colours[] = {255, 200, 128, 20};
    for (size_t i = 0; i < COUNT(opacities); i++)
        for (unsigned form = 0; form < 4; form++)
            for (size_t c = 0; c < 2 * COUNT(colours) && !is_left_out(w, opacities[i]); c++) {
                const uint32_t colour = colours[c / 2];
                begin(w, REF_SLICES_RAMP, c & 1 ? 255 - colour : 0, 2 * opacities[i], form);
                for (uint32_t n = 0; n < w->slices.count; n++) {
                    const double a = 2 * opacities[i] * ramp_at(form, n / (w->slices.count - 1.0));
                    set(w, n, n, fmax(a, .003), colour);
                }
                finish(w);
            }
}

void ref_each_slice_case(ref_slice_visitor *visit, void *user)
{
    const ref_slice_limits none = {REF_SLICES, 0};
    ref_each_slice_case_within(visit, user, &none);
}

void ref_each_slice_case_within(ref_slice_visitor *visit, void *user,
                                const ref_slice_limits *limits)
{
    static walk w;
    w.slices.count = limits->count;
    w.least = limits->least;
    w.seed = 12345;
    w.visit = visit;
    w.user = user;
    constant(&w);
    sparse(&w);
    random_slices(&w);
    gaps(&w);
    two_fogs(&w);
    surface(&w);
    ramp(&w);
}
