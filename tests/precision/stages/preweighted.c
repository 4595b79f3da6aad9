/*
 * preweighted.c - associated colours: the sums of a cell, and n equal samples one under or over
 * the other.
 */
#include "search.h"

#include "preweighted.h"

#include <string.h>

/* Numbers of an input: three fractions, eight opacities, eight colours, none above its opacity. */
enum { FRACTION = 0, OPACITY = 3, COLOUR = 11, NUMBERS = 19 };

typedef union cell {
    uint8_t voxel[8][4];
    uint32_t aligned;
} cell;

static void begin(qv_passage *passage, cell *made, const uint64_t input[], unsigned samples)
{
    memset(passage, 0, sizeof *passage);
    for (unsigned q = 0; q < 8; q++) {
        const uint64_t a = input[OPACITY + q], k = input[COLOUR + q];
        memset(made->voxel[q], (int)(k < a ? k : a), 3);
        made->voxel[q][3] = (uint8_t)a;
    }
    for (unsigned axis = 0; axis < 3; axis++) {
        passage->next[axis] = 4 << axis;
        passage->place[axis] = (uint32_t)input[axis] << 24;
    }
    passage->base = made->voxel[0];
    passage->transmittance = QV_UNDIMMED;
    passage->samples = samples;
}

/* ---- Sums --------------------------------------------------------------------------------- */

static double exact_opacity(const uint64_t input[])
{
    double sum = 0;
    for (unsigned q = 0; q < 8; q++) {
        double weight = 1;
        for (unsigned axis = 0; axis < 3; axis++)
            weight *= (double)((q >> axis & 1) != 0 ? input[axis] : 256 - input[axis]) / 256;
        sum += weight * (double)input[OPACITY + q];
    }
    return sum;
}

/* One sample, which gets all light: its opacity in levels. */
static double sum_error(const uint64_t input[], unsigned unused)
{
    qv_passage passage;
    cell made;
    (void)unused;
    begin(&passage, &made, input, 1);
    qv_passage_under(&passage);
    return ldexp(QV_UNDIMMED - passage.transmittance, -24) - exact_opacity(input);
}

/* ---- n samples ---------------------------------------------------------------------------- */

/* Opacity and colour of the sample by the sums as they are: those have an error of their own. */
static void sample_of(double sample[2], const uint64_t input[])
{
    qv_passage passage;
    qv_ends ends;
    cell made;
    begin(&passage, &made, input, 1);
    qv_passage_next(&ends, &passage);
    const uint32_t x = ends.fraction;
    const uint32_t opacity =
        (ends.low.green_opacity >> 16) * (256 - x) + (ends.high.green_opacity >> 16) * x;
    const uint32_t colour =
        (ends.low.green_opacity & 0xFFFF) * (256 - x) + (ends.high.green_opacity & 0xFFFF) * x;
    sample[0] = opacity / (256 * 65280.);
    sample[1] = colour / (256 * 65280.);
}

/* What n of them let through. */
static double left(double opacity, unsigned n)
{
    return n * log1p(-opacity) < -700 ? 0 : exp(n * log1p(-opacity));
}

static double transmittance_error(const uint64_t input[], unsigned n)
{
    qv_passage passage;
    cell made;
    double sample[2];
    sample_of(sample, input);
    begin(&passage, &made, input, n);
    qv_passage_under(&passage);
    const double found = ldexp((double)passage.transmittance - QV_NOTHING, -24);
    return found - 255 * left(sample[0], n);
}

static double light_error(const uint64_t input[], unsigned n, void (*composite)(qv_passage *))
{
    qv_passage passage;
    cell made;
    double sample[2];
    sample_of(sample, input);
    if (sample[0] <= 0)
        return NO_SUCH_INPUT;
    begin(&passage, &made, input, n);
    composite(&passage);
    const double exact = 255 * sample[1] * (1 - left(sample[0], n)) / sample[0];
    return ldexp(passage.light[1], -24) - exact;
}

static double under_error(const uint64_t input[], unsigned n)
{
    return light_error(input, n, qv_passage_under);
}

static double over_error(const uint64_t input[], unsigned n)
{
    return light_error(input, n, qv_passage_over);
}

/* ---- Searches ----------------------------------------------------------------------------- */

static void tell(measured *m, const uint64_t input[], unsigned unused)
{
    unsigned a[8], k[8];
    (void)unused;
    for (unsigned q = 0; q < 8; q++) {
        a[q] = (unsigned)input[OPACITY + q];
        k[q] = (unsigned)(input[COLOUR + q] < a[q] ? input[COLOUR + q] : a[q]);
    }
    measured_input(m, "f %u %u %u; A %X %X %X %X %X %X %X %X; K %X %X %X %X %X %X %X %X",
                   (unsigned)input[0], (unsigned)input[1], (unsigned)input[2], a[0], a[1], a[2],
                   a[3], a[4], a[5], a[6], a[7], k[0], k[1], k[2], k[3], k[4], k[5], k[6], k[7]);
}

static void find(measured *m, search_error *error, unsigned n)
{
    search s = {error, tell, NUMBERS, {0}};
    for (unsigned i = 0; i < NUMBERS; i++)
        s.most[i] = 255;
    search_worst(m, &s, n);
}

#define MEASURE(name)                                                                              \
    static void measure_##name(measured *m, unsigned n)                                            \
    {                                                                                              \
        find(m, name##_error, n);                                                                  \
    }

MEASURE(sum)
MEASURE(transmittance)
MEASURE(under)
MEASURE(over)

/* ---- The chapter -------------------------------------------------------------------------- */

/* Levels that a sample may lose by a cut of a share, and by those of all samples together. */
#define CUT (65280. / 16777216)
#define ROWS(n)                                                                                    \
    {"associated transmittance, n = " #n,                                                          \
     "unorm8 to u32",                                                                              \
     "shares, cut",                                                                                \
     "1/255",                                                                                      \
     CUT * (n + 1.01),                                                                             \
     4,                                                                                            \
     "search, n equal ones",                                                                       \
     measure_transmittance,                                                                        \
     n,                                                                                            \
     NULL},                                                                                        \
        {"associated light under, n = " #n,                                                        \
         "unorm8 to u32",                                                                          \
         "shares, cut",                                                                            \
         "1/255",                                                                                  \
         2 * CUT * (n + 1.01),                                                                     \
         4,                                                                                        \
         "search, n equal ones",                                                                   \
         measure_under,                                                                            \
         n,                                                                                        \
         NULL},                                                                                    \
    {                                                                                              \
        "associated light over, n = " #n, "unorm8 to u32", "sums and shares, cut", "1/255",        \
            2 * CUT *(n + 1.01), 4, "search, n equal ones", measure_over, n, NULL                  \
    }

static const stage stages[] = {
    {"associated sums of a cell", "8 entries unorm8, fractions u8.8 to u16.16",
     "one product of 8 bits, to nearest", "1/255", .9961, 2, "search", measure_sum, 0, NULL},
    ROWS(4),
    ROWS(16),
    ROWS(64),
};

const chapter chapter_preweighted = {
    "Preweighted sampling (SPEC 70)",
    "**Sums.** Of the weights between rows only y z is rounded, by 1/512, and its error stands\n"
    "with both signs twice: 1/512 of |v - v - v + v| <= 510 levels, .9961. The error of the\n"
    "storage, half a level of the weighted colour, comes before it and is no stage's: see\n"
    "section 2.\n\n"
    "**n samples.** What gets through is parted between a cell's ends in whole numbers below\n"
    "65536: the cut of a part costs less than 65280 / 2^24 = .0039 of a level a sample, that of\n"
    "the share 1.01 of it in all, as its samples sum up to 1. Light loses the same, and once\n"
    "more what the error of the transmittance adds. Over, the sample is cut in place of the\n"
    "parts.\n",
    stages, COUNT(stages)};
