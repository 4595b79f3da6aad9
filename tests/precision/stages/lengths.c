/*
 * lengths.c - modes that weigh by length: a piece by corrected opacity, and n pieces by
 * extinction.
 */
#include "search.h"

#include "correct.h"

#include <string.h>

#define LN_2 0.693147180559945309417232121458176568L

/* ---- Corrected opacity -------------------------------------------------------------------- */

/* A piece of so many 64ths of the unit distance. */
static qv_medium medium_of(unsigned parts)
{
    qv_medium medium;
    medium.depth = (uint64_t)parts << 26;
    for (medium.light_shift = 1; medium.depth >> (32 + medium.light_shift) != 0;)
        medium.light_shift++;
    medium.light = (uint32_t)(medium.depth >> medium.light_shift);
    return medium;
}

/* A full white sample of 16-bit storage: its light is what it is multiplied by. */
static uint32_t correct(uint32_t light[3], uint32_t opacity, unsigned parts)
{
    qv_sample sample;
    const qv_medium medium = medium_of(parts);
    memset(&sample, 0, sizeof sample);
    sample.opacity = fx_share_of(opacity);
    for (unsigned c = 0; c < 3; c++)
        sample.light[c] = fx_sum_of(opacity);
    return qv_correct(light, &sample, &medium, QV_STORAGE_RGBA16);
}

static uint32_t q32_of(uint64_t opacity)
{
    return qv_opacity_q32(fx_share_of((uint32_t)opacity), QV_STORAGE_RGBA16);
}

static long double corrected(uint32_t opacity, unsigned parts)
{
    return -expm1l(parts / 64.L * log1pl(-(long double)opacity / UINT32_MAX));
}

static double corrected_error(const uint64_t opacity[], unsigned parts)
{
    uint32_t light[3];
    const uint32_t found = correct(light, (uint32_t)opacity[0], parts);
    const long double exact = corrected(q32_of(opacity[0]), parts);
    return (double)ldexpl((long double)found / UINT32_MAX - exact, 28);
}

/* Light that the cut of its last place changes by less than 2^-22 of it, after a quarter too. */
#define LEAST_BRIGHT (1u << 24)

static double light_error(const uint64_t opacity[], unsigned parts)
{
    uint32_t light[3];
    if (opacity[0] < LEAST_BRIGHT)
        return NO_SUCH_INPUT;
    (void)correct(light, (uint32_t)opacity[0], parts);
    const uint32_t q32 = q32_of(opacity[0]);
    const long double exact = corrected(q32, parts) / q32 * UINT32_MAX * opacity[0];
    return (double)ldexpl(light[0] / exact - 1, 16);
}

static void tell_opacity(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "O = %u", (unsigned)input[0]);
}

#define OPACITY_MOST ((uint64_t)65535 * 65536 - 65536)

static void measure_corrected(measured *m, unsigned parts)
{
    static const search s = {corrected_error, tell_opacity, 1, {OPACITY_MOST}};
    search_worst(m, &s, parts);
}

static void measure_light(measured *m, unsigned parts)
{
    static const search s = {light_error, tell_opacity, 1, {OPACITY_MOST}};
    search_worst(m, &s, parts);
}

/* ---- Extinction --------------------------------------------------------------------------- */

/* Numbers of an input: the sum O of each piece, and the depth of 2^32 units of it, u32.32. */
typedef struct gathered {
    qv_light light;
    long double depth, exact_light;
} gathered;

static gathered gather(const uint64_t input[], unsigned pieces)
{
    qv_sample sample;
    qv_medium medium;
    qv_gathered sums;
    gathered g;
    const long double factor = ldexpl((long double)input[1], -32) * LN_2;
    memset(&sample, 0, sizeof sample);
    memset(&sums, 0, sizeof sums);
    memset(&g, 0, sizeof g);
    sample.opacity = fx_share_of((uint32_t)input[0]);
    for (unsigned c = 0; c < 3; c++)
        sample.light[c] = fx_sum_of((uint32_t)input[0]);
    medium.depth = input[1];
    medium.light_shift = 1;
    medium.light = (uint32_t)floorl(ldexpl(factor, 31));
    g.light.transmittance = QV_CLEAR;
    for (unsigned i = 0; i < pieces; i++)
        qv_extinction_under(&g.light, &sums, &sample, &medium, QV_STORAGE_RGBT16);
    qv_gathered_light(&g.light, &sums, &medium);
    g.depth = pieces * ldexpl((long double)input[0] * (long double)input[1], -64);
    g.exact_light = ldexpl(-expm1l(-g.depth * LN_2), 31);
    return g;
}

static double gathered_error(const uint64_t input[], unsigned pieces)
{
    const gathered g = gather(input, pieces);
    return (double)(g.light.transmittance - ldexpl(exp2l(-g.depth), 31));
}

/* Of white light, which is as much as opacity: in 2^-16 of full. */
static double gathered_light_error(const uint64_t input[], unsigned pieces)
{
    const gathered g = gather(input, pieces);
    return (double)ldexpl(g.light.colour[0] - g.exact_light, -15);
}

static void tell_pieces(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "O = %u, depth 0x%llX", (unsigned)input[0], (unsigned long long)input[1]);
}

/* Depths of the full value, at most 2 a piece. */
#define DEPTH_MOST ((uint64_t)2 << 32)

static void measure_gathered(measured *m, unsigned pieces)
{
    static const search s = {gathered_error, tell_pieces, 2, {65535u * 65536u, DEPTH_MOST}};
    search_worst(m, &s, pieces);
}

static void measure_gathered_light(measured *m, unsigned pieces)
{
    static const search s = {gathered_light_error, tell_pieces, 2, {65535u * 65536u, DEPTH_MOST}};
    search_worst(m, &s, pieces);
}

/* ---- The chapter -------------------------------------------------------------------------- */

#define PIECES(n, most, reason)                                                                    \
    {"transmittance by extinction, n = " #n,                                                       \
     "u32, u64.32 to u32.31",                                                                      \
     "depth cut, exp",                                                                             \
     "2^-31",                                                                                      \
     .78 + n * .3466,                                                                              \
     most,                                                                                         \
     "search",                                                                                     \
     measure_gathered,                                                                             \
     n,                                                                                            \
     NULL},                                                                                        \
    {                                                                                              \
        "light by extinction, n = " #n, "u32, u64.32 to u32", "phi, products, cut", "2^-16 of 1",  \
            .015 + n * 1e-4, most, "search", measure_gathered_light, n, reason                     \
    }

static const stage stages[] = {
    {"corrected piece, 1/4 of the unit", "u32.32 to u32.32", "log, product, exp", "2^-28", .36, 2,
     "search", measure_corrected, 16, NULL},
    {"light of a piece, 1/4 of the unit", "u32 to u32", "factor of colour, cut", "2^-16 of it", .42,
     2, "search, O from 2^24 on", measure_light, 16,
     "phi errs most at depths of 8 and more: of the two depths only one lies there."},
    {"corrected piece, 8.36 units", "u32.32 to u32.32", "log, product, exp", "2^-28", 8.8, 2,
     "search", measure_corrected, 535, NULL},
    {"light of a piece, 8.36 units", "u32 to u32", "factor of colour, cut", "2^-16 of it", .42, 2,
     "search, O from 2^24 on", measure_light, 535, NULL},
    PIECES(1, 2,
           "phi, the last cut and the rest of the bound meet their worst at different depths."),
    PIECES(16, 4, NULL),
    PIECES(256, 4, NULL),
};

const chapter chapter_lengths = {
    "Pieces of a way (SPEC 42, 43)",
    "**Corrected.** As the opacity for other slices: 1.5 k ln 2 of the log and .1 of exp for a\n"
    "piece of k unit distances. Light: the factor of colour, .4 of 2^-16, and the cut of the\n"
    "last place, 2^-22 of light of 2^22 and more.\n\n"
    "**Extinction.** Each depth is cut by less than 2^-32, which takes ln 2 / 2 of 2^-31 of the\n"
    "transmittance at most, and their sum is exact: .78 of exp and .3466 for each piece. Light\n"
    "has the error of phi, below .008 of 2^-16 for depths below 2, by what the pieces' depths\n"
    "sum up to while they are seen: 1 / phi(2) = 1.85 at most, .015; and three cuts and the\n"
    "transmittance's own error a piece, together below 1e-4 of 2^-16.\n",
    stages, COUNT(stages)};
