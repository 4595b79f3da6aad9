/*
 * eight_voxels.c - figures 2 and 3: four voxels of extinction tau and four empty ones
 * become one of twice the size, by averages of extinction and of opacity.
 */
#include "kraus.h"

#include <math.h>
#include <string.h>

static const double allowed = 1e-4;
static const double taus[] = {0.1, 0.5, 1, 2, 4, 8};

/* The coarser voxel, with opacities for a length of 1 where it holds opacity. */
typedef struct coarse_voxel {
    uint16_t rgba[4];
    uint8_t storage;
    uint32_t extinction;
} coarse_voxel;

static void downsample(coarse_voxel *made, paper_volume *fine, uint16_t channel,
                       const qv_domain *domain)
{
    for (unsigned i = 0; i < 4; i++) {
        uint16_t *voxel = paper_voxel(fine, i % 2, i / 2, 0);
        voxel[0] = voxel[1] = voxel[2] = PAPER_FULL;
        voxel[3] = channel;
    }
    made->storage = fine->volume.storage;
    made->extinction = fine->volume.extinction;
    paper_require(qv_downsample(made->rgba, sizeof made->rgba, &fine->volume, &qv_filter_box2,
                                domain, 0, 1) == QV_OK,
                  "cannot downsample");
    paper_volume_free(fine);
}

static coarse_voxel of_opacity(double tau, const qv_domain *domain)
{
    paper_volume fine;
    coarse_voxel made;
    paper_volume_make(&fine, 2, 2, 2);
    downsample(&made, &fine, paper_channel(paper_opacity(tau, 1)), domain);
    return made;
}

static coarse_voxel of_extinction(double tau)
{
    paper_volume fine;
    coarse_voxel made;
    paper_volume_make(&fine, 2, 2, 2);
    paper_hold_extinction(&fine, tau);
    downsample(&made, &fine, PAPER_FULL, &qv_domain_stored);
    return made;
}

/* Opacity over the coarser voxel's length of 2, through the library's conversions. */
static double across(const coarse_voxel *of)
{
    const qv_entries from = {(qv_address)of->rgba, 1, QV_ONE_Q16, of->extinction, of->storage};
    uint16_t rgba[4];
    const qv_status status =
        of->storage == QV_STORAGE_RGBT16
            ? qv_extinction_to_opacity(rgba, sizeof rgba, QV_STORAGE_RGBA16, 2 * QV_ONE_Q16, &from)
            : qv_opacity_to_opacity(rgba, sizeof rgba, QV_STORAGE_RGBA16, 2 * QV_ONE_Q16, &from);
    paper_require(status == QV_OK, qv_status_text(status));
    return rgba[3] / (double)PAPER_FULL;
}

/* Equation 16 on the mean of opacity, for a ratio of 2. */
static double corrected_mean(double tau)
{
    return 1 - pow(1 - paper_opacity(tau, 1) / 2, 2);
}

static void add(FILE *table, const char *what, const char *paper, double exact, double ours)
{
    const paper_row row = {what, paper, exact, ours, allowed};
    paper_table_add(table, &row);
}

void eight_voxels(FILE *table)
{
    const coarse_voxel stored = of_extinction(4);
    const coarse_voxel converted = of_opacity(4, &qv_domain_extinction);
    const coarse_voxel mean = of_opacity(4, &qv_domain_stored);
    const double opaque = paper_opacity(4, 1);
    paper_table_begin(table, "\n## Figures 2 and 3: eight voxels become one");
    add(table, "figure 2, volume of extinction", "0.98", opaque, across(&stored));
    add(table, "figure 2, volume of opacity", "0.98", opaque, across(&converted));
    add(table, "figure 3, mean opacity", "0.49", opaque / 2, mean.rgba[3] / (double)PAPER_FULL);
    add(table, "figure 3, corrected", "0.74", corrected_mean(4), across(&mean));
    for (size_t i = 0; i < sizeof taus / sizeof taus[0]; i++) {
        const coarse_voxel by_extinction = of_opacity(taus[i], &qv_domain_extinction);
        const coarse_voxel by_opacity = of_opacity(taus[i], &qv_domain_stored);
        char what[64];
        (void)snprintf(what, sizeof what, "opacity that opacities lose, tau %g", taus[i]);
        add(table, what, "-", paper_opacity(taus[i], 1) - corrected_mean(taus[i]),
            across(&by_extinction) - across(&by_opacity));
    }
}
