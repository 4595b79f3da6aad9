/*
 * equations.c - equation 16 against 22, and 17 against 23: a voxel alone, crossed in one
 * step, as long as the step, whose opacity is stored for a length of 1. Full opacity is
 * left out: the library takes it for a depth of 64, the equations for an infinite one.
 */
#include "kraus.h"

#include <math.h>
#include <string.h>

static const double ratios[] = {1.0 / 16, 0.25, 1, 4, 16};

/* An unweighted colour. */
static const double red = 0.75;

/* A quarter of a level of 16 bits. */
static const double allowed = 0.25 / PAPER_FULL;

/* Farthest from equations 16 and 22, and from 17 and 23. */
typedef struct farthest {
    double opacity, colour;
} farthest;

static void cross(farthest *found, double ratio, uint16_t opacity, const qv_sampling *sampling)
{
    const double exact = 1 - pow(1 - opacity / (double)PAPER_FULL, ratio);
    const double colour = paper_channel(red) / (double)PAPER_FULL;
    paper_volume made;
    qv_scene scene;
    double rgba[4];
    memset(&scene, 0, sizeof scene);
    paper_volume_make(&made, 1, 1, 1);
    made.voxels[0][0] = paper_channel(red);
    made.voxels[0][3] = opacity;
    made.volume.unit_distance = QV_ONE_Q16;
    for (int axis = 0; axis < 3; axis++) {
        made.volume.spacing[axis] = (uint32_t)(ratio * QV_ONE_Q16);
    }
    scene.volume = made.volume;
    scene.sampling = sampling;
    paper_look_along_z(&scene, 0.5, ratio);
    scene.camera.along[2] = PAPER_VOXEL;
    paper_render_ray(rgba, &scene);
    found->opacity = fmax(found->opacity, fabs(rgba[3] - exact));
    found->colour = fmax(found->colour, fabs(rgba[0] - exact * colour));
    paper_volume_free(&made);
}

static void add(FILE *table, const char *equation, double ratio, double off)
{
    char what[96];
    (void)snprintf(what, sizeof what, "equation %s, d / d' = %g, farthest off", equation, ratio);
    const paper_row row = {what, "0", 0, off, allowed};
    paper_table_add(table, &row);
}

void equations(FILE *table)
{
    const unsigned apart = 257; /* opacities of 8 bits */
    paper_table_begin(table,
                      "\n## Equations 16, 17, 22 and 23, for every opacity of 8 bits below 1");
    for (size_t i = 0; i < sizeof ratios / sizeof ratios[0]; i++) {
        farthest corrected = {0, 0}, extinction = {0, 0};
        for (unsigned opacity = 0; opacity < PAPER_FULL; opacity += apart) {
            cross(&corrected, ratios[i], (uint16_t)opacity, &qv_corrected_rgba16);
            cross(&extinction, ratios[i], (uint16_t)opacity, &qv_extinction_rgba16);
        }
        add(table, "16", ratios[i], corrected.opacity);
        add(table, "22", ratios[i], extinction.opacity);
        add(table, "17", ratios[i], corrected.colour);
        add(table, "23", ratios[i], extinction.colour);
    }
}
