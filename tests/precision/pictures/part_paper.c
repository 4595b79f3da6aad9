/*
 * part_paper.c - the figures of Wittenbrink et al., sections 5 and 7: separate against weighted
 * interpolation, and colours weighted in 8 bits against colours weighted while interpolating.
 */
#include "pictures.h"

#include "papers/associated.h"
#include "papers/boxes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The frame of `make papers`, of which every fifth row and column is rendered. */
enum { frame = 320, edge = frame / paper_lattice };

static const our_mode weighted16 = {"RGBA16", QV_STORAGE_RGBA16, &qv_weighted_rgba16, REF_WEIGHTED};
static const our_mode separate16 = {"RGBA16", QV_STORAGE_RGBA16, &qv_separate_rgba16, REF_SEPARATE};
static const our_mode weighted8 = {"RGBA8", QV_STORAGE_RGBA8, &qv_weighted_rgba8, REF_WEIGHTED};
static const our_mode separate8 = {"RGBA8", QV_STORAGE_RGBA8, &qv_separate_rgba8, REF_SEPARATE};
static const our_mode associated8 = {"preweighted", QV_STORAGE_ASSOCIATED8,
                                     &qv_preweighted_associated8, REF_WEIGHTED};

/* ---- Section 5: corner, graze and phase ------------------------------------------------ */

/* The scene of `make papers`, of fewer pixels, which are the same ones. */
static void make_scene(picture_scene *made, const box_scene *of, unsigned n, bool antialiased)
{
    paper_volume box;
    memset(made, 0, sizeof *made);
    box_make(&box, of, n, antialiased);
    box_look(&made->scene, &box, of, frame);
    made->name = of->name;
    made->edge = edge;
    made->voxels = (size_t)n * n * n;
    made->rgba = paper_memory(made->voxels, sizeof made->rgba[0]);
    for (size_t i = 0; i < made->voxels; i++) {
        for (int channel = 0; channel < 4; channel++) {
            made->rgba[i][channel] = box.voxels[i][channel] / (double)PAPER_FULL;
        }
    }
    for (int axis = 0; axis < 3; axis++) {
        made->scene.camera.across[axis] *= paper_lattice;
        made->scene.camera.down[axis] *= paper_lattice;
    }
    paper_volume_free(&box);
}

static double rms_of_ours(const picture_scene *scene, const our_mode *a, const our_mode *b)
{
    paper_picture first, second;
    ours_picture(&first, scene, a);
    ours_picture(&second, scene, b);
    const double rms = paper_rms(&first, &second);
    paper_picture_free(&first);
    paper_picture_free(&second);
    return rms;
}

/* Double precision at the library's points, as the papers' tables have it. */
static void exact_picture(paper_picture *made, const picture_scene *scene, bool separate)
{
    model as = model_reference;
    as.position = model_library.position;
    as.separate = separate;
    model_picture(made, &as, scene, &store_real);
}

static double rms_from(const paper_picture *truth, const picture_scene *scene, const our_mode *by)
{
    paper_picture got;
    ours_picture(&got, scene, by);
    const double rms = paper_rms(truth, &got);
    paper_picture_free(&got);
    return rms;
}

static const char *paper_rms_of(const box_scene *of, unsigned n, bool antialiased)
{
    static const char *const printed[2][2] = {{"39.0", "17.7"}, {"20.3", "8.32"}};
    return of == &box_scenes[0] ? printed[n == box_fine][antialiased] : "-";
}

static double add_box(table *t, const box_scene *of, unsigned n, bool antialiased)
{
    char volume[32];
    picture_scene scene;
    paper_picture weighted, separate;
    make_scene(&scene, of, n, antialiased);
    exact_picture(&weighted, &scene, false);
    exact_picture(&separate, &scene, true);
    const double exact = paper_rms(&weighted, &separate);
    const double ours = rms_of_ours(&scene, &weighted16, &separate16);
    (void)snprintf(volume, sizeof volume, "%u^3%s", n, antialiased ? ", antialiased" : "");
    table_text(t, of->name);
    table_text(t, volume);
    table_text(t, paper_rms_of(of, n, antialiased));
    table_number(t, "%.4f", exact);
    table_number(t, "%.4f", ours);
    table_number(t, "%.4f", rms_of_ours(&scene, &weighted8, &separate8));
    table_number(t, "%.2g", rms_from(&weighted, &scene, &weighted16));
    table_number(t, "%.2g", rms_from(&weighted, &scene, &weighted8));
    table_number(t, "%.2g", rms_from(&weighted, &scene, &associated8));
    paper_picture_free(&weighted);
    paper_picture_free(&separate);
    picture_scene_free(&scene);
    return fabs(ours - exact);
}

static void section_5(const char *folder)
{
    table t;
    const double allowed = 1e-4; /* as in the papers' tables */
    double worst = 0;
    printf("### 2.7 Wittenbrink et al., section 5\n\n"
           "RMS of separate against weighted interpolation, in levels of colour, over the pixels "
           "of the volume:\ndouble precision, ours, and what each storage is off weighted "
           "interpolation in double precision.\nThe paper gives neither volumes nor views, so its "
           "numbers cannot be had; `make papers` has the\npictures.\n\n");
    table_begin(&t, folder, "pictures_section5",
                "scene|volume|paper|double|RGBA16|RGBA8|weighted RGBA16 off|weighted RGBA8 "
                "off|preweighted RGBA8 off");
    for (unsigned i = 0; i < BOX_SCENES; i++) {
        for (unsigned fine = 0; fine < 2; fine++) {
            for (unsigned antialiased = 0; antialiased < 2; antialiased++) {
                const unsigned n = fine ? box_fine : box_coarse;
                worst = fmax(worst, add_box(&t, &box_scenes[i], n, antialiased != 0));
            }
        }
    }
    table_end(&t);
    goal(worst <= allowed,
         "RGBA16 has the RMS of double precision within 1e-4 level in all twelve");
    goals_end();
}

/* ---- Section 7: what weighting in 8 bits loses ------------------------------------------ */

/* The error of a picture's colours divided by its opacity, where it has any. */
static double rms_of_colours(const paper_picture *got, const paper_picture *truth)
{
    double squares = 0, count = 0;
    for (size_t i = 0; i < (size_t)truth->width * truth->height; i++) {
        for (int channel = 0; channel < 3 && truth->rgba[i][3] > 0; channel++) {
            const double *a = got->rgba[i], *b = truth->rgba[i];
            squares += pow(255 * (a[channel] / a[3] - b[channel] / b[3]), 2);
            count++;
        }
    }
    return sqrt(squares / count);
}

/* Rounds the colours of a scene to 8 bits, so that opacity-weighted sampling has them exactly. */
static void make_fog(picture_scene *made, unsigned opacity)
{
    picture_scene_make(made, scene_thin);
    for (size_t i = 0; i < made->voxels; i++) {
        for (int channel = 0; channel < 3; channel++) {
            made->rgba[i][channel] = floor(made->rgba[i][channel] * 255 + 0.5) / 255;
        }
        made->rgba[i][3] = opacity / 255.0;
    }
}

static bool add_opacity(table *t, unsigned opacity)
{
    const associated_colours voxel = associate_colours(opacity);
    picture_scene scene;
    paper_picture truth, weighted, preweighted;
    make_fog(&scene, opacity);
    exact_picture(&truth, &scene, false);
    ours_picture(&weighted, &scene, &weighted8);
    ours_picture(&preweighted, &scene, &associated8);
    table_number(t, "%.0f", opacity);
    table_number(t, "%.2f", 127.5 / opacity);
    table_number(t, "%.2f", voxel.off);
    table_number(t, "%.0f", voxel.distinct);
    table_number(t, "%.2g", rms_of_colours(&weighted, &truth));
    table_number(t, "%.3g", rms_of_colours(&preweighted, &truth));
    paper_picture_free(&truth);
    paper_picture_free(&weighted);
    paper_picture_free(&preweighted);
    picture_scene_free(&scene);
    return voxel.off <= 127.5 / opacity && voxel.distinct == opacity + 1;
}

static void section_7(const char *folder)
{
    static const unsigned opacities[] = {1, 2, 3, 5, 8, 16, 32, 64, 128, 192, 255};
    table t;
    bool holds = true;
    printf(
        "### 2.8 Wittenbrink et al., section 7\n\n"
        "Colours of 8 bits, weighted by an opacity of 8 bits and stored in 8 bits, are off by "
        "up to\n1/2 * 255/opacity levels of their own; only opacity + 1 of them differ. A voxel: "
        "all 256 colours.\nA picture: the scene thin with this opacity, colours divided by "
        "opacity again, RMS in levels.\n\n"
        "Plot: `pictures_section7.png`.\n\n");
    table_begin(&t, folder, "pictures_section7",
                "opacity of 255|bound|voxel: worst|distinct colours|picture: weighted while "
                "interpolating|preweighted 8 bits");
    for (size_t i = 0; i < COUNT(opacities); i++) {
        holds = add_opacity(&t, opacities[i]) && holds;
    }
    table_end(&t);
    goal(holds, "preweighted 8 bits: within 1/2 * 255/opacity, opacity + 1 distinct colours");
    goals_end();
}

void part_paper(const char *folder)
{
    section_5(folder);
    section_7(folder);
}
