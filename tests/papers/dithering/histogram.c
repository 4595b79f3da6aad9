/*
 * histogram.c - figures 40 and 41: opacities by equation 12 from a histogram, here the
 * head's. Its peaks are air, grey and white matter.
 */
#include "dithering.h"

#include <math.h>
#include <stdlib.h>

enum { scale = 100, peak = 40000 };
static const double peak_opacity = .25;

static void count_voxels(uint32_t histogram[QV_PALETTE_ENTRIES])
{
    uint8_t *head = paper_head();
    for (size_t i = 0; i < (size_t)PAPER_HEAD_X * PAPER_HEAD_Y * PAPER_HEAD_Z; i++) {
        histogram[head[i]]++;
    }
    free(head);
}

static bool at_peak(const qv_transfer *table, int value)
{
    return table->rgba[value][3] == paper_channel(peak_opacity / 255);
}

/* Equation 12 of the entries that no peak is near, in levels. */
static double worst_difference(const qv_transfer *table, const uint32_t histogram[])
{
    double worst = 0;
    for (int v = 1; v < QV_PALETTE_ENTRIES - 1; v++) {
        if (!at_peak(table, v - 1) && !at_peak(table, v) && !at_peak(table, v + 1)) {
            const double exact = histogram[v] < 2 ? 255 : fmin(255, scale / log(histogram[v]));
            worst = fmax(worst, fabs(table->rgba[v][3] * 255. / PAPER_FULL - exact));
        }
    }
    return worst;
}

void histogram_figures(FILE *numbers, const char *folder)
{
    uint32_t histogram[QV_PALETTE_ENTRIES] = {0};
    qv_transfer table;
    int peaks = 0;
    count_voxels(histogram);
    paper_require(qv_transfer_from_histogram(&table, histogram, (uint32_t)scale << 16, peak,
                                             paper_channel(peak_opacity / 255)) == QV_OK,
                  "no opacities from a histogram");
    FILE *data = paper_open(folder, "histogram.dat");
    for (int v = 0; v < QV_PALETTE_ENTRIES; v++) {
        fprintf(data, "%d %u %.4f\n", v, (unsigned)histogram[v],
                table.rgba[v][3] * 255. / PAPER_FULL);
        peaks += at_peak(&table, v);
    }
    paper_close(data);
    numbers_add(numbers, "figure 41", "entries at peaks", "-", peaks);
    numbers_add(numbers, "figure 41", "equation 12, worst difference of an opacity", "-",
                worst_difference(&table, histogram));
}
