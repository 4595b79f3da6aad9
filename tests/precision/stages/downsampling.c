/*
 * downsampling.c - the mean of eight voxels, and pyramids of several levels.
 */
#include "search.h"

#include "qvol.h"

#include <stdlib.h>
#include <string.h>

#define LN_2 0.693147180559945309417232121458176568L

/* ---- One level ---------------------------------------------------------------------------- */

/* Numbers of an input: eight opacities, eight colours. */
enum { OPACITY = 0, COLOUR = 8, NUMBERS = 16 };

typedef uint16_t entry[4];

static void describe(qv_volume *volume, entry *voxels, unsigned edge)
{
    memset(volume, 0, sizeof *volume);
    volume->voxels = (qv_address)voxels;
    volume->voxels_bytes = sizeof(entry) * edge * edge * edge;
    volume->storage = QV_STORAGE_RGBA16;
    for (unsigned axis = 0, step = sizeof(entry); axis < 3; axis++, step *= edge) {
        volume->size[axis] = (uint16_t)edge;
        volume->stride[axis] = (int32_t)step;
    }
}

static void halve(entry *coarser, entry *finer, unsigned edge, const qv_domain *domain)
{
    qv_volume volume;
    const unsigned half = edge / 2;
    describe(&volume, finer, edge);
    (void)qv_downsample(coarser, sizeof(entry) * half * half * half, &volume, &qv_filter_box2,
                        domain, 0, (uint16_t)half);
}

/* The library's mean of eight voxels. */
static void mean_of(entry mean, const uint64_t input[], const qv_domain *domain)
{
    entry voxels[8];
    for (unsigned i = 0; i < 8; i++) {
        for (unsigned c = 0; c < 3; c++)
            voxels[i][c] = (uint16_t)input[COLOUR + i];
        voxels[i][3] = (uint16_t)input[OPACITY + i];
    }
    halve((entry *)mean, voxels, 2, domain);
}

static double opacity_error(const uint64_t input[], unsigned unused)
{
    entry mean;
    uint64_t sum = 0;
    (void)unused;
    mean_of(mean, input, &qv_domain_stored);
    for (unsigned i = 0; i < 8; i++)
        sum += input[OPACITY + i];
    return mean[3] - (double)sum / 8;
}

static double colour_error(const uint64_t input[], unsigned unused)
{
    entry mean;
    uint64_t sum = 0, weighted = 0;
    (void)unused;
    mean_of(mean, input, &qv_domain_stored);
    for (unsigned i = 0; i < 8; i++) {
        sum += input[OPACITY + i];
        weighted += input[OPACITY + i] * input[COLOUR + i];
    }
    if (sum == 0)
        return NO_SUCH_INPUT;
    return mean[0] - (double)weighted / (double)sum;
}

/* 64 for full opacity, as the library has it. */
static long double extinction_of(uint64_t opacity)
{
    return opacity == 65535 ? 64 : -log1pl(-(long double)opacity / 65535) / LN_2;
}

static double extinction_error(const uint64_t input[], unsigned unused)
{
    entry mean;
    long double sum = 0;
    (void)unused;
    mean_of(mean, input, &qv_domain_extinction);
    for (unsigned i = 0; i < 8; i++)
        sum += extinction_of(input[OPACITY + i]);
    return (double)(mean[3] + 65535 * expm1l(-sum / 8 * LN_2));
}

static void tell(measured *m, const uint64_t input[], unsigned unused)
{
    unsigned a[8], k[8];
    (void)unused;
    for (unsigned i = 0; i < 8; i++) {
        a[i] = (unsigned)input[OPACITY + i];
        k[i] = (unsigned)input[COLOUR + i];
    }
    measured_input(m, "A %X %X %X %X %X %X %X %X; K %X %X %X %X %X %X %X %X", a[0], a[1], a[2],
                   a[3], a[4], a[5], a[6], a[7], k[0], k[1], k[2], k[3], k[4], k[5], k[6], k[7]);
}

static void find(measured *m, search_error *error)
{
    search s = {error, tell, NUMBERS, {0}};
    for (unsigned i = 0; i < NUMBERS; i++)
        s.most[i] = 65535;
    search_worst(m, &s, 0);
}

static void measure_opacity(measured *m, unsigned unused)
{
    (void)unused;
    find(m, opacity_error);
}

static void measure_colour(measured *m, unsigned unused)
{
    (void)unused;
    find(m, colour_error);
}

static void measure_extinction(measured *m, unsigned unused)
{
    (void)unused;
    find(m, extinction_error);
}

/* ---- Several levels ----------------------------------------------------------------------- */

enum {
    LEVELS_MOST = 5,
    EDGE_MOST = 1 << LEVELS_MOST,
    VOXELS_MOST = EDGE_MOST * EDGE_MOST * EDGE_MOST
};

static entry voxels[2][VOXELS_MOST];

/* The only voxel of the coarsest level. */
static const uint16_t *reduce(unsigned levels)
{
    unsigned from = 0;
    for (unsigned edge = 1u << levels; edge > 1; edge /= 2, from ^= 1)
        halve(voxels[from ^ 1], voxels[from], edge, &qv_domain_stored);
    return voxels[from][0];
}

/* The true mean of opacity, and of colour weighted by it. */
static void true_mean(double mean[2], unsigned levels)
{
    const unsigned count = 1u << 3 * levels;
    uint64_t sum = 0, weighted = 0;
    for (unsigned i = 0; i < count; i++) {
        sum += voxels[0][i][3];
        weighted += (uint64_t)voxels[0][i][3] * voxels[0][i][0];
    }
    mean[0] = (double)sum / count;
    mean[1] = sum == 0 ? 0 : (double)weighted / (double)sum;
}

static int measure_levels(measured *m, unsigned levels, unsigned which)
{
    double mean[2];
    true_mean(mean, levels);
    const uint16_t *found = reduce(levels);
    return measured_add(m, found[which == 0 ? 3 : 0] - mean[which]);
}

static void fill_random(unsigned levels, uint64_t *state, uint32_t least)
{
    for (unsigned i = 0; i < 1u << 3 * levels; i++) {
        const uint64_t number = random64(state);
        voxels[0][i][0] = (uint16_t)number;
        voxels[0][i][3] = (uint16_t)(least + (number >> 16) % (65536 - least));
    }
}

/*
 * Of the eight parts of each voxel of each coarser level, so many are 1 more than the others.
 * With four, each mean ends in 1/2 and is rounded upwards; with three, in 3/8 and downwards. So
 * level l is off by l / 2, or 3 l / 8.
 */
static unsigned ones_above(unsigned place, unsigned levels, unsigned many)
{
    const unsigned edge = 1u << LEVELS_MOST;
    unsigned sum = 0;
    for (unsigned bit = 0; bit < levels; bit++) {
        const unsigned x = place >> bit & 1, y = place / edge >> bit & 1;
        const unsigned z = place / edge / edge >> bit & 1;
        sum += 4 * z + 2 * y + x < many;
    }
    return sum;
}

/* A voxel's place in a cube of the greatest edge. */
static unsigned place_of(unsigned i, unsigned levels)
{
    const unsigned edge = 1u << levels, most = 1u << LEVELS_MOST;
    return i % edge + most * (i / edge % edge + most * (i / edge / edge));
}

static void fill_halves(unsigned levels)
{
    for (unsigned i = 0; i < 1u << 3 * levels; i++) {
        voxels[0][i][0] = 0;
        voxels[0][i][3] = (uint16_t)(1000 + ones_above(place_of(i, levels), levels, 4));
    }
}

enum { RANDOM_PYRAMIDS = 50 };

static void measure_pyramid_opacity(measured *m, unsigned levels)
{
    uint64_t state = levels;
    for (unsigned i = 0; i < RANDOM_PYRAMIDS; i++) {
        fill_random(levels, &state, 0);
        if (measure_levels(m, levels, 0))
            measured_input(m, "random pyramid %u", i);
    }
    fill_halves(levels);
    if (measure_levels(m, levels, 0))
        measured_input(m, "of 1000 and more, all means end in 1/2");
}

/* White, whose opacities are rounded upwards on each level but the last, above black, whose
   opacities are rounded downwards. */
static void fill_unequal(unsigned levels, unsigned least)
{
    const unsigned count = 1u << 3 * levels;
    for (unsigned i = 0; i < count; i++) {
        const unsigned white = i >= count / 2;
        const unsigned ones = ones_above(place_of(i, levels), levels - 1, white != 0 ? 4 : 3);
        voxels[0][i][0] = (uint16_t)(white != 0 ? 65535 : 0);
        voxels[0][i][3] = (uint16_t)(least + ones);
    }
}

/* Opacities of 256 and more. */
static void measure_pyramid_colour(measured *m, unsigned levels)
{
    enum { LEAST = 256 };
    uint64_t state = levels;
    for (unsigned i = 0; i < RANDOM_PYRAMIDS; i++) {
        fill_random(levels, &state, LEAST);
        if (measure_levels(m, levels, 1))
            measured_input(m, "random pyramid %u", i);
    }
    fill_unequal(levels, LEAST);
    if (measure_levels(m, levels, 1))
        measured_input(m, "white rounded upwards above black rounded downwards");
}

/* Seven blocks of white with three voxels of opacity 1, whose mean is rounded to nothing, and one
   of black with four, which is rounded to 1. */
static void measure_lost_colour(measured *m, unsigned levels)
{
    for (unsigned i = 0; i < 1u << 3 * levels; i++) {
        const unsigned place = place_of(i, levels), edge = 1u << LEVELS_MOST;
        const unsigned white =
            (place / 2) % (edge / 2) + place / edge / 2 % (edge / 2) + place / edge / edge / 2;
        voxels[0][i][0] = (uint16_t)(white != 0 ? 65535 : 0);
        voxels[0][i][3] = (uint16_t)ones_above(place, 1, white != 0 ? 3 : 4);
    }
    if (measure_levels(m, levels, 1))
        measured_input(m, "opacities 0 and 1: white rounded to nothing, black to 1");
}

/* ---- The chapter -------------------------------------------------------------------------- */

#define PYRAMID(l)                                                                                 \
    {"opacity, " #l " levels",                                                                     \
     "unorm16",                                                                                    \
     "to nearest on each",                                                                         \
     "1/65535",                                                                                    \
     l / 2.,                                                                                       \
     4,                                                                                            \
     "random; all halves upwards",                                                                 \
     measure_pyramid_opacity,                                                                      \
     l,                                                                                            \
     NULL},                                                                                        \
    {                                                                                              \
        "colour, " #l " levels, opacity >= 256", "unorm16", "to nearest on each", "1/65535",       \
            l / 2. + (l - 1) * 64., 4, "random; roundings against each other",                     \
            measure_pyramid_colour, l, NULL                                                        \
    }

static const stage stages[] = {
    {"mean opacity", "8 unorm16", "to nearest", "1/65535", .5, 2, "search", measure_opacity, 0,
     NULL},
    {"mean colour, by opacity", "8 unorm16 pairs", "quotient, to nearest", "1/65535", .5, 2,
     "search", measure_colour, 0, NULL},
    {"mean opacity, by extinction", "8 unorm16", "log, mean, exp; to nearest", "1/65535", .511, 2,
     "search", measure_extinction, 0, NULL},
    {"colour, 2 levels, any opacity", "unorm16", "to nearest on each", "1/65535", 65535, 4,
     "one pyramid", measure_lost_colour, 2, NULL},
    PYRAMID(2),
    PYRAMID(3),
    PYRAMID(5),
};

const chapter chapter_downsampling = {
    "Downsampling (SPEC 34)",
    "**One level.** Sums are exact; mean and colour are one quotient each, to nearest. By\n"
    "extinction log and mean are within 1.1 of 2^-24 of depth, below .01 of 1/65535, and exp of\n"
    "16 bits .51.\n\n"
    "**l levels.** A mean carries the errors of what it is made of, no more: l / 2 for opacity.\n"
    "A colour is weighted by opacities that are rounded from the second level on. Of opacities\n"
    "of a and more they are 1 / (2 a) off, in part: where those of bright voxels are rounded\n"
    "upwards, and of dark ones downwards, that shifts the colour by 65535 / (4 a) a level. With\n"
    "a = 256 it is 64; below, it grows, until opacity 1/2 of 65535 is rounded to 0 or 1 and its\n"
    "colour is lost or counts twice.\n",
    stages, COUNT(stages)};
