/*
 * part_storage.c - storage that other people use, through the same scenes.
 */
#include "pictures.h"

#include <math.h>

static const our_mode rgba16 = {"RGBA16", QV_STORAGE_RGBA16, &qv_weighted_rgba16, REF_WEIGHTED};
static const our_mode rgba8 = {"RGBA8", QV_STORAGE_RGBA8, &qv_weighted_rgba8, REF_WEIGHTED};
static const our_mode associated8 = {"preweighted RGBA8", QV_STORAGE_ASSOCIATED8,
                                     &qv_preweighted_associated8, REF_WEIGHTED};

static const store stores[] = {
    {"RGBA8", STORE_UNORM, 8, false},      {"preweighted RGBA8", STORE_UNORM, 8, true},
    {"15 bits", STORE_UNORM, 15, false},   {"preweighted 15 bits", STORE_UNORM, 15, true},
    {"RGBA16", STORE_UNORM, 16, false},    {"preweighted RGBA16", STORE_UNORM, 16, true},
    {"half floats", STORE_HALF, 0, false}, {"preweighted half floats", STORE_HALF, 0, true},
};

/* Four channels, of whole bytes each. */
static unsigned voxel_bytes(const store *of)
{
    return of->kind == STORE_UNORM && of->bits <= 8 ? 4 : 8;
}

/* ---- Ways to render ---------------------------------------------------------------------- */

typedef void render(paper_picture *made, const picture_scene *scene);

static void render_rgba16(paper_picture *made, const picture_scene *scene)
{
    ours_picture(made, scene, &rgba16);
}

static void render_rgba8(paper_picture *made, const picture_scene *scene)
{
    ours_picture(made, scene, &rgba8);
}

static void render_associated8(paper_picture *made, const picture_scene *scene)
{
    ours_picture(made, scene, &associated8);
}

static void render_mapper(paper_picture *made, const picture_scene *scene)
{
    mapper_picture(made, scene, false);
}

static void render_mapper_associated(paper_picture *made, const picture_scene *scene)
{
    mapper_picture(made, scene, true);
}

static void render_half(paper_picture *made, const picture_scene *scene)
{
    const store half = {"half floats", STORE_HALF, 0, true};
    model as = model_reference;
    as.light = as.transmittance = model_half;
    model_picture(made, &as, scene, &half);
}

typedef struct way {
    const char *name;
    render *by;
    unsigned bytes; /* of a voxel */
} way;

static const way ways[] = {
    {"ours, RGBA16", render_rgba16, 8},
    {"ours, RGBA8", render_rgba8, 4},
    {"ours, preweighted RGBA8", render_associated8, 4},
    {"15 bits throughout, preweighted", render_mapper_associated, 8},
    {"15 bits throughout, separate, as VTK", render_mapper, 8},
    {"half floats throughout, preweighted", render_half, 8},
};

/* ---- Tables -------------------------------------------------------------------------------- */

/* A row: RMS of each scene, and the worst error of any. */
static void add_all(table *t, const char *name, unsigned bytes,
                    const picture_error errors[picture_scenes])
{
    double worst = 0;
    table_text(t, name);
    table_number(t, "%.0f", bytes);
    for (unsigned number = 0; number < picture_scenes; number++) {
        table_number(t, "%.2g", error_rms(&errors[number]));
        worst = fmax(worst, errors[number].worst);
    }
    table_number(t, "%.3g", worst);
}

static const char columns[] = "RMS, levels|bytes|mist|haze|thin|film|veil|cloud|shells|noise|"
                              "corner|graze|phase|head|worst of any";

typedef struct found {
    picture_error stored[COUNT(stores)][picture_scenes], rendered[COUNT(ways)][picture_scenes];
} found;

static void add_scene(found *into, unsigned number)
{
    picture_scene scene;
    paper_picture truth, got;
    picture_scene_make(&scene, number);
    truth_picture(&truth, &scene);
    for (size_t i = 0; i < COUNT(stores); i++) {
        model_picture(&got, &model_reference, &scene, &stores[i]);
        error_take(&into->stored[i][number], &got, &truth);
    }
    for (size_t i = 0; i < COUNT(ways); i++) {
        ways[i].by(&got, &scene);
        error_take(&into->rendered[i][number], &got, &truth);
    }
    paper_picture_free(&truth);
    picture_scene_free(&scene);
}

void part_storage(const char *folder)
{
    static found all;
    table t;
    for (unsigned number = 0; number < picture_scenes; number++) {
        add_scene(&all, number);
    }
    printf("### 2.9 Storage that others use\n\n"
           "RMS in levels against double precision of real voxels and points. Storage alone, all "
           "arithmetic\nexact (boxes and the head are made of 16 bits, which RGBA16 keeps):\n\n");
    table_begin(&t, folder, "pictures_storage", columns);
    for (size_t i = 0; i < COUNT(stores); i++) {
        add_all(&t, stores[i].name, voxel_bytes(&stores[i]), all.stored[i]);
    }
    table_end(&t);
    printf("With the arithmetic that goes with it: the library; 15 bits throughout, rounded as "
           "VTK's\nfixed-point mapper rounds, which interpolates RGBA separately (there of 8 bits, "
           "here of 15) and ends\nrays at 1/128; and halves, where each blend is rounded to a half "
           "float too.\n\n");
    table_begin(&t, folder, "pictures_arithmetic", columns);
    for (size_t i = 0; i < COUNT(ways); i++) {
        add_all(&t, ways[i].name, ways[i].bytes, all.rendered[i]);
    }
    table_end(&t);
}
