/*
 * pyramids.c - every level of a pyramid, rendered: averages of opacity lose what is thin,
 * averages of extinction keep it. The box of 4 taps is the paper's filter for trilinear
 * sampling.
 */
#include "kraus.h"

#include "subject.h"

#include <stdlib.h>
#include <string.h>

/* Opacity of level 0 from which on a pixel belongs to the silhouette. */
static const double silhouette = 0.5;

/* One of the two ways to average and to sample. */
typedef struct method {
    const char *name;
    const qv_sampling *sampling;
    ref_mode mode;
} method;

static const method by_opacity = {"opacity", &qv_corrected_rgba16_levels, REF_CORRECTED};
static const method by_extinction = {"extinction", &qv_extinction_rgbt16_levels, REF_EXTINCTION};

/* ---- From opacity to extinction ------------------------------------------------- */

/* In place. Full opacity is a depth of 17 for a length of 1: enough to be opaque, and it
   leaves more of the 16 bits to the rest than the 64 that the library takes by itself. */
static void store_extinction(paper_volume *made)
{
    const uint32_t opaque = 17 * QV_ONE_Q16;
    qv_volume *volume = &made->volume;
    const qv_entries entries = {volume->voxels,
                                (uint32_t)(volume->voxels_bytes / sizeof made->voxels[0]),
                                volume->unit_distance, 0, QV_STORAGE_RGBA16};
    paper_require(qv_extinction_of(&volume->extinction, &entries, opaque) == QV_OK &&
                      qv_opacity_to_extinction(made->voxels, (size_t)volume->voxels_bytes,
                                               QV_STORAGE_RGBT16, volume->extinction,
                                               &entries) == QV_OK,
                  "cannot convert to extinction");
    volume->storage = QV_STORAGE_RGBT16;
}

/* ---- Levels ----------------------------------------------------------------------- */

/* Mean of a channel over the pixels that are in the silhouette of level 0. */
static double mean(const paper_picture *of, const paper_picture *level0, unsigned channel)
{
    double sum = 0, pixels = 0;
    for (size_t i = 0; i < (size_t)of->width * of->height; i++) {
        if (level0->rgba[i][3] >= silhouette) {
            sum += of->rgba[i][channel];
            pixels++;
        }
    }
    return sum / pixels;
}

/* What of a channel is left in a level. */
static double left(const paper_picture *of, const paper_picture *level0, unsigned channel)
{
    return mean(of, level0, channel) / mean(level0, level0, channel);
}

/* A level's pixels on the lattice, by the library and by the reference. */
typedef struct level_pictures {
    paper_picture ours, exact;
} level_pictures;

static void free_pictures(level_pictures *of)
{
    paper_picture_free(&of->ours);
    paper_picture_free(&of->exact);
}

/* Renders a level, and writes the library's picture. */
static void render_level(level_pictures *made, const char *folder, const char *name,
                         const qv_scene *scene, const subject *of, ref_mode mode)
{
    paper_picture picture;
    paper_render(&picture, scene, of->view.width, of->view.height);
    paper_write_picture(folder, name, &picture);
    paper_thin_out(&made->ours, &picture);
    paper_picture_free(&picture);
    paper_render_reference(&made->exact, scene, mode, of->view.width, of->view.height);
}

static void add_row(FILE *table, const char *name, const level_pictures *level,
                    const level_pictures *first, unsigned channel)
{
    const paper_row row = {name, "-", left(&level->exact, &first->exact, channel),
                           left(&level->ours, &first->ours, channel), 1e-5};
    paper_table_add(table, &row);
}

static void render_levels(FILE *table, const char *folder, const subject *of, const method *as)
{
    paper_pyramid pyramid;
    level_pictures first, coarser;
    qv_scene scene;
    char name[64];
    memset(&scene, 0, sizeof scene);
    paper_pyramid_make(&pyramid, &of->made.volume, &qv_filter_box4, &qv_domain_stored, of->levels);
    scene.volume = of->made.volume;
    scene.pyramid = &pyramid.pyramid;
    scene.sampling = as->sampling;
    paper_look(&scene, &of->view);
    for (unsigned level = 0; level <= of->levels; level++) {
        level_pictures *const made = level == 0 ? &first : &coarser;
        (void)snprintf(name, sizeof name, "%s-%s-%u", of->name, as->name, level);
        scene.level = (uint16_t)(256 * level);
        render_level(made, folder, name, &scene, of, as->mode);
        if (level > 0) {
            add_row(table, name, &coarser, &first, of->kept);
            free_pictures(&coarser);
        }
    }
    free_pictures(&first);
    paper_pyramid_free(&pyramid);
}

static void render_subject(FILE *table, const char *folder, subject *of)
{
    of->made.volume.unit_distance = QV_ONE_Q16;
    render_levels(table, folder, of, &by_opacity);
    store_extinction(&of->made);
    render_levels(table, folder, of, &by_extinction);
    paper_volume_free(&of->made);
}

void pyramids(FILE *table, const char *folder)
{
    typedef void make_subject(subject * made);
    static make_subject *const subjects[] = {make_head, make_dome, make_shell};
    paper_table_begin(table, "\n## Pyramids: what a level keeps of level 0, of the head red "
                             "light, else opacity");
    for (size_t i = 0; i < sizeof subjects / sizeof subjects[0]; i++) {
        subject of;
        subjects[i](&of);
        render_subject(table, folder, &of);
    }
}
