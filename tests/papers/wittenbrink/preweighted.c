/*
 * preweighted.c - section 7: colours that are weighted by their opacity in 8 bits.
 */
#include "wittenbrink.h"

#include "papers/associated.h"

static void at_opacity(FILE *table, unsigned opacity)
{
    const associated_colours found = associate_colours(opacity);
    char what[64];
    (void)snprintf(what, sizeof what, "preweighted, opacity %u of 255: a colour is off by",
                   opacity);
    const paper_row worst = {what, opacity == 1 ? "127" : "-", found.exact, found.off, 0};
    paper_table_add(table, &worst);
    (void)snprintf(what, sizeof what, "preweighted, opacity %u of 255: distinct colours", opacity);
    const paper_row colours = {what, "-", opacity + 1, found.distinct, 0};
    paper_table_add(table, &colours);
    paper_require(found.off <= 0.5 * 255 / opacity,
                  "a colour is off by more than .5 * 255 / opacity");
}

void preweighted(FILE *table)
{
    static const unsigned opacities[] = {1, 2, 8, 32, 128, 255};
    paper_table_begin(table, "\n## Section 7: colours weighted before they are stored in 8 bits");
    for (size_t i = 0; i < sizeof opacities / sizeof opacities[0]; i++) {
        at_opacity(table, opacities[i]);
    }
}
