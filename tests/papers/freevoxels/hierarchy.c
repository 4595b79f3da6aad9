/*
 * hierarchy.c - section 3.2: coarser levels with light by equation 7, the geometric mean of
 * the voxels that a block is made of, and with light built anew on the level's own voxels.
 *
 * What lies between a block and the viewer darkens it in both. The mean counts half of the
 * block itself besides: of a block m voxels wide, (m - 1) / 2 of them stand before the middle one.
 * Its own opacity says that already.
 */
#include "freevoxels.h"
#include "head.h"

#include <math.h>
#include <string.h>

enum { edge = 256 /* pixels */ };

/* ---- One level, two ways -------------------------------------------------------- */

typedef enum way { GEOMETRIC, REBUILT, WAYS } way;

static const char *const way_names[WAYS] = {"geometric", "rebuilt"};

/* What of a volume all levels and views share. */
typedef struct subject {
    const char *name;
    paper_volume made;
    paper_pyramid pyramid;
} subject;

static void subject_finish(subject *made, const char *name)
{
    made->name = name;
    paper_pyramid_make(&made->pyramid, &made->made.volume, &qv_filter_box2, &qv_domain_extinction,
                       coarsest_level);
}

static void subject_free(subject *of)
{
    paper_pyramid_free(&of->pyramid);
    paper_volume_free(&of->made);
}

/* Draws one level; `mean` has the bytes of all. */
static void draw_level(paper_picture *made, const subject *of, const paper_view *view,
                       uint8_t number, way by, const attenuated *mean)
{
    qv_splat_scene scene;
    attenuated anew;
    qv_volume level;
    splat_scene_make(&scene, &of->made.volume, view);
    scene.level = scene.coarsest = number;
    paper_require(qv_pyramid_level(&level, &of->made.volume, &of->pyramid.pyramid, number) == QV_OK,
                  "cannot describe a level");
    if (by == REBUILT && number > 0) {
        attenuated_make(&anew, &level, scene.directions, 0);
        paper_splat(made, &scene, &level, anew.level);
        attenuated_free(&anew);
    } else {
        paper_splat(made, &scene, &level, &mean->level[number]);
    }
}

/* ---- Levels against level 0 --------------------------------------------------------- */

/* How far levels are from level 0, summed over views. */
typedef struct levels_error {
    double rms[coarsest_level + 1][WAYS];        /* levels of 8 bits */
    double brightness[coarsest_level + 1][WAYS]; /* of level 0's */
    double opacity[coarsest_level + 1][WAYS];    /* of level 0's */
} levels_error;

static double brightness_of(const paper_picture *of)
{
    double sum = 0;
    for (size_t i = 0; i < (size_t)edge * edge; i++) {
        sum += ref_grey(of->rgba[i]);
    }
    return sum;
}

static double opacity_of(const paper_picture *of)
{
    double sum = 0;
    for (size_t i = 0; i < (size_t)edge * edge; i++) {
        sum += of->rgba[i][3];
    }
    return sum;
}

static void compare_level(levels_error *into, const paper_picture *level,
                          const paper_picture *first, uint8_t number, way by)
{
    into->rms[number][by] += paper_rms(first, level);
    into->brightness[number][by] += brightness_of(level) / brightness_of(first);
    into->opacity[number][by] += opacity_of(level) / opacity_of(first);
}

static void write_level(const char *folder, const char *name, const paper_picture *level,
                        uint8_t number, way by)
{
    char file[64];
    if (folder != NULL) {
        (void)snprintf(file, sizeof file, "%s-%s-%u", name, way_names[by], (unsigned)number);
        paper_write_picture(folder, file, level);
    }
}

/* Draws all levels from one side. */
static void compare_levels(levels_error *into, const subject *of, const paper_view *view,
                           const char *folder)
{
    qv_splat_scene scene;
    attenuated mean;
    paper_picture first, level;
    splat_scene_make(&scene, &of->made.volume, view);
    attenuated_make(&mean, &of->made.volume, scene.directions, coarsest_level);
    draw_level(&first, of, view, 0, GEOMETRIC, &mean);
    for (way by = GEOMETRIC; by < WAYS; by++) {
        compare_level(into, &first, &first, 0, by);
        write_level(folder, of->name, &first, 0, by);
        for (uint8_t number = 1; number <= coarsest_level; number++) {
            draw_level(&level, of, view, number, by, &mean);
            compare_level(into, &level, &first, number, by);
            write_level(folder, of->name, &level, number, by);
            paper_picture_free(&level);
        }
    }
    paper_picture_free(&first);
    attenuated_free(&mean);
}

static void add_rows(FILE *table, const char *name, const levels_error *of, double views)
{
    char what[96];
    for (unsigned number = 1; number <= coarsest_level; number++) {
        (void)snprintf(what, sizeof what, "%s, level %u: brightness of level 0's", name, number);
        pairs_add(table, what, of->brightness[number][GEOMETRIC] / views,
                  of->brightness[number][REBUILT] / views);
        (void)snprintf(what, sizeof what, "%s, level %u: opacity of level 0's", name, number);
        pairs_add(table, what, of->opacity[number][GEOMETRIC] / views,
                  of->opacity[number][REBUILT] / views);
        (void)snprintf(what, sizeof what, "%s, level %u: RMS from level 0", name, number);
        pairs_add(table, what, of->rms[number][GEOMETRIC] / views,
                  of->rms[number][REBUILT] / views);
    }
}

/* The same levels for gnuplot. */
static void write_curves(const char *folder, const char *name, const levels_error *of, double views)
{
    char file_name[64];
    (void)snprintf(file_name, sizeof file_name, "hierarchy-%s.dat", name);
    FILE *data = paper_open(folder, file_name);
    for (unsigned number = 0; number <= coarsest_level; number++) {
        fprintf(data, "%u %.4f %.4f %.4f %.4f\n", number, of->brightness[number][GEOMETRIC] / views,
                of->brightness[number][REBUILT] / views, of->rms[number][GEOMETRIC] / views,
                of->rms[number][REBUILT] / views);
    }
    paper_close(data);
}

/* ---- The head ---------------------------------------------------------------------------- */

static const paper_view views[] = {
    {135, 10, 236.0 / edge, 1, edge, edge},
    {180, 0, 236.0 / edge, 1, edge, edge},
    {70, 40, 236.0 / edge, 1, edge, edge},
};
enum { views_count = sizeof views / sizeof views[0] };

static void head_levels(FILE *table, const char *folder, const char *name,
                        void (*transfer)(qv_transfer *made))
{
    levels_error error;
    qv_transfer colours;
    subject head;
    memset(&error, 0, sizeof error);
    transfer(&colours);
    head_make(&head.made, &colours, 1);
    subject_finish(&head, name);
    for (int i = 0; i < views_count; i++) {
        compare_levels(&error, &head, &views[i], i == 0 ? folder : NULL);
    }
    add_rows(table, name, &error, views_count);
    write_curves(folder, name, &error, views_count);
    subject_free(&head);
}

/* ---- Fog, for which both are known in closed form ------------------------------------------ */

enum { fog_size = 64 };

static const double fog_opacity = 0.05;

static void fill_fog(uint16_t rgba[4], const unsigned at[3], const void *from)
{
    (void)at;
    (void)from;
    rgba[0] = rgba[1] = rgba[2] = PAPER_FULL;
    rgba[3] = paper_channel(fog_opacity);
}

/* The brightness of the picture's middle, where the fog shows as endless to the sides. */
static double middle_of(const subject *of, uint8_t number, way by, const attenuated *mean)
{
    const paper_view view = {0, 0, 1, 1, 2, 2};
    paper_picture picture;
    draw_level(&picture, of, &view, number, by, mean);
    const double found = picture.rgba[0][0];
    paper_picture_free(&picture);
    return found;
}

static void fog_levels(FILE *table)
{
    const double layers = 1 - pow(1 - fog_opacity, fog_size);
    subject fog;
    attenuated mean;
    char what[96];
    paper_volume_make(&fog.made, fog_size, fog_size, fog_size);
    paper_volume_fill(&fog.made, fill_fog, NULL);
    fog.made.volume.unit_distance = QV_ONE_Q16;
    subject_finish(&fog, "fog");
    attenuated_make(&mean, &fog.made.volume, ONLY(qv_direction(0, -1, 0)), coarsest_level);
    for (uint8_t number = 0; number <= 3; number++) { /* whose kernels stay in the fog */
        const double before = ((1 << number) - 1) / 2.0;
        (void)snprintf(what, sizeof what, "fog, level %u: geometric mean", (unsigned)number);
        const paper_row geometric = {what, "-", layers * pow(1 - fog_opacity, before),
                                     middle_of(&fog, number, GEOMETRIC, &mean), 0.004};
        paper_table_add(table, &geometric);
        (void)snprintf(what, sizeof what, "fog, level %u: built anew", (unsigned)number);
        const paper_row rebuilt = {what, "-", layers, middle_of(&fog, number, REBUILT, &mean),
                                   0.004};
        paper_table_add(table, &rebuilt);
    }
    attenuated_free(&mean);
    subject_free(&fog);
}

void hierarchy(FILE *table, const char *folder)
{
    paper_table_begin(table, "\n## Section 3.2: levels of a fog of 64 voxels, opacity 0.05: "
                             "brightness");
    fog_levels(table);
    pairs_begin(table, "\n### Levels of the head, from 3 sides", "geometric mean", "built anew");
    head_levels(table, folder, "skin", skin_transfer);
    head_levels(table, folder, "glass", glass_transfer);
}
