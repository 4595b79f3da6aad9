/*
 * border_scenes.c - the scenes corner, graze and phase (figures 7 and 10 to 12).
 *
 * The volume has the same length and the ray the same step, one voxel of 32^3, at both
 * resolutions: a finer volume has thinner borders, and fewer samples fall into them.
 * This alone gives the paper's ratio of about 2 between 32^3 and 128^3; with a step of
 * one voxel of each volume the errors would be equal.
 */
#include "wittenbrink.h"

#include "papers/boxes.h"

#include <string.h>

enum { edge = 320 /* pixels of the square frame */ };

/* The paper has figures for the corner alone: figures 11 and 12. */
static const char *paper_rms_of(const box_scene *of, unsigned n, bool antialiased)
{
    if (strcmp(of->name, "corner") != 0) {
        return "-";
    }
    if (n == box_coarse) {
        return antialiased ? "17.7" : "39.0";
    }
    return antialiased ? "8.32" : "20.3";
}

static comparison render_box(FILE *table, const char *folder, const box_scene *of, unsigned n,
                             bool antialiased)
{
    paper_volume made;
    qv_scene scene;
    char name[64];
    box_make(&made, of, n, antialiased);
    box_look(&scene, &made, of, edge);
    (void)snprintf(name, sizeof name, "%s-%u%s", of->name, n, antialiased ? "-aa" : "");
    const comparison found =
        compare_modes(table, folder, name, paper_rms_of(of, n, antialiased), &scene, edge);
    paper_volume_free(&made);
    return found;
}

/* A scene at both resolutions: two rows, the ratio of them, and two bars of figure 7. */
static void render_pair(FILE *table, FILE *bars, const char *folder, const box_scene *of,
                        bool antialiased)
{
    const double allowed = 1e-5;
    const comparison at_32 = render_box(table, folder, of, box_coarse, antialiased);
    const comparison at_128 = render_box(table, folder, of, box_fine, antialiased);
    char what[64];
    (void)snprintf(what, sizeof what, "RMS error of 32^3 by that of 128^3, %s%s", of->name,
                   antialiased ? ", antialiased" : "");
    const paper_row row = {what, of->paper_ratio[antialiased], at_32.exact / at_128.exact,
                           at_32.ours / at_128.ours, allowed};
    paper_table_add(table, &row);
    fprintf(bars, " %.4f %.4f", at_32.frame, at_128.frame);
}

void border_scenes(FILE *table, const char *folder)
{
    FILE *bars = paper_open(folder, "rms.dat");
    paper_table_begin(
        table,
        "\n## Figures 7 and 10 to 12: RMS error of separate interpolation, of 255\n\n"
        "The paper gives neither volumes nor views, so its errors cannot be had; that of 32^3 "
        "is about\ntwice that of 128^3 there and here. Errors are of every fifth row and column, "
        "which double\nprecision renders too; the chart and the sheets tell those of whole "
        "frames.");
    fputs("scene 32^3 128^3 \"32^3, antialiased\" \"128^3, antialiased\"\n", bars);
    for (unsigned i = 0; i < BOX_SCENES; i++) {
        fprintf(bars, "%s", box_scenes[i].name);
        render_pair(table, bars, folder, &box_scenes[i], false);
        render_pair(table, bars, folder, &box_scenes[i], true);
        fputc('\n', bars);
    }
    paper_close(bars);
}
