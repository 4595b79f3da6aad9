/*
 * store.c - section 3.1: what it costs to store light as a byte. The library adds up depths and
 * rounds each byte once; other ways are computed here, for white voxels as in figure 6.
 */
#include "columns.h"
#include "freevoxels.h"

#include <math.h>

enum { layers = 4096 };

/* What is stored for a transmittance, 0 .. 255. */
typedef double storing(double transmittance);

static double rounded(double transmittance)
{
    return floor(255 * transmittance + 0.5);
}

static double truncated(double transmittance)
{
    return floor(255 * transmittance);
}

/* The farthest that a picture of 1, 2, .. layers is from exact, in levels. */
static double off(storing *stores, double opacity)
{
    double picture = 0, passes = 1, worst = 0;
    for (int layer = 0; layer < layers; layer++) {
        picture += opacity * stores(passes);
        passes *= 1 - opacity;
        worst = fmax(worst, fabs(picture - 255 * (1 - passes)));
    }
    return worst;
}

static double ours(double opacity)
{
    const uint16_t size[3] = {2, layers, 2};
    return columns_off(&qv_splatting_added, opacity, size, 1);
}

/* ---- The bytes themselves ----------------------------------------------------------- */

enum { line = 500 /* voxels */ };

static void fill_grey(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    (void)at;
    rgba[3] = *(const uint16_t *)from;
}

/* The farthest off that bytes of a line of voxels are: of a product kept in a byte, and ours. */
static void bytes_off(double *product, double *ours_off, double opacity)
{
    const uint16_t alpha = paper_channel(opacity);
    const double each = 1 - alpha / (double)PAPER_FULL;
    paper_volume made;
    attenuated light;
    double byte = 255;
    paper_volume_make(&made, line, 1, 1);
    paper_volume_fill(&made, fill_grey, &alpha);
    attenuated_make(&light, &made.volume, ONLY(qv_direction(-1, 0, 0)), 0);
    *product = *ours_off = 0;
    for (unsigned before = 0; before < line; before++) {
        const double exact = 255 * pow(each, before);
        *product = fmax(*product, fabs(byte - exact));
        *ours_off = fmax(*ours_off, fabs(attenuated_byte(&light, before, 0, 0) - exact));
        byte = floor(byte * each + 0.5);
    }
    attenuated_free(&light);
    paper_volume_free(&made);
}

/* ---- Numbers -------------------------------------------------------------------------- */

static void add_row(FILE *table, double opacity)
{
    char what[96];
    (void)snprintf(what, sizeof what, "rounded byte, opacity %g: farthest off", opacity);
    const double exact = off(rounded, paper_channel(opacity) / (double)PAPER_FULL);
    const paper_row row = {what, "-", exact, ours(opacity), 0.05};
    paper_table_add(table, &row);
}

/* Opacities from the least to the most, each so many times the one before. */
static void any_opacity(FILE *table)
{
    const double least = 0.001, most = 0.5, apart = 1.06;
    double worst = 0, exact = 0;
    for (double opacity = least; opacity <= most; opacity *= apart) {
        worst = fmax(worst, ours(opacity));
        exact = fmax(exact, off(rounded, paper_channel(opacity) / (double)PAPER_FULL));
    }
    const paper_row row = {"rounded byte, any opacity: farthest off", "-", exact, worst, 0.1};
    paper_table_add(table, &row);
}

void store(FILE *table)
{
    static const double opacities[] = {0.001, 0.01, 0.05, 0.1, 0.25, 0.5};
    const size_t count = sizeof opacities / sizeof opacities[0];
    double worst = 0, worst_truncated = 0, product, bytes;
    paper_table_begin(table, "\n## Section 3.1: what a byte costs, in levels");
    for (size_t i = 0; i < count; i++) {
        add_row(table, opacities[i]);
        worst = fmax(worst, ours(opacities[i]));
        worst_truncated = fmax(worst_truncated, off(truncated, opacities[i]));
    }
    any_opacity(table);
    pairs_begin(table, "\n### Other ways to store it", "that way", "ours");
    pairs_add(table, "truncated byte, the same six opacities", worst_truncated, worst);
    bytes_off(&product, &bytes, 0.01);
    pairs_add(table, "product kept in a byte, opacity 0.01: byte after 500 voxels", product, bytes);
}
