/*
 * tables.c - table 1: plateaus of blends of 8 bits, and what overcomes them. Table 3: a
 * transfer function as temporal dither.
 */
#include "dithering.h"

#include "fx_blend.h"
#include "fx_dither.h"

/* ---- Table 1 ------------------------------------------------------------------ */

/* Found by blending: the first level that slices of colour 255 do not raise. */
static uint32_t plateau_by_blending(uint32_t opacity)
{
    uint32_t value = 0, next;
    while ((next = fx_blend_plain(value, 255, opacity, 8)) != value) {
        value = next;
    }
    return value;
}

static void table1(FILE *file)
{
    uint32_t last = 0;
    fputs("Table 1: plateaus of 8 bits, and the least opacity that overcomes each\n\n", file);
    fputs("plateau  opacity\n", file);
    for (uint32_t opacity = 1; fx_plateau(opacity, 255) < 255; opacity++) {
        const uint32_t plateau = fx_plateau(opacity, 255);
        paper_require(plateau_by_blending(opacity) == plateau, "a plateau is not where it should");
        if (plateau != last) {
            fprintf(file, "%7u  %7u\n", (unsigned)plateau, (unsigned)fx_overcoming(plateau, 255));
        }
        last = plateau;
    }
}

/* ---- Table 3 ------------------------------------------------------------------ */

enum { period = 8, cutoff = 3 };

/* The transfer function of figure 41 from index 0 on, as table 3 comments it; the last
   index is printed there as 23 a second time. */
static const double opacities[] = {23, .25, .25, .25, 28, 27, 26, 27, 23, 27, .25, .25, .25,
                                   28, 34,  25,  42,  28, 25, 24, 27, 25, 28, 31,  33};

static void table3(FILE *file)
{
    const fx_period slices = fx_period_of(period);
    uint32_t equal = 0; /* neighbours before this one that have its opacity */
    fputs("Table 3: opacities of figure 41, dithered over 8 slices up to 3\n\n", file);
    fputs("index  slice 0  1  2  3  4  5  6  7  opacity\n", file);
    for (uint32_t i = 0; i < sizeof opacities / sizeof *opacities; i++) {
        const uint32_t base = (uint32_t)opacities[i];
        const uint32_t hits = fx_hits(&slices, (uint32_t)(opacities[i] * 65536), base, 1);
        equal = i > 0 && opacities[i] == opacities[i - 1] ? equal + 1 : 0;
        fprintf(file, "%5u       ", (unsigned)i);
        for (uint32_t slice = 0; slice < period; slice++) {
            const bool hit =
                opacities[i] < cutoff && fx_hit_ordered(&slices, hits, (slice + equal) % period);
            fprintf(file, "%3u", (unsigned)(base + hit));
        }
        fprintf(file, "  %7g\n", opacities[i]);
    }
}

void tables(const char *folder)
{
    FILE *file = paper_open(folder, "table1.txt");
    table1(file);
    paper_close(file);
    file = paper_open(folder, "table3.txt");
    table3(file);
    paper_close(file);
}
