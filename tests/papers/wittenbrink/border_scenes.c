/*
 * border_scenes.c - the scenes corner, graze and phase (figures 7 and 10 to 12).
 *
 * The paper gives neither volumes nor views, so these are our own: one box of a
 * single material in air, seen on a corner, along a face, and almost straight on.
 * Air is black and transparent, as in the paper.
 *
 * The volume has the same length and the ray the same step, one voxel of 32^3, at both
 * resolutions: a finer volume has thinner borders, and fewer samples fall into them.
 * This alone gives the paper's ratio of about 2 between 32^3 and 128^3; with a step of
 * one voxel of each volume the errors would be equal.
 */
#include "wittenbrink.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { edge = 320 /* pixels of the square frame */, coarse = 32, fine = 128 /* voxels */ };

typedef struct border_scene {
    const char *name;
    double low[3], high[3];     /* the box, 0 .. 1 of the volume */
    bool antialiased[3];        /* axes whose faces are the principal ones */
    double azimuth, elevation;  /* degrees */
    double width;               /* of the frame, in volumes */
    const char *paper_ratio[2]; /* RMS error of 32^3 to 128^3 in the paper, antialiased last */
} border_scene;

static const border_scene scenes[] = {
    {"corner",
     {0.25, 0.25, 0.25},
     {0.75, 0.75, 0.75},
     {true, true, true},
     45,
     35.26,
     0.9,
     {"1.92", "2.13"}},
    {"graze",
     {0.125, 0.125, 0.375},
     {0.875, 0.875, 0.625},
     {false, false, true},
     25,
     7,
     1.1,
     {"-", "-"}},
    {"phase",
     {0.125, 0.375, 0.125},
     {0.875, 0.625, 0.875},
     {false, true, false},
     5,
     3,
     0.9,
     {"-", "-"}},
};

/* Brightness of a face by the axis that it is across, and the material's colour. */
static const double brightness[3] = {0.66, 0.82, 1};
static const double ivory[3] = {1, 0.95, 0.85};

/* ---- Antialiasing -------------------------------------------------------------- */

/* The low-pass filter: a sinc that halves the bandwidth, in a Hann window of this radius. */
enum { window_radius = 4, filter_steps = 64 /* per voxel */ };

static double windowed_sinc(double x)
{
    const double pi = 3.14159265358979323846;
    const double window = 0.5 + 0.5 * cos(pi * x / window_radius);
    return x == 0 ? window : window * sin(pi * x / 2) / (pi * x / 2);
}

/* What the filter makes of a face, at a distance behind it, by the midpoint rule.
   Overshoots are cut off, as a volume of densities cuts them. */
static double filtered_face(double behind)
{
    double sum = 0, all = 0;
    for (int i = -window_radius * filter_steps; i < window_radius * filter_steps; i++) {
        const double x = (i + 0.5) / filter_steps;
        all += windowed_sinc(x);
        sum += x < behind ? windowed_sinc(x) : 0;
    }
    return fmax(0, fmin(sum / all, 1));
}

static double face(double behind, bool antialiased)
{
    return antialiased ? filtered_face(behind) : behind > 0;
}

/* ---- Volumes ------------------------------------------------------------------- */

/* A scene at a resolution: the density along each axis, and from which face on. */
typedef struct sampled_box {
    double *density[3]; /* by voxel */
    double *behind[3];  /* distance from the nearer face, in voxels; negative outside */
} sampled_box;

static void sample_box(sampled_box *made, const border_scene *of, unsigned n, bool antialiased)
{
    for (int axis = 0; axis < 3; axis++) {
        const bool filtered = antialiased && of->antialiased[axis];
        made->density[axis] = paper_memory(n, sizeof(double));
        made->behind[axis] = paper_memory(n, sizeof(double));
        for (unsigned i = 0; i < n; i++) {
            const double from_low = i + 0.5 - of->low[axis] * n;
            const double from_high = of->high[axis] * n - (i + 0.5);
            made->density[axis][i] = face(from_low, filtered) * face(from_high, filtered);
            made->behind[axis][i] = fmin(from_low, from_high);
        }
    }
}

static void free_box(sampled_box *made)
{
    for (int axis = 0; axis < 3; axis++) {
        free(made->density[axis]);
        free(made->behind[axis]);
    }
}

/* Density is opacity; a voxel has the colour of the face that it is nearest to. */
static void fill_box(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    const sampled_box *box = from;
    double density = 1;
    int nearest = 0;
    for (int axis = 0; axis < 3; axis++) {
        density *= box->density[axis][at[axis]];
        if (box->behind[axis][at[axis]] < box->behind[nearest][at[nearest]]) {
            nearest = axis;
        }
    }
    rgba[3] = paper_channel(density);
    for (int channel = 0; channel < 3 && rgba[3] != 0; channel++) {
        rgba[channel] = paper_channel(brightness[nearest] * ivory[channel]);
    }
}

/* ---- Pictures ------------------------------------------------------------------ */

/* The paper has figures for the corner alone: figures 11 and 12. */
static const char *paper_rms_of(const border_scene *of, unsigned n, bool antialiased)
{
    if (strcmp(of->name, "corner") != 0) {
        return "-";
    }
    if (n == coarse) {
        return antialiased ? "17.7" : "39.0";
    }
    return antialiased ? "8.32" : "20.3";
}

/* The volume is `coarse` world units long, whatever its resolution. */
static void make_scene(qv_scene *scene, paper_volume *made, const border_scene *of)
{
    const paper_view view = {
        of->azimuth, of->elevation, of->width * coarse / edge, 1, edge, edge,
    };
    memset(scene, 0, sizeof *scene);
    for (int axis = 0; axis < 3; axis++) {
        made->volume.spacing[axis] = QV_ONE_Q16 * coarse / made->volume.size[axis];
    }
    scene->volume = made->volume;
    paper_look(scene, &view);
}

static comparison render_box(FILE *table, const char *folder, const border_scene *of, unsigned n,
                             bool antialiased)
{
    sampled_box box;
    paper_volume made;
    qv_scene scene;
    char name[64];
    sample_box(&box, of, n, antialiased);
    paper_volume_make(&made, n, n, n);
    paper_volume_fill(&made, fill_box, &box);
    make_scene(&scene, &made, of);
    (void)snprintf(name, sizeof name, "%s-%u%s", of->name, n, antialiased ? "-aa" : "");
    const comparison found =
        compare_modes(table, folder, name, paper_rms_of(of, n, antialiased), &scene, edge);
    paper_volume_free(&made);
    free_box(&box);
    return found;
}

/* A scene at both resolutions: two rows, the ratio of them, and two bars of figure 7. */
static void render_pair(FILE *table, FILE *bars, const char *folder, const border_scene *of,
                        bool antialiased)
{
    const double allowed = 1e-5;
    const comparison at_32 = render_box(table, folder, of, coarse, antialiased);
    const comparison at_128 = render_box(table, folder, of, fine, antialiased);
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
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        fprintf(bars, "%s", scenes[i].name);
        render_pair(table, bars, folder, &scenes[i], false);
        render_pair(table, bars, folder, &scenes[i], true);
        fputc('\n', bars);
    }
    paper_close(bars);
}
