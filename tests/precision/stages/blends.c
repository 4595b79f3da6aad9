/*
 * blends.c - frame buffers of few bits: the plain blend, its dithered forms and the opacities that
 * alpha dithering hands out, for one slice and for many.
 */
#include "search.h"

#include "fx_blend.h"
#include "fx_dither.h"

/* ---- Plain blends ------------------------------------------------------------------------- */

/* Every state, colour and opacity of so few bits. */
static void measure_plain(measured *m, unsigned bits)
{
    const uint32_t full = (1u << bits) - 1;
    for (uint32_t state = 0; state <= full; state++)
        for (uint32_t colour = 0; colour <= full; colour++)
            for (uint32_t opacity = 0; opacity <= full; opacity++) {
                const uint32_t sum = colour * opacity + (full - opacity) * state;
                const uint32_t found = fx_blend_plain(state, colour, opacity, bits);
                if (measured_add(m, found - (double)sum / full))
                    measured_input(m, "state %u, colour %u, opacity %u", state, colour, opacity);
            }
}

/* Every sum that a blend may round, in the form that leaves the state alone. */
static void measure_quotients(measured *m, unsigned bits)
{
    const uint32_t full = (1u << bits) - 1;
    for (uint32_t sum = 0; sum <= full * full; sum++)
        if (measured_add(m, fx_divide_by_ones(sum, bits) - (double)sum / full))
            measured_input(m, "%u", sum);
}

/* From every state to every colour by slices of one opacity until nothing changes. */
static void measure_stall(measured *m, unsigned opacity)
{
    for (uint32_t start = 0; start < 256; start++)
        for (uint32_t colour = 0; colour < 256; colour++) {
            uint32_t state = start, last;
            do {
                last = state;
                state = fx_blend_plain(last, colour, opacity, 8);
            } while (state != last);
            if (measured_add(m, (double)state - colour))
                measured_input(m, "from %u to %u", start, colour);
        }
}

/* ---- Dithered blends ---------------------------------------------------------------------- */

/* Numbers of an input. */
enum { STATE, COLOUR, OPACITY, DITHER, NUMBERS };

static double exact_blend(double state, double colour, double opacity)
{
    return state + opacity * (colour - state);
}

static double dithered_error(const uint64_t input[], unsigned fraction)
{
    const uint32_t opacity = (uint32_t)input[OPACITY];
    const uint32_t light = fx_light_of_colour((uint32_t)input[COLOUR], opacity);
    if (input[STATE] > 255u << fraction)
        return NO_SUCH_INPUT;
    return fx_blend_dithered((uint32_t)input[STATE], light, opacity, (uint32_t)input[DITHER],
                             fraction) -
           exact_blend((double)input[STATE], ldexp((double)input[COLOUR], (int)fraction),
                       ldexp(opacity, -23));
}

/* The mean over values that lie evenly; the fourth number is not read. */
enum { PLACES = 64 };

static double mean_error(const uint64_t input[], unsigned fraction)
{
    uint64_t at[NUMBERS] = {input[STATE], input[COLOUR], input[OPACITY], 0};
    double sum = 0;
    for (uint32_t i = 0; i < PLACES; i++) {
        at[DITHER] = (2 * i + 1) * (uint64_t)(1u << 31) / PLACES;
        sum += dithered_error(at, fraction);
    }
    return sum / PLACES;
}

static double rounded_error(const uint64_t input[], unsigned unused)
{
    const uint32_t opacity = (uint32_t)input[OPACITY];
    const uint32_t light = fx_light_of_colour32((uint32_t)input[COLOUR], opacity);
    (void)unused;
    if (input[STATE] > 255u << 16)
        return NO_SUCH_INPUT;
    return fx_blend_8_16((uint32_t)input[STATE], light, opacity, FX_NO_DITHER) -
           exact_blend((double)input[STATE], ldexp((double)input[COLOUR], 16),
                       opacity == UINT32_MAX ? 1 : ldexp(opacity, -32));
}

static double transmit_error(const uint64_t input[], unsigned unused)
{
    const uint32_t opacity = (uint32_t)input[OPACITY];
    const double rest = opacity == UINT32_MAX ? 0 : 1 - ldexp(opacity, -32);
    (void)unused;
    return fx_transmit((uint32_t)input[STATE], opacity) - (double)input[STATE] * rest;
}

static void tell_dithered(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "state %u, colour %u, opacity 0x%X, u 0x%X", (unsigned)input[STATE],
                   (unsigned)input[COLOUR], (unsigned)input[OPACITY], (unsigned)input[DITHER]);
}

static void tell(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "state %u, colour %u, opacity 0x%X", (unsigned)input[STATE],
                   (unsigned)input[COLOUR], (unsigned)input[OPACITY]);
}

static void measure_dithered(measured *m, unsigned fraction)
{
    const search s = {
        dithered_error, tell_dithered, NUMBERS, {255u << fraction, 255, FX_ONE_Q23, UINT32_MAX}};
    search_worst(m, &s, fraction);
}

static void measure_mean(measured *m, unsigned fraction)
{
    const search s = {mean_error, tell, OPACITY + 1, {255u << fraction, 255, FX_ONE_Q23}};
    search_worst(m, &s, fraction);
}

static void measure_rounded(measured *m, unsigned parameter)
{
    static const search s = {rounded_error, tell, OPACITY + 1, {255u << 16, 255, UINT32_MAX}};
    search_worst(m, &s, parameter);
}

static void measure_transmit(measured *m, unsigned parameter)
{
    static const search s = {transmit_error, tell, OPACITY + 1, {FX_CLEAR_Q24, 255, UINT32_MAX}};
    search_worst(m, &s, parameter);
}

/* ---- Many slices -------------------------------------------------------------------------- */

#define SLICES 1024

/* A unit a slice, within what a state can hold. */
#define MOST_OFF(fraction) ((fraction) == 0 ? 255 : SLICES)

/* A fog of one colour and opacity, from black, each slice with its dither value. */
static void measure_fog(measured *m, unsigned fraction, uint32_t opacity, int by_blocks)
{
    const uint32_t colour = 255, light = fx_light_of_colour(colour, opacity);
    uint32_t state = 0;
    double exact = 0;
    for (uint32_t n = 0; n < SLICES; n++) {
        state = fx_blend_dithered(state, light, opacity,
                                  by_blocks ? fx_dither_blocks(n) : UINT32_MAX, fraction);
        exact = exact_blend(exact, ldexp(colour, (int)fraction), ldexp(opacity, -23));
        if (measured_add(m, state - exact))
            measured_input(m, "opacity 0x%X, slice %u", opacity, n + 1);
    }
}

/* Opacities of each magnitude, four of an octave. */
static void measure_fogs(measured *m, unsigned fraction, int by_blocks)
{
    for (unsigned step = 0; step <= 4 * 23; step++)
        measure_fog(m, fraction, (uint32_t)floor(exp2(step / 4.) + .5), by_blocks);
}

static void measure_blocks(measured *m, unsigned fraction)
{
    measure_fogs(m, fraction, 1);
}

static void measure_worst_dither(measured *m, unsigned fraction)
{
    measure_fogs(m, fraction, 0);
}

/* ---- Alpha dithering ---------------------------------------------------------------------- */

/* Every opacity below 1 level and every period: how many of its slices hit. */
static void measure_hits(measured *m, unsigned unused)
{
    (void)unused;
    for (uint32_t slices = 2; slices <= 64; slices++) {
        const fx_period period = fx_period_of(slices);
        for (uint32_t opacity = 0; opacity < 65536; opacity++)
            if (measured_add(m, fx_hits(&period, opacity, 0, 1) - opacity * slices / 65536.))
                measured_input(m, "period %u, opacity %u", slices, opacity);
    }
}

/* Every period and number of hits: how many dither values of 16 bits hit, in 2^-16. */
static void measure_random_hits(measured *m, unsigned unused)
{
    (void)unused;
    for (uint32_t slices = 2; slices <= 64; slices++) {
        const fx_period period = fx_period_of(slices);
        uint32_t below[65] = {0};
        for (uint32_t u = 0; u < 65536; u++)
            for (uint32_t hits = slices; fx_hit_random(&period, hits, u << 16) != 0; hits--)
                below[hits]++;
        for (uint32_t hits = 0; hits <= slices; hits++)
            if (measured_add(m, below[hits] - hits * 65536. / slices))
                measured_input(m, "period %u, %u hits", slices, hits);
    }
}

/* ---- The chapter -------------------------------------------------------------------------- */

#define PLAIN(bits)                                                                                \
    {                                                                                              \
        "plain blend, " #bits " bits", "3 u" #bits " to u" #bits, "to nearest", "level", .5, 2,    \
            "all", measure_plain, bits, NULL                                                       \
    }
#define STALL(opacity)                                                                             \
    {                                                                                              \
        "plain blends, 8 bits, opacity " #opacity, "u8", "to nearest, any number of slices",       \
            "level", 127 / opacity, 4, "all states and colours", measure_stall, opacity, NULL      \
    }
#define DITHERED(format, fraction)                                                                 \
    {"dithered blend, " format,                                                                    \
     "u" format ", light u32.23",                                                                  \
     "by dither",                                                                                  \
     "unit",                                                                                       \
     1,                                                                                            \
     2,                                                                                            \
     "search",                                                                                     \
     measure_dithered,                                                                             \
     fraction,                                                                                     \
     NULL},                                                                                        \
        {"dithered blend, " format ", mean",                                                       \
         "u" format ", light u32.23",                                                              \
         "by dither",                                                                              \
         "unit",                                                                                   \
         .5 / PLACES + 1. / (1 << (23 - fraction)),                                                \
         2,                                                                                        \
         "search",                                                                                 \
         measure_mean,                                                                             \
         fraction,                                                                                 \
         NULL},                                                                                    \
        {"fog in " format ", worst dither",                                                        \
         "u" format ", light u32.23",                                                              \
         "by dither",                                                                              \
         "unit",                                                                                   \
         MOST_OFF(fraction),                                                                       \
         4,                                                                                        \
         "1024 slices, 93 opacities",                                                              \
         measure_worst_dither,                                                                     \
         fraction,                                                                                 \
         NULL},                                                                                    \
    {                                                                                              \
        "fog in " format ", by blocks", "u" format ", light u32.23", "by dither", "unit",          \
            MOST_OFF(fraction), 4, "1024 slices, 93 opacities", measure_blocks, fraction,          \
            "The bound is that of any dither values; none nearer is proved for these."             \
    }

static const stage stages[] = {
    PLAIN(5),
    PLAIN(6),
    PLAIN(8),
    {"plain blend, 12 bits", "3 u12 to u12", "to nearest", "level", .5, 2, "all 4095^2 + 1 sums",
     measure_quotients, 12, NULL},
    STALL(1),
    STALL(4),
    STALL(16),
    DITHERED("8.0", 0),
    DITHERED("12.4", 4),
    DITHERED("16.8", 8),
    {"blend of 24 bits", "u24.16, light u32.23", "to nearest", "unit", .5 + 1 / 128., 2, "search",
     measure_rounded, 0, NULL},
    {"transmittance of a pixel", "u24.24, u32.32", "to nearest", "unit", .5 + 1 / 128., 2, "search",
     measure_transmit, 0, NULL},
    {"hits of a period", "u32.16 to 0 .. 64", "to nearest", "slice", .5, 2, "all 63 * 65536",
     measure_hits, 0, NULL},
    {"random hits", "u16.16", "cut", "2^-16 of all values", 1, 2, "all periods, hits, values",
     measure_random_hits, 0, NULL},
};

const chapter chapter_blends = {
    "Dither and blends (SPEC 45 to 49)",
    "**Plain.** One quotient to nearest: 1/2. A slice of opacity o moves a state S towards its\n"
    "colour c only where o |c - S| > 255 / 2: it stalls up to 127 / o levels off, however many\n"
    "slices follow.\n\n"
    "**Dithered.** The sum, plus a dither value below 1, is cut: less than 1 unit off. Over\n"
    "values that part 0 .. 1 evenly the mean is exact, but for 1/2 of their distance and the\n"
    "share of the fraction that is cut before, 2^(f-23). With the same value again and again\n"
    "each slice may add 1 unit, up to the 255 of an 8-bit state; values by blocks have a mean of\n"
    "1/2 in each 8 slices.\n\n"
    "**Of 24 bits, and transmittance.** To nearest with 8 bits to spare, of which two roundings\n"
    "and a rest of 2 take up to 2: 1/2 + 2 / 256.\n\n"
    "**Hits.** Of P slices round(P o) hit: 1/2. At random, the values below hits / P are a\n"
    "whole number of 2^16: less than 1 off.\n",
    stages, COUNT(stages)};
