/*
 * boxes.c - the scenes corner, graze and phase of Wittenbrink et al. 1998.
 */
#include "boxes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const box_scene box_scenes[BOX_SCENES] = {
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

static void sample_box(sampled_box *made, const box_scene *of, unsigned n, bool antialiased)
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

/* ---- Scenes -------------------------------------------------------------------- */

void box_make(paper_volume *made, const box_scene *of, unsigned n, bool antialiased)
{
    sampled_box box;
    sample_box(&box, of, n, antialiased);
    paper_volume_make(made, n, n, n);
    paper_volume_fill(made, fill_box, &box);
    for (int axis = 0; axis < 3; axis++) {
        made->volume.spacing[axis] = QV_ONE_Q16 * box_coarse / n;
    }
    free_box(&box);
}

void box_look(qv_scene *scene, const paper_volume *made, const box_scene *of, uint16_t edge)
{
    const paper_view view = {
        of->azimuth, of->elevation, of->width * box_coarse / edge, 1, edge, edge,
    };
    memset(scene, 0, sizeof *scene);
    scene->volume = made->volume;
    paper_look(scene, &view);
}
