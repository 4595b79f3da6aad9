/*
 * composite.c - light of n samples, one under or over the other.
 *
 * The worst rays are grown greedily: of samples that round as far as they can, each takes that
 * which leaves the largest error with the wanted sign. Errors of transmittance are worth as much
 * as those of light, since what comes behind may turn them into such.
 */
#include "search.h"

#include "composite.h"

#include <string.h>

#define RANDOM_RAYS 400
#define GREEDY_RAYS 16
#define HALVES      6 /* products are brought to k + 1/2, k below this */

/* A ray by the library, and in long double: both in units of 2^-31. */
typedef struct ray {
    qv_light light;
    long double colour, transmittance;
} ray;

/* One grey sample: light in the unit of 2^32, and opacity. */
typedef struct sample {
    uint32_t light, opacity;
} sample;

typedef void composite_step(ray *r, const sample *s);

static ray begin(void)
{
    ray r;
    memset(&r, 0, sizeof r);
    r.light.transmittance = QV_CLEAR;
    r.transmittance = QV_CLEAR;
    return r;
}

/* What of an opacity passes through, 2^32 - 1 being 1. */
static long double rest_of(uint32_t opacity)
{
    return opacity == UINT32_MAX ? 0 : 1 - ldexpl(opacity, -32);
}

static void under(ray *r, const sample *s)
{
    const uint32_t grey[3] = {s->light, s->light, s->light};
    r->colour += ldexpl(s->light, -32) * r->transmittance;
    r->transmittance *= rest_of(s->opacity);
    qv_under(&r->light, grey, s->opacity);
}

static void over(ray *r, const sample *s)
{
    const uint32_t grey[3] = {s->light, s->light, s->light};
    r->colour = r->colour * rest_of(s->opacity) + s->light / 2.L;
    r->transmittance *= rest_of(s->opacity);
    qv_over(&r->light, grey, s->opacity);
}

static double light_error(const ray *r)
{
    return (double)(r->light.colour[0] - r->colour);
}

static double transmittance_error(const ray *r)
{
    return (double)(r->light.transmittance - r->transmittance);
}

/* ---- Rays that err as far as they can ----------------------------------------------------- */

/* A factor whose product with a number, by 2^32, lies just below or above k + 1/2. */
static uint32_t near_half(uint32_t number, unsigned k, int above)
{
    const uint64_t least = (((uint64_t)(2 * k + 1) << 31) + number - 1) / (number + (number == 0));
    return least > UINT32_MAX ? 0 : (uint32_t)least - (above == 0 && least != 0);
}

/* What a way of compositing multiplies light and opacity with; over, light does not meet it. */
typedef struct way {
    composite_step *step;
    int is_under;
} way;

static uint32_t met_by_light(const ray *r)
{
    return r->light.transmittance;
}

static double worth(const ray *r, double sign, int of_transmittance)
{
    const double hidden = transmittance_error(r);
    return sign * (of_transmittance ? hidden : light_error(r) + hidden);
}

typedef struct greedy {
    const way *by;
    double sign;
    int of_transmittance;
    ray best;
    double most;
} greedy;

static void try_sample(greedy *g, const ray *from, uint32_t light, uint32_t opacity)
{
    const sample s = {light < opacity ? light : opacity, opacity};
    ray next = *from;
    g->by->step(&next, &s);
    const double value = worth(&next, g->sign, g->of_transmittance);
    if (value > g->most) {
        g->most = value;
        g->best = next;
    }
}

static void grow(greedy *g, ray *r)
{
    const uint32_t met = g->by->is_under ? met_by_light(r) : r->light.colour[0];
    g->most = -(double)INFINITY;
    for (unsigned k = 0; k < 4 * HALVES * HALVES; k++) {
        const unsigned i = k / 4 % HALVES, j = k / 4 / HALVES;
        const uint32_t opacity = near_half(k % 8 < 4 ? r->light.transmittance : met, i, k & 1);
        const uint32_t light =
            g->by->is_under ? near_half(met, j, k >> 1 & 1) : 2 * j + (k >> 1 & 1);
        try_sample(g, r, light, opacity);
    }
    *r = g->best;
}

/* A ray of n samples, the first of them at random: near 1 products have no halves but ties. */
static void grow_ray(measured *m, greedy *g, unsigned n, uint64_t *state)
{
    static const sample wall = {UINT32_MAX, UINT32_MAX};
    sample first;
    ray r = begin();
    const int ends_dark = g->by->is_under && !g->of_transmittance;
    first.opacity = (uint32_t)(random64(state) >> 33);
    if (!g->by->is_under) /* something that light can be taken from */
        first.opacity = UINT32_MAX;
    first.light = (uint32_t)(random64(state) % ((uint64_t)first.opacity + 1));
    g->by->step(&r, &first);
    for (unsigned i = 2; i < n; i++)
        grow(g, &r);
    if (n > 1 && ends_dark)
        under(&r, &wall);
    else if (n > 1)
        grow(g, &r);
    if (measured_is_worse(m, g->of_transmittance ? transmittance_error(&r) : light_error(&r)))
        measured_input(m, "greedy, first opacity 0x%X, light 0x%X", first.opacity, first.light);
}

static void grow_rays(measured *m, const way *by, unsigned n, int of_transmittance)
{
    uint64_t state = n;
    for (unsigned i = 0; i < GREEDY_RAYS; i++) {
        greedy g;
        memset(&g, 0, sizeof g);
        g.by = by;
        g.sign = i % 2 == 0 ? 1 : -1;
        g.of_transmittance = of_transmittance;
        grow_ray(m, &g, n, &state);
    }
}

/* ---- Random rays ---------------------------------------------------------------------------- */

/* Opacities of random magnitude, about as large as make n of them opaque, and less. */
static sample random_sample(uint64_t *state, unsigned n)
{
    const uint64_t number = random64(state);
    sample s;
    s.opacity = (uint32_t)(number / n >> 32) >> (number & 7);
    s.light = (uint32_t)((uint64_t)s.opacity * (uint32_t)random64(state) >> 32);
    return s;
}

static void measure_ray(measured *m, const way *by, unsigned n, int of_transmittance)
{
    uint64_t state = n;
    for (unsigned i = 0; i < RANDOM_RAYS; i++) {
        ray r = begin();
        for (unsigned k = 0; k < n; k++) {
            const sample s = random_sample(&state, n);
            by->step(&r, &s);
        }
        if (measured_add(m, of_transmittance ? transmittance_error(&r) : light_error(&r)))
            measured_input(m, "random ray %u", i);
    }
    grow_rays(m, by, n, of_transmittance);
}

static const way by_under = {under, 1}, by_over = {over, 0};

static void measure_transmittance(measured *m, unsigned n)
{
    measure_ray(m, &by_under, n, 1);
}

static void measure_under(measured *m, unsigned n)
{
    measure_ray(m, &by_under, n, 0);
}

static void measure_over(measured *m, unsigned n)
{
    measure_ray(m, &by_over, n, 0);
}

/* ---- The chapter -------------------------------------------------------------------------- */

#define ROW(name, n, measure, bound, within, rounding)                                             \
    {                                                                                              \
        name ", n = " #n, "u32.32 to u32.31", rounding, "2^-31", bound, within, "greedy", measure, \
            n, NULL                                                                                \
    }
/* n samples are off by at most n * each - less; one is no chain. */
#define ROWS(name, measure, each, less, rounding)                                                  \
    ROW(name, 1, measure, .5, 2, rounding),                                                        \
        ROW(name, 16, measure, 16 * (each) - (less), 4, rounding),                                 \
        ROW(name, 256, measure, 256 * (each) - (less), 4, rounding),                               \
        ROW(name, 4096, measure, 4096 * (each) - (less), 4, rounding)

static const stage stages[] = {
    ROWS("transmittance", measure_transmittance, .5, 0, "product, to nearest"),
    ROWS("light, front to back", measure_under, 1, .5, "two products, to nearest"),
    ROWS("light, back to front", measure_over, 1, .5, "product and half, to nearest"),
};

const chapter chapter_composite = {
    "Compositing of n samples (SPEC 14)",
    "RMS is that of 400 random rays. The worst were grown greedily: of some hundred samples\n"
    "whose products lie just beside k + 1/2 each takes that after which light and transmittance\n"
    "are farthest off to one side; front to back an opaque white sample ends the ray, which\n"
    "turns the error of transmittance into light.\n\n"
    "**Transmittance.** A sample multiplies the error so far by at most 1 and rounds by at most\n"
    "1/2: after n samples at most n / 2 of 2^-31.\n\n"
    "**Front to back.** Light and transmittance share what there is: what a sample takes from\n"
    "an error of transmittance is all that it can add to that of light, besides the rounding of\n"
    "its own product, 1/2. So both together are off by at most n / 2 + n / 2; of these the\n"
    "last rounding of transmittance meets no light: n - 1/2.\n\n"
    "**Back to front.** A sample takes from the error so far, and rounds twice: the product by\n"
    "1/2, half of its light by 1/2; the first one has no light behind it to multiply: n - 1/2.\n\n"
    "Half an odd light is a tie, which goes upwards: of random rays too, light is n / 4 high on\n"
    "average.\n\n"
    "Front to back, errors of random rays grow with the root of n or less, as their RMS shows.\n"
    "At the worst 4096 samples leave 19 bits right.\n",
    stages, COUNT(stages)};
