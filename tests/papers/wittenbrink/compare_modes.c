/*
 * compare_modes.c - one scene in both modes, and how far they are apart.
 */
#include "wittenbrink.h"

/* The RMS error of the reference's two pictures. */
static double reference_rms(const qv_scene *scene, uint16_t edge)
{
    paper_picture separate, weighted;
    paper_render_reference(&separate, scene, REF_SEPARATE, edge, edge);
    paper_render_reference(&weighted, scene, REF_WEIGHTED, edge, edge);
    const double rms = paper_rms(&weighted, &separate);
    paper_picture_free(&separate);
    paper_picture_free(&weighted);
    return rms;
}

/* The same of the library's, at the pixels that the reference renders. */
static double lattice_rms(const paper_picture *weighted, const paper_picture *separate)
{
    paper_picture a, b;
    paper_thin_out(&a, weighted);
    paper_thin_out(&b, separate);
    const double rms = paper_rms(&a, &b);
    paper_picture_free(&a);
    paper_picture_free(&b);
    return rms;
}

static void write_as(const char *folder, const char *name, const char *what,
                     const paper_picture *picture)
{
    char file[64];
    (void)snprintf(file, sizeof file, "%s-%s", name, what);
    paper_write_picture(folder, file, picture);
}

static void write_difference(const char *folder, const char *name, const paper_picture *weighted,
                             const paper_picture *separate)
{
    paper_picture difference;
    paper_difference(&difference, weighted, separate);
    write_as(folder, name, "difference", &difference);
    paper_equalise(&difference);
    write_as(folder, name, "equalised", &difference);
    paper_picture_free(&difference);
}

comparison compare_modes(FILE *table, const char *folder, const char *name, const char *paper,
                         qv_scene *scene, uint16_t edge)
{
    const double allowed = 1e-4; /* of a level of 255 */
    char what[64];
    paper_picture separate, weighted;
    scene->sampling = &qv_separate_rgba16;
    paper_render(&separate, scene, edge, edge);
    scene->sampling = &qv_weighted_rgba16;
    paper_render(&weighted, scene, edge, edge);
    (void)snprintf(what, sizeof what, "RMS error, %s", name);
    const comparison found = {reference_rms(scene, edge), lattice_rms(&weighted, &separate),
                              paper_rms(&weighted, &separate)};
    const paper_row row = {what, paper, found.exact, found.ours, allowed};
    paper_table_add(table, &row);
    write_as(folder, name, "separate", &separate);
    write_as(folder, name, "weighted", &weighted);
    write_difference(folder, name, &weighted, &separate);
    paper_picture_free(&separate);
    paper_picture_free(&weighted);
    return found;
}
