/*
 * torus.c - figure 8: an analytic torus, low-pass filtered to 8 bits, classified as an
 * isosurface (Levoy 1988) and shaded, rendered at half a voxel a step.
 */
#include "wittenbrink.h"

#include <math.h>
#include <string.h>

enum { size = 64 /* voxels an axis */, edge = 512 /* pixels of the frame */ };

static const double ring = 20, tube = 8.5; /* radii in voxels */
static const double filter = 2;            /* voxels from the surface to density 0 or 1 */
static const double thickness = 2;         /* of the isosurface, in voxels to either side */

/* Density as 8 bits hold it, 255 inside, 0 outside, at a voxel. */
static double density(double x, double y, double z)
{
    const double cx = x + 0.5 - size / 2, cy = y + 0.5 - size / 2, cz = z + 0.5 - size / 2;
    const double outside = hypot(hypot(cx, cy) - ring, cz) - tube;
    const double fraction = fmax(0, fmin(0.5 - outside / (2 * filter), 1));
    return floor(255 * fraction + 0.5);
}

/* Central differences of the density. */
static void gradient(double g[3], const unsigned at[3])
{
    const double x = at[0], y = at[1], z = at[2];
    g[0] = (density(x + 1, y, z) - density(x - 1, y, z)) / 2;
    g[1] = (density(x, y + 1, z) - density(x, y - 1, z)) / 2;
    g[2] = (density(x, y, z + 1) - density(x, y, z - 1)) / 2;
}

/* Diffuse light that fades round the whole body, and a highlight; g points inwards. */
static double shade(double *highlight, const double g[3], double length)
{
    const double light[3] = {-0.48, -0.64, 0.6};
    const double facing = -(g[0] * light[0] + g[1] * light[1] + g[2] * light[2]) / length;
    *highlight = 0.3 * pow(fmax(0, facing), 40);
    return pow(0.5 + 0.5 * facing, 1.5);
}

/*
 * Levoy's isosurface: opaque at the value 1/2, less so in proportion to the distance
 * from it, which the gradient estimates. What is transparent is black.
 */
static void classify(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    const double gold[3] = {0.9, 0.66, 0.26};
    double g[3], highlight;
    (void)from;
    gradient(g, at);
    const double length = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    const double from_surface = fabs(density(at[0], at[1], at[2]) - 127.5) / length;
    if (length == 0 || from_surface >= thickness) {
        return;
    }
    const double diffuse = shade(&highlight, g, length);
    for (int channel = 0; channel < 3; channel++) {
        rgba[channel] = paper_channel(fmin(1, gold[channel] * diffuse + highlight));
    }
    rgba[3] = paper_channel(1 - from_surface / thickness);
}

void torus(FILE *table, const char *folder)
{
    const paper_view view = {25, 40, 1.0 * size / edge, 0.5, edge, edge};
    paper_volume made;
    qv_scene scene;
    paper_table_begin(table, "\n## Figure 8: the torus");
    memset(&scene, 0, sizeof scene);
    paper_volume_make(&made, size, size, size);
    paper_volume_fill(&made, classify, NULL);
    scene.volume = made.volume;
    paper_look(&scene, &view);
    (void)compare_modes(table, folder, "torus", "-", &scene, edge);
    paper_volume_free(&made);
}
