/*
 * depth.c - functions of optical depth: exp, log, phi, reciprocal, and the corrections made of
 * them, against the long doubles of the mathematics library.
 */
#include "search.h"

#include "fx_correct.h"
#include "fx_log.h"
#include "fx_phi.h"

#define LN_2             0.693147180559945309417232121458176568L
#define LEAST_RECIPROCAL (1u << 27)
#define DEPTH_MOST       ((uint64_t)40 << 32)

static void tell_number(measured *m, const uint64_t input[], unsigned parameter)
{
    (void)parameter;
    measured_input(m, "0x%llX", (unsigned long long)input[0]);
}

static long double depth_of(uint64_t depth)
{
    return ldexpl((long double)depth, -32);
}

/* ---- exp ---------------------------------------------------------------------------------- */

static double exp_error(const uint64_t depth[], unsigned unused)
{
    (void)unused;
    return (double)(fx_transmittance(depth[0]) - exp2l(31 - depth_of(depth[0])));
}

static void measure_exp(measured *m, unsigned parameter)
{
    static const search s = {exp_error, tell_number, 1, {DEPTH_MOST}};
    search_worst(m, &s, parameter);
}

static double exp16_error(const uint64_t depth[], unsigned unused)
{
    (void)unused;
    const long double exact = 65535 * exp2l(-ldexpl((long double)depth[0], -24));
    return (double)(fx_transmittance16((uint32_t)depth[0]) - exact);
}

static void measure_exp16(measured *m, unsigned parameter)
{
    static const search s = {exp16_error, tell_number, 1, {(uint64_t)20 << 24}};
    search_worst(m, &s, parameter);
}

/* ---- log ---------------------------------------------------------------------------------- */

static double log_error(const uint64_t t[], unsigned unused)
{
    (void)unused;
    if (t[0] == 0)
        return NO_SUCH_INPUT;
    const long double exact = -log2l((long double)t[0] / UINT32_MAX);
    return (double)ldexpl(depth_of(fx_depth_of_transmittance((uint32_t)t[0])) - exact, 28);
}

static void measure_log(measured *m, unsigned parameter)
{
    static const search s = {log_error, tell_number, 1, {UINT32_MAX}};
    search_worst(m, &s, parameter);
}

/* Of every opacity but the full one, whose depth is 64 by definition. */
static void measure_extinction(measured *m, unsigned full)
{
    for (uint32_t a = 0; a < full; a++) {
        const long double exact = -log1pl(-(long double)a / full) / LN_2;
        const fx_extinction found = full == 255 ? fx_extinction_of_unorm8((fx_unorm8)a)
                                                : fx_extinction_of_unorm16((fx_unorm16)a);
        if (measured_add(m, (double)(found - ldexpl(exact, 24))))
            measured_input(m, "%u", a);
    }
}

static double reciprocal_error(const uint64_t v[], unsigned unused)
{
    (void)unused;
    const uint32_t number = (uint32_t)v[0] + LEAST_RECIPROCAL;
    return (double)ldexpl(fx_reciprocal(number) * (long double)number / ldexpl(1, 58) - 1, 20);
}

static void tell_reciprocal(measured *m, const uint64_t v[], unsigned unused)
{
    (void)unused;
    measured_input(m, "0x%X", (unsigned)v[0] + LEAST_RECIPROCAL);
}

static void measure_reciprocal(measured *m, unsigned parameter)
{
    static const search s = {reciprocal_error, tell_reciprocal, 1, {(1u << 31) - LEAST_RECIPROCAL}};
    search_worst(m, &s, parameter);
}

/* ---- phi ---------------------------------------------------------------------------------- */

static long double phi(uint64_t depth)
{
    const long double t = depth_of(depth) * LN_2;
    return depth == 0 ? 1 : -expm1l(-t) / t;
}

static double phi_error(const uint64_t depth[], unsigned unused)
{
    (void)unused;
    return (double)ldexpl(ldexpl(fx_phi(depth[0]), -31) - phi(depth[0]), 16);
}

static void measure_phi(measured *m, unsigned parameter)
{
    static const search s = {phi_error, tell_number, 1, {(uint64_t)256 << 32}};
    search_worst(m, &s, parameter);
}

/* ---- Corrections -------------------------------------------------------------------------- */

static void tell_correction(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "opacity %u, ratio %u", (unsigned)input[0],
                   (unsigned)input[1] + FX_RATIO_LEAST);
}

/* log(1 - opacity) */
static long double logarithm(uint64_t opacity, uint32_t full)
{
    return log1pl(-(long double)opacity / full);
}

static double correct_error(const uint64_t input[], unsigned unused)
{
    (void)unused;
    const uint32_t ratio = (uint32_t)input[1] + FX_RATIO_LEAST;
    const long double exact = -expm1l(ldexpl(ratio, -16) * logarithm(input[0], 65535));
    return (double)(fx_correct_opacity((fx_unorm16)input[0], ratio) - 65535 * exact);
}

static double factor_error(const uint64_t input[], unsigned unused)
{
    (void)unused;
    const uint32_t ratio = (uint32_t)input[1] + FX_RATIO_LEAST;
    const long double r = ldexpl(ratio, -16), opacity = (long double)input[0] / 65535;
    const long double exact = input[0] == 0 ? r : -expm1l(r * logarithm(input[0], 65535)) / opacity;
    const long double found = ldexpl(fx_correct_colour((fx_unorm16)input[0], ratio), -27);
    return (double)ldexpl(found / exact - 1, 16);
}

static void measure_correct(measured *m, unsigned parameter)
{
    static const search s = {
        correct_error, tell_correction, 2, {65534, FX_RATIO_GREATEST - FX_RATIO_LEAST}};
    search_worst(m, &s, parameter);
}

static void measure_factor(measured *m, unsigned parameter)
{
    static const search s = {
        factor_error, tell_correction, 2, {65534, FX_RATIO_GREATEST - FX_RATIO_LEAST}};
    search_worst(m, &s, parameter);
}

/* For 256 slices in place of so many. */
enum { WANTED = 256 };

static double slices_error(const uint64_t opacity[], unsigned slices)
{
    const long double ratio = (long double)slices / WANTED;
    const long double exact = -expm1l(ratio * logarithm(opacity[0], UINT32_MAX));
    const uint32_t found = fx_correct_slices((uint32_t)opacity[0], slices, WANTED);
    return (double)ldexpl((long double)found / UINT32_MAX - exact, 28);
}

static void measure_slices(measured *m, unsigned slices)
{
    static const search s = {slices_error, tell_number, 1, {UINT32_MAX - 1}};
    search_worst(m, &s, slices);
}

/* ---- The chapter -------------------------------------------------------------------------- */

static const stage stages[] = {
    {"transmittance, exp", "depth u64.32 to u32.31", "table, cubic, shift; last to nearest",
     "2^-31", .78, 2, "search, depths to 40", measure_exp, 0, NULL},
    {"transmittance of 16 bits", "depth u32.24 to unorm16", "table, quadratic; last to nearest",
     "1/65535", .51, 2, "search, depths to 20", measure_exp16, 0, NULL},
    {"depth, log", "u32.32 to u64.32", "table, cubic", "2^-28", 1.5, 2, "search, all but 0",
     measure_log, 0, NULL},
    {"extinction of 8-bit opacity", "unorm8 to u32.24", "table, to nearest", "2^-24", .5, 2,
     "all 255", measure_extinction, 255, NULL},
    {"extinction of 16-bit opacity", "unorm16 to u32.24", "log; to nearest", "2^-24", .6, 2,
     "all 65535", measure_extinction, 65535, NULL},
    {"reciprocal", "u32.31 to u32.27", "table, product; cut", "2^-20 of it", 1.02, 2, "search",
     measure_reciprocal, 0, NULL},
    {"phi", "depth u64.32 to u32.31", "table, cubic; last to nearest", "2^-16", .02, 2,
     "search, depths to 256", measure_phi, 0, NULL},
    {"corrected opacity", "unorm16, ratio u32.16 to unorm16", "log, product, exp; to nearest",
     "1/65535", .505, 2, "search, ratios 1/16 to 16", measure_correct, 0, NULL},
    {"factor of colour", "unorm16, ratio u32.16 to u32.27", "phi, reciprocal; cut", "2^-16 of it",
     .4, 2, "search, ratios 1/16 to 16", measure_factor, 0, NULL},
    {"opacity for 256 slices, of 64", "u32.32 to u32.32", "log, product, exp", "2^-28", .36, 2,
     "search", measure_slices, 64, NULL},
    {"opacity for 256 slices, of 1024", "u32.32 to u32.32", "log, product, exp", "2^-28", 4.26, 2,
     "search", measure_slices, 1024, NULL},
};

const chapter chapter_depth = {
    "exp, log, phi and correction (SPEC 27 to 30, 47)",
    "**exp.** 2^g is a table's entry B, rounded by 1/2 of 2^-31, times 1 and a rise r / 64. The\n"
    "cubic misses r by 1.8 units of 2^-32, its three roundings by 2: by 1/64 of that, .06. The\n"
    "product is cut, by less than 1. So the power is off by -1.56 to .56 of 2^-31, half of it\n"
    "and the rounding of odd ones upwards give -.78 to .78; each whole part of a depth halves\n"
    "again. Of 16 bits the rounding is 1/2; base and place of 16 bits and the quadratic (2800\n"
    "of 2^-32, by 1/64) add 44 * 2^-32 and 2^-17 of the rise: below .01 of 1/65535.\n\n"
    "**log.** In units of 2^-31: the cubic misses by 8.9, its roundings by 1 up and 2 down, the\n"
    "table by 1/2, and it lies 1 too low to balance that the gap, cut, is up to 1 too great\n"
    "(1.49 in the depth) and that 2^32 - 1 stands for 1 (.72): 11.9 at most, 1.5 of 2^-28. For\n"
    "an extinction that is .1 of 2^-24, to the 1/2 of its rounding.\n\n"
    "**Reciprocal.** 1 / (1 - e) is (1 + e)(1 + e^2) but for e^4 <= 2^-20; cuts of 2^-27 of a\n"
    "number above 1 add .02 of that.\n\n"
    "**phi.** A cubic misses a segment of width h by |phi''''| h^4 / (4! 2^7), most at depth 8:\n"
    "h = 1, .0151 * 2^-16. Rounded coefficients add up to 2^-24 / 2^octave, the last place\n"
    "2^-32.\n\n"
    "**Corrections.** Opacity: its rounding, and 16 times the log's error times ln 2: .004.\n"
    "Colour: two phi, each within .16 of 2^-16 of itself, and a reciprocal, .0625 + .0013. For\n"
    "k times the slices: 1.5 k ln 2 of the log and .1 of exp, in 2^-28.\n",
    stages, COUNT(stages)};
