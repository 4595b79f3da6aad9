/*
 * thin_wall.c - figures 5 and 6: a wall of one voxel, along an axis, in empty space.
 *
 * The paper gives neither view nor extinction. tau is that of figures 2 and 3; with it
 * the first artefacts show where the paper has them, at d = 0.6 and 1.6. Opacities are
 * stored for d' = d, as in the paper.
 */
#include "kraus.h"

#include <math.h>
#include <string.h>

enum { size = 64 /* voxels an axis */, wall = 31 /* its place on y */, margin = 6 };
enum {
    edge = 512 /* pixels of the frame */,
    middle = 128 /* of its middle, all within the wall */
};

static const double tau = 4;
static const double steps[] = {0.7, 1.7, 2.2};

/* The least and the most opacity of the middle of a picture. */
typedef struct range {
    double least, most;
} range;

static range opacities(const paper_picture *of, uint32_t part)
{
    const uint32_t first = (of->width - part) / 2;
    range found = {1, 0};
    for (uint32_t y = first; y < first + part; y++) {
        for (uint32_t x = first; x < first + part; x++) {
            const double opacity = of->rgba[x + (size_t)y * of->width][3];
            found.least = fmin(found.least, opacity);
            found.most = fmax(found.most, opacity);
        }
    }
    return found;
}

/* A fourth channel for all voxels of the wall, which is ivory with a blue rim. */
static void fill_wall(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    const double ivory[3] = {1, 0.93, 0.78}, blue[3] = {0.35, 0.6, 0.9};
    const unsigned last = size - 1 - margin;
    const bool inside = at[0] >= margin && at[0] <= last && at[2] >= margin && at[2] <= last;
    const bool rim =
        at[0] < margin + 2 || at[0] > last - 2 || at[2] < margin + 2 || at[2] > last - 2;
    if (!inside || at[1] != wall) {
        return;
    }
    for (int channel = 0; channel < 3; channel++) {
        rgba[channel] = paper_channel(rim ? blue[channel] : ivory[channel]);
    }
    rgba[3] = *(const uint16_t *)from;
}

/* Rows for the middle of the wall: by the library and by the reference at the same pixels. */
static void add_rows(FILE *table, const char *name, const paper_picture *ours,
                     const paper_picture *exact)
{
    const double allowed = 1e-6;
    paper_picture thin;
    char what[96];
    paper_thin_out(&thin, ours);
    const range a = opacities(&thin, middle / paper_lattice);
    const range b = opacities(exact, middle / paper_lattice);
    paper_picture_free(&thin);
    (void)snprintf(what, sizeof what, "%s, least opacity", name);
    const paper_row least = {what, "-", b.least, a.least, allowed};
    paper_table_add(table, &least);
    (void)snprintf(what, sizeof what, "%s, spread of opacity", name);
    const paper_row spread = {what, "-", b.most - b.least, a.most - a.least, allowed};
    paper_table_add(table, &spread);
}

static void render_wall(FILE *table, const char *folder, const char *name, const paper_volume *made,
                        double d, const qv_sampling *sampling, ref_mode mode)
{
    const paper_view view = {18, 12, 1.02 * size / edge, d, edge, edge};
    const uint8_t night[4] = {16, 22, 42, 255};
    paper_picture ours, exact;
    qv_scene scene;
    memset(&scene, 0, sizeof scene);
    scene.volume = made->volume;
    scene.sampling = sampling;
    paper_look(&scene, &view);
    paper_render(&ours, &scene, edge, edge);
    paper_render_reference(&exact, &scene, mode, edge, edge);
    add_rows(table, name, &ours, &exact);
    paper_picture_free(&ours);
    paper_picture_free(&exact);
    memcpy(scene.background, night, sizeof night);
    paper_render(&ours, &scene, edge, edge);
    paper_write_picture(folder, name, &ours);
    paper_picture_free(&ours);
}

void thin_wall(FILE *table, const char *folder)
{
    paper_table_begin(table, "\n## Figures 5 and 6: the middle of a wall of one voxel");
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        const uint16_t opacity = paper_channel(paper_opacity(tau, steps[i]));
        const uint16_t full = PAPER_FULL;
        paper_volume made;
        char name[64];
        paper_volume_make(&made, size, size, size);
        paper_volume_fill(&made, fill_wall, &opacity);
        (void)snprintf(name, sizeof name, "wall-opacity-%g", steps[i]);
        render_wall(table, folder, name, &made, steps[i], &qv_corrected_rgba16, REF_CORRECTED);
        paper_volume_fill(&made, fill_wall, &full);
        paper_hold_extinction(&made, tau);
        (void)snprintf(name, sizeof name, "wall-extinction-%g", steps[i]);
        render_wall(table, folder, name, &made, steps[i], &qv_extinction_rgbt16, REF_EXTINCTION);
        paper_volume_free(&made);
    }
}
