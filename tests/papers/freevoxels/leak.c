/*
 * leak.c - figure 6: splats that are blended back to front (equation 9) let more light through
 * than voxels that are blended as one (equation 8); splats with their attenuation (equation 10)
 * do not.
 *
 * Where four columns of voxels meet, a pixel takes a quarter of each: a layer of opacity a lets
 * (1 - a / 4)^4 through, not 1 - a. Voxels are white before black, so that n layers show as
 * 1 - (1 - a)^n.
 */
#include "columns.h"
#include "freevoxels.h"

#include <math.h>
#include <string.h>

/* Of four quarters: light that passes a layer. */
static double passes_quarters(double opacity)
{
    return pow(1 - opacity / 4, 4);
}

/* ---- Numbers -------------------------------------------------------------------- */

/* Two voxels side by side, of which a pixel takes 3/8 each: the product of the two shares is what
   equation 8 has not. Scaled to shares of a half, as the leak is stated. */
static void two_splats(FILE *table, double opacity)
{
    const uint16_t size[3] = {2, 1, 1};
    const double share = 3. / 8, scale = 0.25 / (share * share);
    char what[96];
    (void)snprintf(what, sizeof what, "two splats, opacity %g: conventional leaks", opacity);
    const paper_row over = {what, "-", 255 * opacity * opacity / 4,
                            scale * columns_off(&qv_splatting_over, opacity, size, 2 * share), 0.1};
    paper_table_add(table, &over);
    (void)snprintf(what, sizeof what, "two splats, opacity %g: FreeVoxels leak", opacity);
    const paper_row added = {
        what, "0", 0, scale * columns_off(&qv_splatting_added, opacity, size, 2 * share), 0.5};
    paper_table_add(table, &added);
}

static void cube(FILE *table, double opacity)
{
    const uint16_t size[3] = {2, 1200, 2}; /* of the faintest, opacity 0.01, all but 10^-5 */
    double worst = 0;
    char what[96];
    for (int layers = 1; layers <= size[1]; layers++) {
        worst = fmax(worst, pow(passes_quarters(opacity), layers) - pow(1 - opacity, layers));
    }
    (void)snprintf(what, sizeof what, "cube, opacity %g: conventional leaks", opacity);
    const paper_row over = {what, "-", 255 * worst,
                            columns_off(&qv_splatting_over, opacity, size, 1), 0.1};
    paper_table_add(table, &over);
    (void)snprintf(what, sizeof what, "cube, opacity %g: FreeVoxels leak", opacity);
    const paper_row added = {what, "0", 0, columns_off(&qv_splatting_added, opacity, size, 1), 0.5};
    paper_table_add(table, &added);
}

/* ---- Figure 6 --------------------------------------------------------------------- */

enum { width = 24 /* voxels */, zoom = 14 /* pixels a voxel */, edge = (width + 2) * zoom };

/* A block of voxels seen from the front. */
typedef struct front {
    uint16_t layers;
    double opacity;
    double gain; /* of what is shown of its error */
} front;

static const front fronts[] = {{1, 0.9, 4}, {4, 0.5, 16}, {width, 0.07, 96}};

static void fill_sky(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    const double sky[3] = {0.42, 0.7, 1};
    (void)at;
    for (int channel = 0; channel < 3; channel++) {
        rgba[channel] = paper_channel(sky[channel]);
    }
    rgba[3] = paper_channel(*(const double *)from);
}

/* At a pixel whose corner is in the middle of four voxels. */
static double exact_leak(const front *of)
{
    const double share = 0.5 / zoom, large = 0.5 + share, small = 0.5 - share, a = of->opacity;
    const double passes =
        (1 - a * large * large) * pow(1 - a * large * small, 2) * (1 - a * small * small);
    return 255 * (pow(passes, of->layers) - pow(1 - a, of->layers));
}

/* How far a picture is from exact, as a picture; returns the farthest, in levels. Voxels at the
   border, which have no neighbours there, are left out. */
static double show_error(paper_picture *made, const paper_picture *of, const front *from)
{
    const double exact = 1 - pow(1 - from->opacity, from->layers);
    const uint32_t first = 2 * zoom, end = edge - 2 * zoom;
    double worst = 0;
    paper_picture_make(made, edge, edge);
    for (uint32_t y = first; y < end; y++) {
        for (uint32_t x = first; x < end; x++) {
            const size_t at = x + (size_t)y * edge;
            const double off = fabs(of->rgba[at][3] - exact);
            worst = fmax(worst, off);
            made->rgba[at][0] = made->rgba[at][1] = made->rgba[at][2] = fmin(1, from->gain * off);
        }
    }
    return 255 * worst;
}

/* Draws it one way and writes picture and error; returns the farthest off. */
static double draw(const char *folder, const front *of, const char *how,
                   const qv_splat_scene *scene, const qv_attenuation *light)
{
    char name[64];
    paper_picture picture, error;
    paper_splat(&picture, scene, &scene->volume, light);
    const double worst = show_error(&error, &picture, of);
    (void)snprintf(name, sizeof name, "leak-%u-%s", (unsigned)of->layers, how);
    paper_write_picture(folder, name, &picture);
    (void)snprintf(name, sizeof name, "leak-%u-%s-error", (unsigned)of->layers, how);
    paper_write_picture(folder, name, &error);
    paper_picture_free(&picture);
    paper_picture_free(&error);
    return worst;
}

static void draw_front(FILE *table, const char *folder, const front *of)
{
    const paper_view view = {0, 0, 1.0 / zoom, 1, edge, edge};
    paper_volume made;
    attenuated light;
    qv_splat_scene scene;
    char what[96];
    paper_volume_make(&made, width, of->layers, width);
    paper_volume_fill(&made, fill_sky, &of->opacity);
    made.volume.unit_distance = QV_ONE_Q16;
    splat_scene_make(&scene, &made.volume, &view);
    scene.kernel = &qv_kernel_linear;
    attenuated_make(&light, &made.volume, scene.directions, 0);
    const double freely = draw(folder, of, "added", &scene, light.level);
    scene.splatting = &qv_splatting_over;
    const double blended = draw(folder, of, "over", &scene, light.level);
    (void)snprintf(what, sizeof what, "figure 6, %u layers: conventional", (unsigned)of->layers);
    const paper_row over = {what, "-", exact_leak(of), blended, 0.1};
    paper_table_add(table, &over);
    (void)snprintf(what, sizeof what, "figure 6, %u layers: FreeVoxels", (unsigned)of->layers);
    const paper_row added = {what, "0", 0, freely, 0.5};
    paper_table_add(table, &added);
    attenuated_free(&light);
    paper_volume_free(&made);
}

void leak(FILE *table, const char *folder)
{
    static const double opacities[] = {0.01, 0.05, 0.1, 0.25, 0.5, 0.9};
    const size_t count = sizeof opacities / sizeof opacities[0];
    paper_table_begin(table, "\n## Figure 6 and equations 8 to 10: the leak, in levels");
    for (size_t i = 0; i < count; i++) {
        two_splats(table, opacities[i]);
    }
    for (size_t i = 0; i < count; i++) {
        cube(table, opacities[i]);
    }
    FILE *index = paper_open(folder, "leak.index");
    for (size_t i = 0; i < sizeof fronts / sizeof fronts[0]; i++) {
        const front *of = &fronts[i];
        fprintf(index, "%u %g %g\n", (unsigned)of->layers, of->opacity, of->gain);
        draw_front(table, folder, of);
    }
    paper_close(index);
}
