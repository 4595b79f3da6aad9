/*
 * uniform_cube.c - figure 2: how much light reaches each voxel of a uniform cube along three
 * directions, once as published, where a voxel's opacity holds for a step of any direction, and
 * once for the length of the step.
 *
 * The cube shown has a voxel's transmittance for its grey. It is seen from aside; arrows show the
 * way from the viewer for whom light is attenuated. What no light leaves is a box, for each of
 * these directions: it is outlined.
 */
#include "freevoxels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { size = 32 /* voxels an axis */, edge = 440 /* pixels */ };

static const double opacity = 0.25;
static const paper_view view = {32, 28, 2.05 * size / edge, 0.25, edge, edge};

/* A viewer's way through the cube. */
typedef struct way {
    const char *name;
    int step[3];
} way;

static const way ways[] = {
    {"face", {1, 0, 0}},
    {"edge", {1, -1, 0}},
    {"corner", {1, -1, -1}},
};

static double length_of(const way *of)
{
    return sqrt(of->step[0] * of->step[0] + of->step[1] * of->step[1] + of->step[2] * of->step[2]);
}

/* ---- Volumes ------------------------------------------------------------------ */

static void fill_grey(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    (void)at;
    (void)from;
    rgba[0] = rgba[1] = rgba[2] = PAPER_FULL;
    rgba[3] = paper_channel(opacity);
}

static void fill_transmittance(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    const attenuated *light = from;
    const uint8_t byte = attenuated_byte(light, at[0], at[1], at[2]);
    rgba[0] = rgba[1] = rgba[2] = (uint16_t)(byte * (PAPER_FULL / 255));
    rgba[3] = PAPER_FULL;
}

/* The number of voxels between one and where the way enters the cube. */
static unsigned voxels_before(const way *of, const unsigned at[3])
{
    unsigned least = size;
    for (int axis = 0; axis < 3; axis++) {
        const unsigned before = of->step[axis] > 0 ? at[axis] : size - 1 - at[axis];
        least = of->step[axis] != 0 && before < least ? before : least;
    }
    return least;
}

/* ---- Numbers -------------------------------------------------------------------- */

/* The bytes of a cube against closed forms. */
typedef struct found {
    double worst;   /* of all bytes, in levels */
    unsigned black; /* the fewest voxels before one of byte 0 */
} found;

static void compare(found *into, const attenuated *light, const way *of, double step)
{
    unsigned at[3];
    *into = (found){0, size};
    for (at[2] = 0; at[2] < size; at[2]++) {
        for (at[1] = 0; at[1] < size; at[1]++) {
            for (at[0] = 0; at[0] < size; at[0]++) {
                const unsigned before = voxels_before(of, at);
                const double exact = 255 * pow(1 - opacity, before * step);
                const uint8_t byte = attenuated_byte(light, at[0], at[1], at[2]);
                into->worst = fmax(into->worst, fabs(byte - exact));
                into->black = byte == 0 && before < into->black ? before : into->black;
            }
        }
    }
}

static void add_rows(FILE *table, const char *name, const found *of, double step)
{
    const double black = log2(510) / (-log2(1 - opacity) * step);
    char what[128];
    (void)snprintf(what, sizeof what, "%s: byte, farthest off", name);
    const paper_row worst = {what, "-", 0, of->worst, 0.51};
    paper_table_add(table, &worst);
    (void)snprintf(what, sizeof what, "%s: totally occluded behind so many voxels", name);
    const paper_row occluded = {what, "-", ceil(black), of->black, 0};
    paper_table_add(table, &occluded);
}

/* ---- Pictures --------------------------------------------------------------------- */

/* Where a point of the cube, in voxels, is in the picture. */
static void project(double pixel[2], const double point[3])
{
    qv_view frame;
    paper_frame(&frame, &view);
    for (int i = 0; i < 2; i++) {
        pixel[i] = edge / 2.0;
        for (int axis = 0; axis < 3; axis++) {
            pixel[i] +=
                ldexp(frame.rotation[i][axis], -30) * (point[axis] - size / 2.0) / view.pitch;
        }
    }
}

static void write_point(FILE *data, const double point[3])
{
    double pixel[2];
    project(pixel, point);
    fprintf(data, "%.2f %.2f\n", pixel[0], pixel[1]);
}

static void write_line(FILE *data, const double from[3], const double to[3])
{
    write_point(data, from);
    write_point(data, to);
    fputc('\n', data);
}

/* Whether a line along an axis lies on a face that the viewer sees: -y, +x and +z. */
static bool seen(const double from[3], const double to[3])
{
    return (from[1] <= 0 && to[1] <= 0) || (from[0] >= size && to[0] >= size) ||
           (from[2] >= size && to[2] >= size);
}

/* The edges of a box that can be seen. */
static void write_box(FILE *data, const double low[3], const double high[3])
{
    for (int axis = 0; axis < 3; axis++) {
        for (int corner = 0; corner < 4; corner++) {
            const int second = (axis + 1) % 3, third = (axis + 2) % 3;
            double from[3] = {low[0], low[1], low[2]}, to[3];
            from[second] = (corner & 1) != 0 ? high[second] : low[second];
            from[third] = (corner & 2) != 0 ? high[third] : low[third];
            memcpy(to, from, sizeof to);
            to[axis] = high[axis];
            if (seen(from, to)) {
                write_line(data, from, to);
            }
        }
    }
}

/* An arrow that ends shortly before the way enters the cube. */
static void write_arrow(FILE *data, const way *of)
{
    const double pixels = 62, before = 1.06 * size / 2;
    double centre[2], head[2], point[3] = {size / 2.0, size / 2.0, size / 2.0};
    project(centre, point);
    for (int axis = 0; axis < 3; axis++) {
        point[axis] -= before * of->step[axis];
    }
    project(head, point);
    const double dx = centre[0] - head[0], dy = centre[1] - head[1];
    const double scale = pixels / hypot(dx, dy);
    fprintf(data, "%.2f %.2f %.2f %.2f\n", head[0] - scale * dx, head[1] - scale * dy, scale * dx,
            scale * dy);
}

/* The arrow, the cube, and what is occluded: blocks of lines for gnuplot. */
static void write_lines(const char *folder, const char *name, const way *of, unsigned black)
{
    double low[3] = {0, 0, 0}, high[3] = {size, size, size};
    char file_name[80];
    (void)snprintf(file_name, sizeof file_name, "%s.lines", name);
    FILE *data = paper_open(folder, file_name);
    write_arrow(data, of);
    fputs("\n\n", data);
    write_box(data, low, high);
    fputs("\n", data);
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = of->step[axis] > 0 ? black : 0;
        high[axis] = of->step[axis] < 0 ? (double)size - black : size;
    }
    write_box(data, low, high);
    paper_close(data);
}

static void draw(const char *folder, const char *name, const attenuated *light)
{
    const uint8_t wall[4] = {92, 110, 138, 255};
    paper_volume shown;
    paper_picture picture;
    qv_scene scene;
    paper_volume_make(&shown, size, size, size);
    paper_volume_fill(&shown, fill_transmittance, light);
    memset(&scene, 0, sizeof scene);
    scene.volume = shown.volume;
    scene.sampling = &qv_extinction_rgba16;
    memcpy(scene.background, wall, sizeof wall);
    paper_look(&scene, &view);
    paper_render(&picture, &scene, edge, edge);
    paper_write_picture(folder, name, &picture);
    paper_picture_free(&picture);
    paper_volume_free(&shown);
}

/* ---- All of them ------------------------------------------------------------------ */

static void along(FILE *table, const char *folder, const qv_volume *volume, const way *of)
{
    const bool corrected = volume->unit_distance != 0;
    const double step = corrected ? length_of(of) : 1;
    const uint8_t direction = qv_direction(-of->step[0], -of->step[1], -of->step[2]);
    attenuated light;
    found bytes;
    char name[64];
    (void)snprintf(name, sizeof name, "cube-%s-%s", corrected ? "corrected" : "published",
                   of->name);
    attenuated_make(&light, volume, ONLY(direction), 0);
    compare(&bytes, &light, of, step);
    add_rows(table, name, &bytes, step);
    draw(folder, name, &light);
    write_lines(folder, name, of, bytes.black);
    attenuated_free(&light);
}

void uniform_cube(FILE *table, const char *folder)
{
    paper_volume cube;
    paper_volume_make(&cube, size, size, size);
    paper_volume_fill(&cube, fill_grey, NULL);
    paper_table_begin(table, "\n## Figure 2: a uniform cube, opacity 0.25 a voxel");
    for (int corrected = 0; corrected < 2; corrected++) {
        cube.volume.unit_distance = corrected != 0 ? QV_ONE_Q16 : 0;
        for (size_t i = 0; i < sizeof ways / sizeof ways[0]; i++) {
            along(table, folder, &cube.volume, &ways[i]);
        }
    }
    paper_volume_free(&cube);
}
