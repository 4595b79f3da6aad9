/*
 * techniques.c - section 9: its open questions, and what is attainable. A fog of colour 255, of
 * 1000 slices, in 64 phases of the dither; errors in levels. Where a technique is none of the
 * paper's, its row names no number of the paper; "double precision" are figures that a program
 * apart from this library found. Where the library's technique is another one than that program's,
 * both stand beside each other, and nothing is allowed or forbidden.
 */
#include "dithering.h"

#include "fx_alpha.h"
#include "fx_blend.h"
#include "fx_dither.h"
#include "pixel.h"
#include "random.h"

#include <math.h>

#define COUNT(array) (sizeof(array) / sizeof *(array))

enum { slices = 1000, phases = 64, colour = 255 };

static const double opacities[] = {.03, .1, .5, 1, 1.5, 2};

/* ---- The seven techniques -------------------------------------------------------------- */

static uint32_t rounded_8_8(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at)
{
    const uint32_t light = fx_light_of_colour(fog->colour, fog->opacity23);
    (void)at;
    return fx_blend_dithered(state, light, fog->opacity23, FX_NO_DITHER, 8);
}

/* Nothing where the opacity overcomes the value by itself, else the least that does, as often as
   equation 9 says. */
static uint32_t bumped_by_pixel(uint32_t state, const ref_pixel_fog *fog, const ref_moment *at)
{
    const fx_period period = fx_period_of(REF_PIXEL_PERIOD);
    const uint32_t least = fx_overcoming(state, 255), level = fog->opacity >> 16;
    const uint32_t base = level >= least ? level : 0, bump = level >= least ? 1 : least;
    const uint32_t hits = fx_hits(&period, fog->opacity, base, bump > 255 ? 255 : bump);
    const uint32_t opacity = base + (fx_hit_ordered(&period, hits, at->place) ? bump : 0);
    return fx_blend_plain(state, fog->colour, opacity > 255 ? 255 : opacity, 8);
}

typedef struct technique {
    ref_pixel_technique is;
    double known[COUNT(opacities)];
    double allowed; /* from that, for the reason that stands beside; 0: it is another technique */
} technique;

static const technique techniques[] = {
    {{"undithered, 8 bits", ref_pixel_rounded, NULL, 0}, {28.3, 82.7, 91.2, 122, 62.3, 62.9}, .05},
    /* Which bump a pixel takes is not said. */
    {{"bump by pixel, equation 9", bumped_by_pixel, NULL, 0},
     {2.6, 17.7, 32.5, 33.1, 24.9, 20.1},
     0},
    /* Ours corrects hits so that every blend is a dithered rounding: the same as the next. */
    {{"bump by pixel, hits corrected", ref_pixel_corrected, fx_dither_golden, 0},
     {2.0, 2.3, 3.2, 3.6, 4.1, 5.8},
     0},
    /* Where the dither begins moves the worst of 64 phases by .4 to 1.3, of 8.8 by up to .01, and
       half of the last digit besides. */
    {{"dithered rounding, golden ratio", ref_pixel_8, fx_dither_golden, 0},
     {2.0, 2.5, 3.5, 3.8, 3.3, 2.8},
     .4},
    /* There it is fed back unrounded; ours has 8 bits, and dithers. */
    {{"residual of 8 bits by pixel", ref_pixel_8_8, fx_dither_blocks, 8},
     {.50, .50, .51, .51, .52, .56},
     0},
    {{"8.8, golden ratio", ref_pixel_8_8, fx_dither_golden, 8},
     {.51, .51, .54, .53, .52, .52},
     .015},
    {{"8.16, rounded", ref_pixel_8_16, NULL, 16}, {.50, .50, .50, .50, .50, .50}, .005},
};

/* The largest deviation where all but every k-th slice are empty. */
static double worst_of_phases(const ref_pixel_technique *by, double opacity, uint32_t k)
{
    const ref_pixel_fog fog = ref_pixel_fog_of(opacity, colour);
    double worst = 0;
    for (uint32_t phase = 0; phase < phases; phase++) {
        uint32_t state = 0;
        for (uint32_t n = 0; n < slices; n++) {
            const ref_moment at = ref_moment_of(by, n * k, phase * (UINT32_MAX / phases + 1));
            state = by->blend(state, &fog, &at);
            worst = fmax(worst, fabs(ref_pixel_shown(by, state) - ref_pixel_exact(&fog, n + 1)));
        }
    }
    return worst;
}

static double worst_of_opacities(const ref_pixel_technique *by, uint32_t k)
{
    double worst = 0;
    for (size_t i = 0; i < COUNT(opacities); i++) {
        worst = fmax(worst, worst_of_phases(by, opacities[i], k));
    }
    return worst;
}

static void add(FILE *table, const char *what, const char *paper, double exact, double ours,
                double allowed)
{
    const paper_row row = {what, paper, exact, ours, allowed};
    paper_table_add(table, &row);
}

/* A technique of theirs beside one of ours that is another one. */
static void add_other(FILE *table, const char *what, double known, double ours)
{
    fprintf(table, "| %s | %g | %.6f |\n", what, known, ours);
}

static void table_of_section_9(FILE *table, bool others)
{
    for (size_t i = 0; i < COUNT(techniques) * COUNT(opacities); i++) {
        const technique *t = &techniques[i / COUNT(opacities)];
        const double opacity = opacities[i % COUNT(opacities)];
        const double known = t->known[i % COUNT(opacities)];
        char what[96];
        if (others != (t->allowed <= 0)) {
            continue;
        }
        (void)snprintf(what, sizeof what, "%s, opacity %g", t->is.name, opacity);
        const double ours = worst_of_phases(&t->is, opacity, 1);
        if (others) {
            add_other(table, what, known, ours);
        } else {
            add(table, what, "-", known, ours, t->allowed);
        }
    }
}

/* ---- Buffers of 8.8 bits --------------------------------------------------------------- */

static const ref_pixel_technique golden_8_8 = {"8.8, golden ratio", ref_pixel_8_8, fx_dither_golden,
                                               8};
static const ref_pixel_technique hash_8_8 = {"8.8, hash", ref_pixel_8_8, fx_dither_hash, 8};
static const ref_pixel_technique plain_8_8 = {"8.8, rounded", rounded_8_8, NULL, 8};

/* What is not rounded: a picture shows whole levels. */
static double level_after(const ref_pixel_technique *by, double opacity, uint32_t count)
{
    const ref_pixel_fog fog = ref_pixel_fog_of(opacity, colour);
    uint32_t state = 0;
    for (uint32_t n = 0; n < count; n++) {
        const ref_moment at = ref_moment_of(by, n, 0);
        state = by->blend(state, &fog, &at);
    }
    return ldexp(state, -8);
}

/* A slice raises a rounded state by less than half of 1/256 level where less than this is left. */
static void plateaus_of_8_8(FILE *table)
{
    const uint32_t many = 300000;
    const double opacity = 1. / 128, left = 255 / (512 * opacity);
    const ref_pixel_fog fog = ref_pixel_fog_of(opacity, colour);
    add(table, "8.8, rounded, opacity 1/128: plateau", "-", 255 - left,
        level_after(&plain_8_8, opacity, many), 1. / 128);
    add(table, "8.8, golden ratio, opacity 1/128: after 300000 slices", "-",
        ref_pixel_exact(&fog, many), level_after(&golden_8_8, opacity, many), .1);
}

static const ref_pixel_technique ordered = {"ordered", ref_pixel_ordered, NULL, 0};

/* An ordered dither meets its period: some pixels are never hit. */
static void sparse_slices(FILE *table)
{
    add(table, "ordered dither, every 32nd slice of opacity .5", "-", ref_fog_exact(.5, slices),
        worst_of_phases(&ordered, .5, REF_PIXEL_PERIOD), .01);
}

/* Another hash than theirs, and a golden ratio of other bits. */
static void other_dithers(FILE *table)
{
    const uint32_t k = 233; /* a Fibonacci number: golden dither hardly turns in so many slices */
    add_other(table, "8.8, hash, worst of the six opacities", .69,
              worst_of_opacities(&hash_8_8, 1));
    add_other(table, "8.8, hash, every 233rd slice", .66, worst_of_opacities(&hash_8_8, k));
    add_other(table, "8.8, golden ratio, every 233rd slice", 1.6,
              worst_of_opacities(&golden_8_8, k));
}

/* ---- Random slices --------------------------------------------------------------------- */

/* The farthest that slices of any colour, of opacities up to `most` levels, are off in all phases:
   the mean over pixels, each of which has slices of its own. */
static double mean_of_random_slices(const ref_pixel_technique *by, uint32_t most)
{
    enum { pixels = 256 };
    uint32_t seed = 1;
    double sum = 0;
    for (uint32_t pixel = 0; pixel < pixels; pixel++) {
        const uint32_t phase = pixel << 24;
        uint32_t state = 0;
        double exact = 0, worst = 0;
        for (uint32_t n = 0; n < slices; n++) {
            const double opacity = ldexp(random_next(&seed), -32) * most;
            const ref_pixel_fog slice = ref_pixel_fog_of(opacity, random_below(&seed, 256));
            const ref_moment at = ref_moment_of(by, n, phase);
            state = by->blend(state, &slice, &at);
            exact += (slice.colour - exact) * opacity / 255;
            worst = fmax(worst, fabs(ref_pixel_shown(by, state) - exact));
        }
        sum += worst;
    }
    return sum / pixels;
}

/* How many times farther off than plain rounding. */
static void random_slices(FILE *table)
{
    static const uint32_t greatest[] = {2, 16, 128};
    for (size_t i = 0; i < COUNT(greatest); i++) {
        char what[96];
        (void)snprintf(what, sizeof what, "random slices, opacities up to %u", greatest[i]);
        add_other(table, what, mean_of_random_slices(&techniques[0].is, greatest[i]),
                  mean_of_random_slices(&ordered, greatest[i]));
    }
}

/* ---- What an opacity of few bits costs --------------------------------------------------- */

/* Of exact blending, by the opacity to nearest; the library's have 23 bits or 32. Allowed is half
   of the last digit; of 23 bits 1/8 of what 20 cost. */
static double cost_of_bits(int bits)
{
    double worst = 0;
    for (size_t i = 0; i < COUNT(opacities); i++) {
        const double stored = ldexp(floor(ldexp(opacities[i] / 255, bits) + .5), -bits) * 255;
        for (uint32_t n = 1; n <= slices; n++) {
            worst = fmax(worst, fabs(ref_fog_exact(stored, n) - ref_fog_exact(opacities[i], n)));
        }
    }
    return worst;
}

static void bits_of_opacity(FILE *table)
{
    add(table, "opacity in Q0.16, exact blending", "-", 1.0, cost_of_bits(16), .05);
    add(table, "opacity in Q0.20, exact blending", "-", .08, cost_of_bits(20), .005);
    add(table, "opacity in Q0.23 (ours), exact blending", "-", 0, cost_of_bits(23), .08 / 8);
    add(table, "opacity in Q0.24, exact blending", "-", 0, cost_of_bits(24), .005);
}

/* ---- The paper's integers ------------------------------------------------------------------ */

/* Blends of all colours, opacities and values that are not what real numbers round to. */
static double blends_off(void)
{
    double off = 0;
    for (uint32_t c = 0; c <= 255; c++) {
        for (uint32_t a = 0; a <= 255; a++) {
            for (uint32_t p = 0; p <= 255; p++) {
                const double real = (c * a + (255. - a) * p) / 255;
                off += fx_blend_plain(p, c, a, 8) != floor(real + .5);
            }
        }
    }
    return off;
}

static double plateaus_off(void)
{
    double off = 0;
    for (uint32_t a = 1; a <= 255; a++) {
        off += fx_plateau(a, 255) != ceil(255 - 127.5 / a);
    }
    return off;
}

static void integers(FILE *table)
{
    const fx_period sixteen = fx_period_of(16), thirty_two = fx_period_of(32);
    add(table, "blends of 8 bits that are not rounded to nearest, of 256^3", "0", 0, blends_off(),
        0);
    add(table, "plateaus that are not ceil(255 - 127.5 / opacity), of 255", "0", 0, plateaus_off(),
        0);
    add(table, "opacity 2.3 in 16 slices, mean by equation 9", "2.25", 2.3125,
        2 + fx_hits(&sixteen, (uint32_t)(2.3 * 65536), 2, 1) / 16., 0);
    add(table, "opacity .03 in 32 slices, hits by equation 9", "0", 1,
        fx_hits(&thirty_two, (uint32_t)(.03 * 65536), 0, 1), 0);
    for (uint32_t n = 1, value = 0; n <= 4; n++, value = fx_plateau((1u << (n - 1)) - 1, 255)) {
        char what[64];
        (void)snprintf(what, sizeof what, "bump %u of those that fit the slopes", (unsigned)n);
        add(table, what, "-", (1 << n) - 1, fx_bump(value, 0), 0);
    }
}

void techniques_of_section_9(const char *folder)
{
    FILE *table = paper_open(folder, "table.md");
    fputs("# Williams et al.: alpha dithering, beside double precision\n", table);
    paper_table_begin(table, "\n## Section 9: worst deviation in levels");
    table_of_section_9(table, false);
    sparse_slices(table);
    plateaus_of_8_8(table);
    bits_of_opacity(table);
    paper_table_begin(table, "\n## Sections 2 to 4 in integers");
    integers(table);
    fputs("\n## Section 9: techniques that are others than ours\n\n| what | theirs | ours |\n"
          "|---|---|---|\n",
          table);
    table_of_section_9(table, true);
    other_dithers(table);
    fputs("\n## Random slices: mean over pixels of the farthest off\n\n"
          "| what | plain | ordered |\n|---|---|---|\n",
          table);
    random_slices(table);
    paper_close(table);
}
