/*
 * fog_figures.c - the figures of one fog: what accumulates over slices of one opacity, and
 * what two bricks of it make where they overlap.
 */
#include "dithering.h"

#include <math.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* ---- The figures -------------------------------------------------------------- */

typedef enum figure_kind {
    ACCUMULATED, /* over the number of slices */
    PAIR,        /* the same for two bricks, one from each side */
    BRICKS,      /* two bricks combined */
    SCAN_LINE    /* the same, and what lies beside the overlap */
} figure_kind;

static const char *const kind_names[] = {"accumulated", "pair", "bricks", "line"};

typedef struct figure {
    int number;
    figure_kind kind;
    uint32_t slices;
    double opacity;
    unsigned published; /* the paper's curves */
    double slope[2];
    bool bumping;
    uint32_t chunk; /* slices that are blended at a time; 0: all */
} figure;

/* What the paper shows: without dither, with its dithers, or with both. */
#define NONE    SHOWS(PLAIN)
#define DITHERS (SHOWS(ORDERED) | SHOWS(RANDOM))
#define ALL     (NONE | DITHERS)
#define SOME    (NONE | SHOWS(ORDERED))

#define PLAIN_SLOPE {1, 1}, false, 0

static const figure figures[] = {
    {5, ACCUMULATED, 200, 1, NONE, PLAIN_SLOPE},
    {7, BRICKS, 200, 1, NONE, PLAIN_SLOPE},
    {8, PAIR, 200, 1, NONE, PLAIN_SLOPE},
    {9, SCAN_LINE, 400, 1, NONE, PLAIN_SLOPE},
    {10, ACCUMULATED, 200, 5, NONE, PLAIN_SLOPE},
    {11, ACCUMULATED, 200, 10, NONE, PLAIN_SLOPE},
    {12, BRICKS, 200, 5, NONE, PLAIN_SLOPE},
    {13, BRICKS, 200, 10, NONE, PLAIN_SLOPE},
    {14, BRICKS, 1000, 1, NONE, PLAIN_SLOPE},
    {15, PAIR, 1000, 1, NONE, PLAIN_SLOPE},
    {16, ACCUMULATED, 1000, .1, DITHERS, PLAIN_SLOPE},
    {17, BRICKS, 1000, .1, DITHERS, PLAIN_SLOPE},
    {18, ACCUMULATED, 1000, .5, ALL, PLAIN_SLOPE},
    {19, BRICKS, 1000, .5, DITHERS, PLAIN_SLOPE},
    {20, BRICKS, 1000, .75, DITHERS, PLAIN_SLOPE},
    {21, BRICKS, 1000, 1.5, DITHERS, PLAIN_SLOPE},
    {22, ACCUMULATED, 1000, .5, DITHERS, {1, 1}, true, 0},
    {23, ACCUMULATED, 1000, .5, DITHERS, {.75, 1}, true, 0},
    {24, ACCUMULATED, 1000, .03, DITHERS, {.75, 1}, true, 0},
    {25, ACCUMULATED, 1000, .25, DITHERS, {.8, .9}, true, 0},
    {26, ACCUMULATED, 1000, .75, DITHERS, {.75, 1}, true, 0},
    {27, ACCUMULATED, 1000, 1, DITHERS, {.85, .9}, true, 0},
    {28, ACCUMULATED, 1000, 1.1, DITHERS, {.85, .9}, true, 0},
    {29, ACCUMULATED, 1000, 1.25, DITHERS, {.8, 1.5}, true, 0},
    {30, ACCUMULATED, 1000, 1.5, DITHERS, {1, 1.3}, true, 0},
    {31, ACCUMULATED, 1000, 1.75, DITHERS, {1, 1.686}, true, 0},
    {32, ACCUMULATED, 1000, 2, DITHERS, {.9, 1.4}, true, 0},
    {33, ACCUMULATED, 1000, 1, DITHERS, {1, 1}, true, 0},
    {34, ACCUMULATED, 1000, 1.25, DITHERS, PLAIN_SLOPE},
    {35, BRICKS, 1000, 1, DITHERS, {.85, .9}, true, 0},
    {36, ACCUMULATED, 1000, 255. / 4095, NONE, PLAIN_SLOPE},
    {37, ACCUMULATED, 1000, .1, NONE, PLAIN_SLOPE},
    {38, ACCUMULATED, 1000, 1, NONE, PLAIN_SLOPE},
    {42, BRICKS, 1000, .5, SOME, {.75, .75}, false, 100},
    {43, BRICKS, 1000, .5, SOME, {.75, .75}, false, 200},
    {44, BRICKS, 1000, .5, SOME, {.75, .75}, false, 300},
    {45, BRICKS, 1000, .5, SOME, {.75, .75}, false, 400},
    {46, BRICKS, 1000, .75, SOME, {.75, .75}, false, 100},
    {47, BRICKS, 1000, .75, SOME, {.75, .75}, false, 200},
    {48, BRICKS, 1000, .75, SOME, {.75, .75}, false, 300},
    {49, BRICKS, 1000, 1, SOME, {.85, .85}, false, 100},
    {50, BRICKS, 1000, 1, SOME, {.85, .85}, false, 200},
    {51, BRICKS, 1000, 1, SOME, {.85, .85}, false, 300},
    {52, BRICKS, 500, 1.5, SOME, {1, 1}, false, 100},
    {53, BRICKS, 500, 1.5, SOME, {1, 1}, false, 200},
    {54, BRICKS, 500, 1.5, SOME, {1, 1}, false, 300},
    {55, ACCUMULATED, 200, 1, ALL, {.85, .85}, false, 0},
    {56, ACCUMULATED, 300, 1.5, ALL, {1, 1}, false, 0},
};

/* Section 4.1. */
static bool has_12_bits(const figure *of)
{
    return of->number >= 36 && of->number <= 38;
}

static bool has_bricks(const figure *of)
{
    return of->kind == BRICKS || of->kind == SCAN_LINE;
}

/* ---- Curves ------------------------------------------------------------------- */

static ref_fog_technique technique_of(const figure *of, curve which)
{
    const bool more_bits = has_12_bits(of);
    switch (which) {
    case PLAIN:
        return more_bits ? REF_FOG_PLAIN_12 : REF_FOG_PLAIN;
    case ORDERED:
        return REF_FOG_ORDERED;
    case RANDOM:
        return REF_FOG_RANDOM;
    case WIDE:
        return more_bits ? REF_FOG_ROUNDING_8_4 : REF_FOG_ROUNDING_8_8;
    default:
        return REF_FOG_ROUNDING;
    }
}

/* Section 7: chunks are images of their own, put over each other in full precision. The dither
   begins anew in each. */
static void join_chunks(double *levels, uint32_t slices, uint32_t chunk)
{
    for (uint32_t n = chunk + 1; n <= slices; n++) {
        const uint32_t joined = (n - 1) / chunk * chunk;
        levels[n] = ref_fog_over(levels[n - joined], levels[joined]);
    }
}

/* Ours needs no chunks. */
static void accumulate(double *levels, const figure *of, curve which, uint32_t pixel)
{
    const ref_fog fog = {
        technique_of(of, which), of->opacity, {of->slope[0], of->slope[1]}, of->bumping, pixel};
    if (which == EXACT) {
        for (uint32_t n = 0; n <= of->slices; n++) {
            levels[n] = ref_fog_exact(of->opacity, n);
        }
        return;
    }
    ref_fog_accumulate(levels, of->slices, &fog);
    if (of->chunk != 0 && which < OURS) {
        join_chunks(levels, of->slices, of->chunk);
    }
}

/* Slices of the near brick at a place of the scan line: the bricks overlap in its middle
   fifth, and the place n is a pixel of as many as there are slices. */
static uint32_t near_slices(const figure *of, uint32_t n)
{
    const uint32_t begin = of->slices * 2 / 5, end = of->slices * 3 / 5;
    if (of->kind != SCAN_LINE) {
        return n;
    }
    return n <= begin ? 0 : n >= end ? of->slices : (n - begin) * of->slices / (end - begin);
}

/* What the figure shows of the levels, and what is off: levels, or percent of AAP error. */
static void fill(double *values, double *errors, const double *levels, const figure *of)
{
    for (uint32_t n = 0; n <= of->slices; n++) {
        if (has_bricks(of)) {
            const uint32_t near = near_slices(of, n);
            values[n] = ref_fog_over(levels[near], levels[of->slices - near]);
            errors[n] = ref_fog_brick_error(levels, of->slices, near);
        } else {
            values[n] = levels[n];
            errors[n] = levels[n] - ref_fog_exact(of->opacity, n);
        }
    }
}

/* Worst of the curves of the 64 pixels that a dither tells apart; the figure shows the first. */
static double worst_of_pixels(const figure *of, curve which)
{
    double levels[REF_FOG_SLICES_MAX + 1], worst = 0;
    for (uint32_t pixel = 0; pixel < 64; pixel++) {
        accumulate(levels, of, which, pixel);
        worst =
            fmax(worst, fabs(has_bricks(of) ? ref_fog_seam(levels, of->slices)
                                            : ref_fog_deviation(levels, of->slices, of->opacity)));
    }
    return worst;
}

static void compute(plot *made, const figure *of)
{
    double levels[REF_FOG_SLICES_MAX + 1];
    static const char *const names[CURVES] = {"exact",
                                              "8 bits",
                                              "ordered dither",
                                              "random dither",
                                              "dithered rounding, 8 bits (ours)",
                                              "dithered rounding, 8.8 bits (ours)"};
    memcpy(made->names, names, sizeof names);
    if (has_12_bits(of)) {
        made->names[PLAIN] = "12 bits";
        made->names[WIDE] = "dithered rounding, 8.4 bits (ours)";
    }
    made->slices = of->slices;
    made->shown = of->published | SHOWS(EXACT) | SHOWS(OURS) | SHOWS(WIDE);
    for (int c = 0; c < CURVES; c++) {
        if (made->shown & SHOWS(c)) {
            accumulate(levels, of, (curve)c, 0);
            fill(made->values[c], made->errors[c], levels, of);
        }
    }
}

/* ---- Text --------------------------------------------------------------------- */

/* How the paper's curves came to be, as the title goes on. */
static void describe(char *text, size_t size, const figure *of)
{
    if (has_12_bits(of)) {
        (void)snprintf(text, size, ", 12 bits");
    } else if ((of->published & DITHERS) == 0) {
        text[0] = 0;
    } else if (of->chunk != 0) {
        (void)snprintf(text, size, ", slope %g, chunks of %u slices", of->slope[0],
                       (unsigned)of->chunk);
    } else if (of->bumping) {
        (void)snprintf(text, size, ", bumps, slopes %g and %g", of->slope[0], of->slope[1]);
    } else {
        (void)snprintf(text, size, ", simple dither, slope %g", of->slope[0]);
    }
}

static void make_title(char *text, size_t size, const figure *of)
{
    static const char *const subjects[] = {"", "two bricks, one by one, ", "two bricks, ",
                                           "two bricks, less turned, "};
    char how[64];
    describe(how, sizeof how, of);
    (void)snprintf(text, size, "Figure %d: %sopacity %.3g%s", of->number, subjects[of->kind],
                   of->opacity, how);
}

static void make_caption(char *text, size_t size, const plot *of, const char *unit)
{
    static const char *const short_names[CURVES] = {"",       "plain", "ordered",
                                                    "random", "ours",  "ours, more bits"};
    const char *separator = ": ";
    int length = snprintf(text, size, "Worst, in %s", unit);
    for (int c = PLAIN; c < CURVES; c++) {
        if (of->shown & SHOWS(c)) {
            length += snprintf(text + length, size - (size_t)length, "%s%s %.3g", separator,
                               short_names[c], fabs(worst_of(of->errors[c], of->slices)));
            separator = ", ";
        }
    }
}

/* ---- Numbers ------------------------------------------------------------------ */

static void worst_row(FILE *numbers, const figure *of, const plot *curves)
{
    fprintf(numbers, "| %6d | %7.3f | %6u |", of->number, of->opacity, (unsigned)of->slices);
    for (int c = PLAIN; c < CURVES; c++) {
        if (curves->shown & SHOWS(c)) {
            fprintf(numbers, " %8.3f %8.3f |", worst_of(curves->errors[c], of->slices),
                    worst_of_pixels(of, (curve)c));
        } else {
            fprintf(numbers, " %17s |", "");
        }
    }
    fputc('\n', numbers);
}

static void worst_head(FILE *numbers, const char *title)
{
    fprintf(numbers, "\n## %s\n\n| figure | opacity | slices |", title);
    fprintf(numbers, " %17s | %17s | %17s | %17s | %17s |\n|---|---|---|---|---|---|---|---|\n",
            "plain", "ordered", "random", "ours", "ours, more bits");
}

/* A table of the figures of one sort, and their plots. */
static void worst_table(FILE *numbers, FILE *index, const char *folder, bool bricks)
{
    const char *unit = bricks ? "% of AAP error" : "levels";
    plot curves;
    char title[128], caption[192];
    worst_head(numbers, bricks ? "Two bricks: worst AAP error in %, and over 64 pixels"
                               : "Worst difference from exact in levels, and over 64 pixels");
    for (size_t i = 0; i < COUNT(figures); i++) {
        const figure *of = &figures[i];
        if (has_bricks(of) == bricks) {
            compute(&curves, of);
            worst_row(numbers, of, &curves);
            make_title(title, sizeof title, of);
            make_caption(caption, sizeof caption, &curves, unit);
            const figure_text text = {of->number, kind_names[of->kind], title, caption};
            write_plot(folder, index, &text, &curves);
        }
    }
}

/* What the text says of a figure: a level after so many slices, the AAP error, or the slice
   where the curve stops rising. */
typedef enum quantity { LEVEL, SEAM, STOP } quantity;

typedef struct claim {
    int figure;
    curve which;
    quantity what;
    uint32_t slices;
    const char *text, *paper;
} claim;

static const claim claims[] = {
    {5, PLAIN, LEVEL, 100, "8 bits, level after 100 slices", "100"},
    {5, EXACT, LEVEL, 100, "exact, level after 100 slices", "82.9"},
    {5, PLAIN, LEVEL, 200, "8 bits, level after 200 slices", "128"},
    {5, EXACT, LEVEL, 200, "exact, level after 200 slices", "138.8"},
    {7, PLAIN, LEVEL, 100, "8 bits, two bricks of 100 slices", "161"},
    {7, PLAIN, SEAM, 0, "8 bits, AAP error in %", "28"},
    {12, PLAIN, SEAM, 0, "8 bits, AAP error in %", "8.6"},
    {13, PLAIN, SEAM, 0, "8 bits, AAP error in %", "4.5"},
    {14, PLAIN, SEAM, 0, "8 bits, AAP error in %", "49"},
    {17, ORDERED, SEAM, 0, "ordered, AAP error in %; which dither is not said", "-8.6"},
    {17, RANDOM, SEAM, 0, "random, AAP error in %", "-8.6"},
    {18, PLAIN, LEVEL, 1000, "8 bits, level of the plateau", "128"},
    {18, ORDERED, LEVEL, 1000, "ordered, level of the plateau", "128"},
    {19, ORDERED, SEAM, 0, "ordered, AAP error in %", "49"},
    {20, ORDERED, SEAM, 0, "ordered, AAP error in %", "49"},
    {21, ORDERED, SEAM, 0, "ordered, AAP error in %", "24"},
    {34, ORDERED, LEVEL, 1000, "ordered, level of the plateau of base + bump", "192"},
    {35, ORDERED, SEAM, 0, "ordered, AAP error in %, without sign", ".66"},
    {35, RANDOM, SEAM, 0, "random, AAP error in %, without sign", "3.9"},
    {55, ORDERED, STOP, 0, "ordered, slice where the plateau begins", "150"},
    {56, ORDERED, STOP, 0, "ordered, slice where the plateau begins", "225"},
};

static const figure *figure_of(int number)
{
    size_t i = 0;
    while (i < COUNT(figures) && figures[i].number != number) {
        i++;
    }
    paper_require(i < COUNT(figures), "a claim about a figure that there is not");
    return &figures[i];
}

static double quantity_of(const claim *said, const plot *curves)
{
    const double *values = curves->values[said->which];
    uint32_t n = curves->slices;
    if (said->what == LEVEL) {
        return values[said->slices];
    }
    if (said->what == SEAM) {
        return worst_of(curves->errors[said->which], n);
    }
    while (values[n - 1] == values[n]) {
        n--;
    }
    return n;
}

static void add_claims(FILE *numbers)
{
    plot curves;
    char place[16];
    for (size_t i = 0; i < COUNT(claims); i++) {
        compute(&curves, figure_of(claims[i].figure));
        (void)snprintf(place, sizeof place, "figure %d", claims[i].figure);
        numbers_add(numbers, place, claims[i].text, claims[i].paper,
                    quantity_of(&claims[i], &curves));
    }
}

void fog_figures(FILE *numbers, FILE *index, const char *folder)
{
    add_claims(numbers);
    worst_table(numbers, index, folder, false);
    worst_table(numbers, index, folder, true);
}
