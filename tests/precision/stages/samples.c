/*
 * samples.c - what interpolation makes of eight voxels: opacity, or extinction, and light. All
 * sums of the true values are of products of whole numbers, exact in a long double.
 */
#include "search.h"

#include "sample.h"

#include <string.h>

#define LN_2 0.693147180559945309417232121458176568L

/* Numbers of an input: three fractions, eight opacities, eight colours. */
enum { FRACTION = 0, OPACITY = 3, COLOUR = 11, NUMBERS = 19 };

/* Entries that are all grey, as the library finds them. */
typedef struct cell {
    union {
        uint8_t narrow[8][4];
        uint16_t wide[8][4];
    } entry;
    qv_address corner[8];
    fx_fraction fraction[3];
} cell;

static void make_cell(cell *made, const uint64_t input[], unsigned storage)
{
    const int wide = qv_channel_bytes(storage) == 2;
    for (unsigned q = 0; q < 8; q++) {
        for (unsigned c = 0; c < 4; c++) {
            const uint64_t channel = input[(c < 3 ? COLOUR : OPACITY) + q];
            if (wide)
                made->entry.wide[q][c] = (uint16_t)channel;
            else
                made->entry.narrow[q][c] = (uint8_t)channel;
        }
        made->corner[q] = wide ? (qv_address)made->entry.wide[q] : made->entry.narrow[q];
    }
    for (unsigned axis = 0; axis < 3; axis++)
        made->fraction[axis] = fx_fraction_of((uint32_t)input[FRACTION + axis]);
}

/* The library's sample; 0 where there is nothing to see. */
static int interpolate(qv_sample *sample, const uint64_t input[], unsigned storage,
                       qv_factor factor)
{
    cell made;
    make_cell(&made, input, storage);
    if (!qv_interpolate_corners(sample, made.corner, made.fraction, storage, factor))
        return 0;
    if (factor == QV_BY_WEIGHT)
        qv_associate_light(sample, storage);
    return 1;
}

static long double weight_of(unsigned q, const uint64_t input[])
{
    long double weight = 1;
    for (unsigned axis = 0; axis < 3; axis++)
        weight *= (q >> axis & 1) != 0 ? input[axis] : 256 - input[axis];
    return weight / (1 << 24);
}

static long double full_of(unsigned storage)
{
    return qv_channel_bytes(storage) == 2 ? 65535 : 255;
}

/* ---- By opacity, and apart ---------------------------------------------------------------- */

/* The true mean of opacity, colour, and their product, in levels. */
static void true_means(long double mean[3], const uint64_t input[], unsigned storage)
{
    mean[0] = mean[1] = mean[2] = 0;
    for (unsigned q = 0; q < 8; q++) {
        const long double weight = weight_of(q, input);
        mean[0] += weight * input[OPACITY + q];
        mean[1] += weight * input[COLOUR + q];
        mean[2] += weight * (input[OPACITY + q] * input[COLOUR + q]);
    }
    mean[2] /= full_of(storage);
}

static double opacity_error(const uint64_t input[], unsigned storage)
{
    qv_sample sample;
    long double mean[3];
    if (!interpolate(&sample, input, storage, QV_BY_SHARE))
        return NO_SUCH_INPUT;
    true_means(mean, input, storage);
    return (double)(fx_share_bits(sample.opacity) / 65536.L - mean[0]);
}

/* Light in levels: its unit is 65536 * 255^2 or 65535^2. */
static long double light_of(const qv_sample *sample, unsigned storage)
{
    const long double one = qv_channel_bytes(storage) == 2 ? 65535 : 65536 * 255.L;
    return fx_sum_bits(sample->light[0]) / one;
}

static double weighted_error(const uint64_t input[], unsigned storage)
{
    qv_sample sample;
    long double mean[3];
    if (!interpolate(&sample, input, storage, QV_BY_SHARE))
        return NO_SUCH_INPUT;
    true_means(mean, input, storage);
    return (double)(light_of(&sample, storage) - mean[2]);
}

static double separate_error(const uint64_t input[], unsigned storage)
{
    qv_sample sample;
    long double mean[3];
    if (!interpolate(&sample, input, storage, QV_BY_WEIGHT))
        return NO_SUCH_INPUT;
    true_means(mean, input, storage);
    return (double)(light_of(&sample, storage) - mean[0] * mean[1] / full_of(storage));
}

/* Fractions with 16 bits, which cutting after 1/512 rounds to 8; those that round to the next cell
   belong to that. */
static double position_error(const uint64_t input[], unsigned storage)
{
    uint64_t rounded[NUMBERS];
    qv_sample sample;
    long double mean = 0;
    memcpy(rounded, input, sizeof rounded);
    for (unsigned axis = 0; axis < 3; axis++) {
        rounded[axis] = (input[axis] + 128) >> 8;
        if (rounded[axis] > 255)
            return NO_SUCH_INPUT;
    }
    if (!interpolate(&sample, rounded, storage, QV_BY_SHARE))
        return NO_SUCH_INPUT;
    for (unsigned q = 0; q < 8; q++) {
        long double weight = 1;
        for (unsigned axis = 0; axis < 3; axis++)
            weight *= (q >> axis & 1) != 0 ? input[axis] : 65536 - input[axis];
        mean += ldexpl(weight, -48) * input[OPACITY + q];
    }
    return (double)(fx_share_bits(sample.opacity) / 65536.L - mean);
}

/* ---- By extinction of opacities ----------------------------------------------------------- */

/* Of full opacity it is 64. */
static long double extinction_of(uint64_t opacity, long double full)
{
    return opacity == full ? 64 : -log1pl(-(long double)opacity / full) / LN_2;
}

typedef long double weigh(unsigned q, const uint64_t input[]);

/* As the library rounds it, whose error is a stage of its own. */
static long double rounded_weight(unsigned q, const uint64_t input[])
{
    fx_weight weight[8];
    fx_fraction fraction[3];
    for (unsigned axis = 0; axis < 3; axis++)
        fraction[axis] = fx_fraction_of((uint32_t)input[FRACTION + axis]);
    qv_weights(weight, fraction);
    return fx_weight_bits(weight[q]) / 65536.L;
}

/* Errors in 2^-24 of depth. */
static double extinction_error(const uint64_t input[], unsigned storage, int of_light,
                               weigh *weight)
{
    const long double full = full_of(storage);
    qv_sample sample;
    long double sum = 0;
    if (!interpolate(&sample, input, storage, QV_BY_DENSITY))
        return NO_SUCH_INPUT;
    for (unsigned q = 0; q < 8; q++)
        sum += weight(q, input) * extinction_of(input[OPACITY + q], full) *
               (of_light ? input[COLOUR + q] / full : 1);
    const long double found =
        of_light ? fx_sum_bits(sample.light[0]) * (65536.L / 65535) : fx_share_bits(sample.opacity);
    return (double)(ldexpl(found, -1 - (int)sample.scale) - ldexpl(sum, 24));
}

static double density_error(const uint64_t input[], unsigned storage)
{
    return extinction_error(input, storage, 0, rounded_weight);
}

static double dense_light_error(const uint64_t input[], unsigned storage)
{
    return extinction_error(input, storage, 1, rounded_weight);
}

/* Both with the rounding of the weights: in 2^-10 of depth. */
static double whole_density_error(const uint64_t input[], unsigned storage)
{
    return ldexp(extinction_error(input, storage, 0, weight_of), -14);
}

static double whole_light_error(const uint64_t input[], unsigned storage)
{
    return ldexp(extinction_error(input, storage, 1, weight_of), -14);
}

/* ---- Searches ----------------------------------------------------------------------------- */

static void tell(measured *m, const uint64_t input[], unsigned storage)
{
    unsigned long long opacity[8], colour[8];
    (void)storage;
    for (unsigned q = 0; q < 8; q++) {
        opacity[q] = input[OPACITY + q];
        colour[q] = input[COLOUR + q];
    }
    measured_input(m,
                   "f %u %u %u; A %llX %llX %llX %llX %llX %llX %llX %llX; K %llX %llX %llX "
                   "%llX %llX %llX %llX %llX",
                   (unsigned)input[0], (unsigned)input[1], (unsigned)input[2], opacity[0],
                   opacity[1], opacity[2], opacity[3], opacity[4], opacity[5], opacity[6],
                   opacity[7], colour[0], colour[1], colour[2], colour[3], colour[4], colour[5],
                   colour[6], colour[7]);
}

static void find(measured *m, search_error *error, unsigned storage)
{
    search s = {error, tell, NUMBERS, {255, 255, 255}};
    for (unsigned i = OPACITY; i < NUMBERS; i++)
        s.most[i] = qv_channel_bytes(storage) == 2 ? 65535 : 255;
    search_worst(m, &s, storage);
}

#define MEASURE(name)                                                                              \
    static void measure_##name(measured *m, unsigned storage)                                      \
    {                                                                                              \
        find(m, name##_error, storage);                                                            \
    }

MEASURE(opacity)
MEASURE(weighted)
MEASURE(separate)
MEASURE(density)
MEASURE(dense_light)
MEASURE(whole_density)
MEASURE(whole_light)

static void measure_position(measured *m, unsigned storage)
{
    search s = {position_error, tell, NUMBERS, {65535, 65535, 65535}};
    for (unsigned i = OPACITY; i < NUMBERS; i++)
        s.most[i] = 255;
    search_worst(m, &s, storage);
}

/* Opacity as u32.32 of every sum of 8 bits, and of those of 16 bits that are searched. */
static double q32_error(const uint64_t opacity[], unsigned storage)
{
    const long double unit = 65536 * full_of(storage);
    const uint32_t found = qv_opacity_q32(fx_share_of((uint32_t)opacity[0]), storage);
    const long double exact = ldexpl(opacity[0] / unit, 32);
    return opacity[0] == (uint64_t)unit && found == UINT32_MAX ? 0 : (double)(found - exact);
}

static void tell_opacity(measured *m, const uint64_t input[], unsigned unused)
{
    (void)unused;
    measured_input(m, "%llu", (unsigned long long)input[0]);
}

static void measure_q32(measured *m, unsigned storage)
{
    const search s = {q32_error, tell_opacity, 1, {(uint64_t)(65536 * full_of(storage))}};
    search_worst(m, &s, storage);
}

/* ---- The chapter -------------------------------------------------------------------------- */

#define FORMATS8     "8 entries unorm8, fractions u8.8 to u32"
#define FORMATS16    "8 entries unorm16, fractions u8.8 to u32"
#define OF_WEIGHTS8  "8 entries unorm8, 8 weights u17.16 to u32"
#define OF_WEIGHTS16 "8 entries unorm16, 8 weights u17.16 to u32"
#define IN           "search"

static const stage stages[] = {
    {"opacity at a rounded position", "8 entries unorm8, position to u8.8", "position, to nearest",
     "1/255", 1.502, 2, "search, f in 2^-16", measure_position, QV_STORAGE_RGBA8, NULL},
    {"opacity, 8 bits", FORMATS8, "none but the weights'", "1/255", .0078, 2, IN, measure_opacity,
     QV_STORAGE_RGBA8, NULL},
    {"opacity, 16 bits", FORMATS16, "none but the weights'", "1/65535", 2, 2, IN, measure_opacity,
     QV_STORAGE_RGBA16, NULL},
    {"light by opacity, 8 bits", FORMATS8, "none but the weights'", "1/255", .0078, 2, IN,
     measure_weighted, QV_STORAGE_RGBA8, NULL},
    {"light by opacity, 16 bits", FORMATS16, "8 products, cut", "1/65535", 2.0002, 2, IN,
     measure_weighted, QV_STORAGE_RGBA16, NULL},
    {"light, separate, 8 bits", FORMATS8, "product of sums, to nearest", "1/255", .0156, 2, IN,
     measure_separate, QV_STORAGE_RGBA8, NULL},
    {"light, separate, 16 bits", FORMATS16, "product of sums, to nearest", "1/65535", 4, 2, IN,
     measure_separate, QV_STORAGE_RGBA16, NULL},
    {"extinction of opacities, 8 bits", OF_WEIGHTS8, "8 products, to nearest", "2^-24 of depth", 3,
     2, IN, measure_density, QV_STORAGE_RGBA8, NULL},
    {"extinction of opacities, 16 bits", OF_WEIGHTS16, "8 products, to nearest", "2^-24 of depth",
     3, 2, IN, measure_density, QV_STORAGE_RGBA16, NULL},
    {"light by extinction, 8 bits", OF_WEIGHTS8, "8 products twice, cut", "2^-24 of depth", 7, 2,
     IN, measure_dense_light, QV_STORAGE_RGBA8, NULL},
    {"light by extinction, 16 bits", OF_WEIGHTS16, "8 products twice, cut", "2^-24 of depth", 7, 2,
     IN, measure_dense_light, QV_STORAGE_RGBA16, NULL},
    {"extinction, weights too, 16 bits", FORMATS16, "weights; products", "2^-10 of depth", 2.0002,
     2, IN, measure_whole_density, QV_STORAGE_RGBA16, NULL},
    {"light by extinction, weights too, 16 bits", FORMATS16, "weights; products", "2^-10 of depth",
     2.0005, 2, IN, measure_whole_light, QV_STORAGE_RGBA16, NULL},
    {"opacity as u32.32, 8 bits", "u32 to u32.32", "three terms, cut", "2^-32", 3, 2, IN,
     measure_q32, QV_STORAGE_RGBA8, NULL},
    {"opacity as u32.32, 16 bits", "u32 to u32.32", "two terms, cut", "2^-32", 3, 2, IN,
     measure_q32, QV_STORAGE_RGBA16, NULL},
};

const chapter chapter_samples = {
    "Interpolation and weighting (SPEC 10, 12, 13, 41)",
    "**Position.** On each axis it is rounded to 1/256 voxel, by 1/512, in which a value of 0\n"
    ".. 1 changes by at most 1/512: three axes, 3 * 255 / 512 of a level, and .0078 as follows.\n\n"
    "**By opacity.** The eight weights share one error e, at most 1/2 of 2^-16, with the sign +\n"
    "at corners 1, 2, 4, 7 and - at the others, so that a mean of values 0 .. v is off by at\n"
    "most 4 v / 2 / 65536: with v = 255, .0078 of a level; with v = 65535, 2 levels of 65535.\n"
    "All sums of 8 bits are exact otherwise. Of 16 bits, eight products lose less than 1 of\n"
    "65535^2 each, 8 / 65535 of a level.\n\n"
    "**Separate.** Both factors of the product have that error, and the product is rounded\n"
    "once.\n\n"
    "**By extinction.** The largest extinction is doubled s times until it has 30 bits. In\n"
    "units of 2^-24 of depth each of the eight products is off by 1/4 * 2^-s; those of\n"
    "extinctions that are not full have s >= 1, and the table's error of at most .6, weighted;\n"
    "with full opacity s is 0 and it is 1 low: 8 / 4 + 1 = 3. Light cuts eight products more,\n"
    "by 1/2 each at s = 0. That is for the weights as they are: their error e, as above, moves\n"
    "a mean of extinctions 0 .. 64 by up to 4 * 64 / 2 / 65536, 2 of 2^-10 of depth.\n\n"
    "**Opacity as u32.32.** 2^32 / unit as a series of powers of 2^-8 or 2^-16: two cuts of\n"
    "less than 1, and what the series leaves out, less than 1.\n",
    stages, COUNT(stages)};
