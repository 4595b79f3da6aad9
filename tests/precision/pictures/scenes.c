#include "pictures.h"

#include "draw.h"
#include "papers/boxes.h"
#include "scan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { size = 32 /* voxels an axis */, edge = 40 /* pixels */, head_factor = 6 };

static const double pi = 3.14159265358979323846;

/* What a voxel holds, at its centre in 0 .. 1 of the volume. */
typedef void fill(double rgba[4], const double at[3], draws *random);

/* ---- Fillings ------------------------------------------------------------------------ */

static double wave(const double at[3], double x, double y, double z, double phase)
{
    return 0.5 + 0.5 * sin(2 * pi * (x * at[0] + y * at[1] + z * at[2] + phase));
}

static void wavy_colour(double rgba[4], const double at[3])
{
    rgba[0] = wave(at, 1.3, 0.4, -0.7, 0.1);
    rgba[1] = wave(at, -0.6, 1.7, 0.3, 0.4);
    rgba[2] = wave(at, 0.2, -0.9, 1.9, 0.8);
}

static void noisy_colour(double rgba[4], draws *random)
{
    for (int channel = 0; channel < 3; channel++) {
        rgba[channel] = draw_real(random, 0, 1);
    }
}

/* A fog far below 1/255. */
static void fill_mist(double rgba[4], const double at[3], draws *random)
{
    (void)random;
    wavy_colour(rgba, at);
    rgba[3] = 0.001;
}

static void fill_haze(double rgba[4], const double at[3], draws *random)
{
    (void)random;
    wavy_colour(rgba, at);
    rgba[3] = 0.03 * wave(at, 0.8, -1.1, 0.6, 0.3);
}

/* Whole 255ths, so that opacity is the same in 8 bits and colour alone is lost. */
static void fill_thin(double rgba[4], const double at[3], draws *random)
{
    (void)random;
    wavy_colour(rgba, at);
    rgba[3] = 1.0 / 255;
}

static void fill_film(double rgba[4], const double at[3], draws *random)
{
    wavy_colour(rgba, at);
    rgba[3] = draw_below(random, 5) / 255.0;
}

static void fill_veil(double rgba[4], const double at[3], draws *random)
{
    noisy_colour(rgba, random);
    rgba[3] = floor(1 + 8 * wave(at, 0.5, 0.7, -1.2, 0)) / 255;
}

static void fill_cloud(double rgba[4], const double at[3], draws *random)
{
    (void)random;
    wavy_colour(rgba, at);
    rgba[3] = 0.3 * pow(wave(at, 1.2, 0.9, -1.4, 0.6), 3);
}

/* Two shells, the outer one glass, round a dense ball. */
static void fill_shells(double rgba[4], const double at[3], draws *random)
{
    const double x = at[0] - 0.5, y = at[1] - 0.5, z = at[2] - 0.5;
    const double from_centre = sqrt(x * x + y * y + z * z);
    (void)random;
    wavy_colour(rgba, at);
    rgba[3] = 0.1 * exp(-pow((from_centre - 0.44) / 0.03, 2)) +
              0.5 * exp(-pow((from_centre - 0.3) / 0.04, 2)) + (from_centre < 0.15 ? 0.4 : 0);
}

static void fill_noise(double rgba[4], const double at[3], draws *random)
{
    (void)at;
    noisy_colour(rgba, random);
    rgba[3] = draw_real(random, 0, 1);
}

/* ---- Volumes -------------------------------------------------------------------------- */

static void shape(picture_scene *made, const uint16_t voxels[3])
{
    made->voxels = 1;
    for (int axis = 0; axis < 3; axis++) {
        made->scene.volume.size[axis] = voxels[axis];
        made->voxels *= voxels[axis];
    }
    made->rgba = paper_memory(made->voxels, sizeof made->rgba[0]);
}

static void make_filled(picture_scene *made, fill *by)
{
    const uint16_t cube[3] = {size, size, size};
    const paper_view view = {30, 20, 1.5 * size / edge, 1, edge, edge};
    draws random = draw_seeded(1);
    shape(made, cube);
    for (unsigned i = 0; i < made->voxels; i++) {
        const double at[3] = {(i % size + 0.5) / size, (i / size % size + 0.5) / size,
                              (i / (size * size) + 0.5) / size};
        by(made->rgba[i], at, &random);
    }
    paper_look(&made->scene, &view);
}

/* The box of a paper, as its 16 bits have it. */
static void make_box(picture_scene *made, const box_scene *of)
{
    paper_volume box;
    box_make(&box, of, box_coarse, true);
    box_look(&made->scene, &box, of, edge);
    shape(made, box.volume.size);
    for (size_t i = 0; i < made->voxels; i++) {
        for (int channel = 0; channel < 4; channel++) {
            made->rgba[i][channel] = box.voxels[i][channel] / (double)PAPER_FULL;
        }
    }
    paper_volume_free(&box);
}

/* The head through a palette of 16 bits. */
static void make_head(picture_scene *made)
{
    uint16_t palette[QV_PALETTE_ENTRIES][4], voxels[3];
    uint8_t *scan = ref_scan_reduced(voxels, head_factor);
    paper_require(scan != NULL, "cannot read the scan (Debian's mricron-data)");
    ref_scan_palette(palette);
    shape(made, voxels);
    for (size_t i = 0; i < made->voxels; i++) {
        for (int channel = 0; channel < 4; channel++) {
            made->rgba[i][channel] = palette[scan[i]][channel] / (double)PAPER_FULL;
        }
    }
    free(scan);
    const paper_view view = {30, 20, 1.3 * voxels[1] / edge, 1, edge, edge};
    paper_look(&made->scene, &view);
}

typedef struct scene_kind {
    const char *name;
    fill *by;      /* or */
    unsigned from; /* a box of the paper */
    bool low;
} scene_kind;

static const scene_kind kinds[picture_scenes] = {
    {"mist", fill_mist, 0, false},     {"haze", fill_haze, 0, false},
    {"thin", fill_thin, 0, true},      {"film", fill_film, 0, true},
    {"veil", fill_veil, 0, true},      {"cloud", fill_cloud, 0, false},
    {"shells", fill_shells, 0, false}, {"noise", fill_noise, 0, false},
    {"corner", NULL, 0, false},        {"graze", NULL, 1, false},
    {"phase", NULL, 2, false},         {"head", NULL, 0, false},
};

void picture_scene_make(picture_scene *made, unsigned number)
{
    const scene_kind *kind = &kinds[number];
    memset(made, 0, sizeof *made);
    made->name = kind->name;
    made->low = kind->low;
    made->edge = edge;
    if (kind->by != NULL) {
        make_filled(made, kind->by);
    } else if (number == scene_head) {
        make_head(made);
    } else {
        make_box(made, &box_scenes[kind->from]);
    }
}

void picture_scene_free(picture_scene *made)
{
    free(made->rgba);
    made->rgba = NULL;
}

void picture_fog_make(picture_scene *made, const double rgba[4], unsigned samples)
{
    const uint16_t column[3] = {1, 1, (uint16_t)samples};
    memset(made, 0, sizeof *made);
    made->name = "fog";
    made->edge = 1;
    shape(made, column);
    for (size_t i = 0; i < made->voxels; i++) {
        memcpy(made->rgba[i], rgba, sizeof made->rgba[i]);
    }
    paper_look_along_z(&made->scene, 0.5, 1);
}
