/*
 * associated.c - every colour of 8 bits, weighted by the library.
 */
#include "associated.h"

#include <math.h>

enum { levels = 256 };

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

associated_colours associate_colours(unsigned opacity)
{
    uint8_t stored[levels][4];
    associated_colours found = {0, 0, 1};
    store(stored, opacity);
    for (unsigned colour = 0; colour < levels; colour++) {
        const double weighted = colour * opacity / 255.0, back = 255.0 / opacity;
        found.off = fmax(found.off, fabs(stored[colour][0] * back - colour));
        found.exact = fmax(found.exact, fabs(floor(weighted + 0.5) * back - colour));
        found.distinct += colour > 0 && stored[colour][0] != stored[colour - 1][0];
    }
    return found;
}
