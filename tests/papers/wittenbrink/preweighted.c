/*
 * preweighted.c - section 7: what is left of a colour that is weighted by its opacity when it is
 * stored, in 8 bits.
 */
#include "wittenbrink.h"

#include <math.h>

enum { levels = 256 };

/* All 256 colours at one opacity, as the library stores them. */
static void store(uint8_t stored[levels][4], unsigned opacity)
{
    uint8_t straight[levels][4];
    const qv_entries from = {.entries = straight[0], .count = levels, .storage = QV_STORAGE_RGBA8};
    for (unsigned colour = 0; colour < levels; colour++) {
        straight[colour][0] = straight[colour][1] = straight[colour][2] = (uint8_t)colour;
        straight[colour][3] = (uint8_t)opacity;
    }
    paper_require(qv_opacity_to_associated(stored, levels * 4, &from) == QV_OK,
                  "cannot weight colours");
}

static void at_opacity(FILE *table, unsigned opacity)
{
    uint8_t stored[levels][4];
    double off = 0, exact = 0;
    unsigned distinct = 1;
    char what[64];
    store(stored, opacity);
    for (unsigned colour = 0; colour < levels; colour++) {
        const double weighted = colour * opacity / 255.0, back = 255.0 / opacity;
        off = fmax(off, fabs(stored[colour][0] * back - colour));
        exact = fmax(exact, fabs(floor(weighted + 0.5) * back - colour));
        distinct += colour > 0 && stored[colour][0] != stored[colour - 1][0];
    }
    (void)snprintf(what, sizeof what, "preweighted, opacity %u of 255: a colour is off by",
                   opacity);
    const paper_row worst = {what, opacity == 1 ? "127" : "-", exact, off, 0};
    paper_table_add(table, &worst);
    (void)snprintf(what, sizeof what, "preweighted, opacity %u of 255: distinct colours", opacity);
    const paper_row colours = {what, "-", opacity + 1, distinct, 0};
    paper_table_add(table, &colours);
    paper_require(off <= 0.5 * 255 / opacity, "a colour is off by more than .5 * 255 / opacity");
}

void preweighted(FILE *table)
{
    static const unsigned opacities[] = {1, 2, 8, 32, 128, 255};
    paper_table_begin(table, "\n## Section 7: colours weighted before they are stored in 8 bits");
    for (size_t i = 0; i < sizeof opacities / sizeof opacities[0]; i++) {
        at_opacity(table, opacities[i]);
    }
}
