/*
 * between.c - how far the head is off between directions: views from before an axis to before a
 * diagonal of a face, on to a diagonal of the cube, and back. Against the same splats with light
 * along a ray from each voxel, in double precision.
 */
#include "freevoxels.h"
#include "head.h"

#include "reference/freevoxels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { edge = 48 /* pixels */, factor = 8 /* by which the scan is reduced */ };

static const double pi = 3.14159265358979323846;

static const qv_interpolation ways[] = {QV_NEAREST, QV_BETWEEN_DEPTHS, QV_BETWEEN_LIGHT};
enum { ways_count = sizeof ways / sizeof ways[0] };

/* The head, its bytes, and what rays are cast through. */
typedef struct subject {
    paper_volume made;
    attenuated light;
    ref_field field;
} subject;

/* A viewer who stands where v leads. */
static paper_view view_from(const double v[3])
{
    const double radians = 180 / pi;
    const paper_view view = {
        atan2(v[0], -v[1]) * radians, asin(v[2]) * radians, factor, 1, edge, edge};
    return view;
}

static void draw_exactly(paper_picture *made, const subject *of, const qv_splat_scene *scene,
                         const paper_view *view)
{
    ref_sums *sums = paper_memory((size_t)edge * edge, sizeof *sums);
    ref_splats splats = {.scene = scene,
                         .levels = &of->made.volume,
                         .kernel = 3,
                         .depths = {ref_depth_of_ray, &of->field}};
    splats.view = (ref_view){.pitch = view->pitch, .step = 1, .width = edge, .height = edge};
    for (int i = 0; i < 9; i++) {
        splats.view.rotation[i / 3][i % 3] = ldexp(scene->view.rotation[i / 3][i % 3], -30);
    }
    ref_splat_clear(sums, &splats);
    ref_splat_level(sums, &splats, 0);
    paper_picture_make(made, edge, edge);
    for (size_t i = 0; i < (size_t)edge * edge; i++) {
        ref_pixel pixel;
        ref_splat_read_out(&pixel, sums[i], &splats);
        memcpy(made->rgba[i], pixel.rgba, sizeof pixel.rgba);
    }
    free(sums);
}

/* A line of data: degrees on the way, RMS of each way to know light. */
static void add_view(FILE *data, double degrees, const subject *of, const double v[3])
{
    const paper_view view = view_from(v);
    paper_picture exact, ours;
    qv_splat_scene scene;
    splat_scene_make(&scene, &of->made.volume, &view);
    scene.directions = QV_DIRECTIONS_ALL;
    draw_exactly(&exact, of, &scene, &view);
    fprintf(data, "%.2f", degrees);
    for (int way = 0; way < ways_count; way++) {
        scene.interpolation = (uint8_t)ways[way];
        paper_splat(&ours, &scene, &of->made.volume, of->light.level);
        fprintf(data, " %.4f", paper_rms(&exact, &ours));
        paper_picture_free(&ours);
    }
    fputc('\n', data);
    paper_picture_free(&exact);
}

/* Along the great circle from one unit vector to another; returns the degrees in the end. */
static double walk(FILE *data, double degrees, const subject *of, const double from[3],
                   const double to[3])
{
    const double whole = acos(from[0] * to[0] + from[1] * to[1] + from[2] * to[2]);
    const int steps = (int)ceil(whole * 180 / pi / 2.5);
    for (int step = 0; step <= steps; step++) {
        const double done = whole * step / steps;
        double v[3];
        for (int axis = 0; axis < 3; axis++) {
            v[axis] = (from[axis] * sin(whole - done) + to[axis] * sin(done)) / sin(whole);
        }
        add_view(data, degrees + done * 180 / pi, of, v);
    }
    return degrees + whole * 180 / pi;
}

void between(const char *folder)
{
    const double face[3] = {0, 1, 0}, side[3] = {sqrt(1. / 2), sqrt(1. / 2), 0};
    const double corner[3] = {sqrt(1. / 3), sqrt(1. / 3), sqrt(1. / 3)};
    qv_transfer glass;
    subject head;
    FILE *data = paper_open(folder, "between.dat");
    glass_transfer(&glass);
    head_make(&head.made, &glass, factor);
    attenuated_make(&head.light, &head.made.volume, QV_DIRECTIONS_ALL, 0);
    paper_require(ref_field_make(&head.field, &head.made.volume), "out of memory");
    double degrees = walk(data, 0, &head, face, side);
    degrees = walk(data, degrees, &head, side, corner);
    (void)walk(data, degrees, &head, corner, face);
    ref_field_free(&head.field);
    attenuated_free(&head.light);
    paper_volume_free(&head.made);
    paper_close(data);
}
