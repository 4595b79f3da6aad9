/*
 * scattered_voxels.c - figure 7: single opaque voxels scattered in empty space. Sampled by
 * opacity they look like diamonds and differ in brightness; by extinction less so.
 */
#include "kraus.h"

#include "draw.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { size = 24 /* voxels an axis */, count = 90, edge = 512, seed = 7 };

static const double tau = 4, step = 1;

/* Where the voxels are; no two touch. */
typedef struct scatter {
    unsigned at[count][3];
} scatter;

static bool is_apart(const scatter *of, unsigned placed)
{
    for (unsigned i = 0; i < placed; i++) {
        int farthest = 0;
        for (int axis = 0; axis < 3; axis++) {
            const int off = abs((int)of->at[i][axis] - (int)of->at[placed][axis]);
            farthest = off > farthest ? off : farthest;
        }
        if (farthest < 2) {
            return false;
        }
    }
    return true;
}

static void place(scatter *made)
{
    draws from = draw_seeded(seed);
    for (unsigned i = 0; i < count;) {
        for (int axis = 0; axis < 3; axis++) {
            made->at[i][axis] = 1 + draw_below(&from, size - 2);
        }
        i += is_apart(made, i);
    }
}

static void fill(const paper_volume *made, const scatter *of, uint16_t channel)
{
    static const double colours[][3] = {
        {1, 0.93, 0.78}, {0.98, 0.78, 0.45}, {0.62, 0.82, 0.95}, {0.75, 0.9, 0.7}};
    for (unsigned i = 0; i < count; i++) {
        uint16_t *voxel = paper_voxel(made, of->at[i][0], of->at[i][1], of->at[i][2]);
        for (int c = 0; c < 3; c++) {
            voxel[c] = paper_channel(colours[i % (sizeof colours / sizeof colours[0])][c]);
        }
        voxel[3] = channel;
    }
}

/* ---- Opacity at the centres ---------------------------------------------------- */

static const paper_view view = {28, 20, 1.25 * size / edge, step, edge, edge};

/* The pixel that shows a voxel's centre; the centre of the frame shows the volume's. */
static void pixel_of(int32_t pixel[2], const unsigned at[3])
{
    double rotation[3][3];
    const double turn = 4294967296.0 / 360;
    ref_rotation(rotation, (qv_angle)(view.azimuth * turn), (qv_angle)(view.elevation * turn), 0);
    for (int row = 0; row < 2; row++) {
        double along = 0;
        for (int axis = 0; axis < 3; axis++) {
            along += rotation[row][axis] * (at[axis] + 0.5 - size / 2);
        }
        pixel[row] = (int32_t)floor(along / view.pitch + edge / 2);
    }
}

/* The least opacity at any centre: 1 would be best, and 0.98 is what tau makes of a ray. */
static double least_of_ours(const paper_picture *ours, const scatter *of)
{
    double least = 1;
    for (unsigned i = 0; i < count; i++) {
        int32_t pixel[2];
        pixel_of(pixel, of->at[i]);
        least = fmin(least, ours->rgba[(size_t)pixel[0] + (size_t)pixel[1] * edge][3]);
    }
    return least;
}

static double least_of_reference(const qv_scene *scene, ref_mode mode, const scatter *of)
{
    double least = 1;
    for (unsigned i = 0; i < count; i++) {
        ref_pixel found;
        int32_t pixel[2];
        pixel_of(pixel, of->at[i]);
        ref_render(&found, scene, mode, pixel[0], pixel[1]);
        least = fmin(least, found.opacity);
    }
    return least;
}

/* ---- Pictures -------------------------------------------------------------------- */

static void render(FILE *table, const char *folder, const char *name, const paper_volume *made,
                   const scatter *of, const qv_sampling *sampling, ref_mode mode)
{
    paper_picture ours;
    qv_scene scene;
    char what[64];
    memset(&scene, 0, sizeof scene);
    scene.volume = made->volume;
    scene.sampling = sampling;
    paper_look(&scene, &view);
    paper_render(&ours, &scene, edge, edge);
    (void)snprintf(what, sizeof what, "%s, least opacity of a voxel's centre", name);
    const paper_row row = {what, "-", least_of_reference(&scene, mode, of),
                           least_of_ours(&ours, of), 2e-5};
    paper_table_add(table, &row);
    paper_write_picture(folder, name, &ours);
    paper_picture_free(&ours);
}

void scattered_voxels(FILE *table, const char *folder)
{
    paper_volume made;
    scatter voxels;
    place(&voxels);
    paper_table_begin(table, "\n## Figure 7: scattered opaque voxels");
    paper_volume_make(&made, size, size, size);
    fill(&made, &voxels, paper_channel(paper_opacity(tau, step)));
    render(table, folder, "scattered-opacity", &made, &voxels, &qv_corrected_rgba16, REF_CORRECTED);
    fill(&made, &voxels, PAPER_FULL);
    paper_hold_extinction(&made, tau);
    render(table, folder, "scattered-extinction", &made, &voxels, &qv_extinction_rgbt16,
           REF_EXTINCTION);
    paper_volume_free(&made);
}
