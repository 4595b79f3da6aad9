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

/* The transfer function of figure 41 from index 0 on, as table 3 comments it; its last index
   is printed there as 23 a second time. */
static const double opacities[] = {23, .25, .25, .25, 28, 27, 26, 27, 23, 27, .25, .25, .25,
                                   28, 34,  25,  42,  28, 25, 24, 27, 25, 28, 31,  33};
enum { indices = sizeof opacities / sizeof *opacities };

static void table3(FILE *file)
{
    const qv_dither dither = {.sequence = qv_sequence_rounded, .period = period, .cutoff = cutoff};
    uint8_t entries[period][QV_PALETTE_ENTRIES];
    static qv_transfer transfer;
    for (int i = 0; i < indices; i++) {
        transfer.rgba[i][3] = paper_channel(opacities[i] / 255);
    }
    paper_require(qv_dither_table_build(entries, sizeof entries, 1, &dither, &transfer, 0,
                                        QV_PALETTE_ENTRIES) == QV_OK,
                  "cannot build table 3");
    fputs("Table 3: opacities of figure 41, dithered over 8 slices up to 3\n\n", file);
    fputs("index  slice 0  1  2  3  4  5  6  7  opacity\n", file);
    for (int i = 0; i < indices; i++) {
        fprintf(file, "%5d       ", i);
        for (int slice = 0; slice < period; slice++) {
            fprintf(file, "%3u", (unsigned)entries[slice][i]);
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
