/*
 * part_model.c - whether the model may stand for the library: equal bits at the library's
 * settings, and the reference where nothing is rounded.
 */
#include "pictures.h"

#include <math.h>

typedef struct check {
    our_mode of;
    store by;
    bool separate;
} check;

static const check checks[] = {
    {{"weighted, RGBA16", QV_STORAGE_RGBA16, &qv_weighted_rgba16, REF_WEIGHTED},
     {"RGBA16", STORE_UNORM, 16, false},
     false},
    {{"weighted, RGBA8", QV_STORAGE_RGBA8, &qv_weighted_rgba8, REF_WEIGHTED},
     {"RGBA8", STORE_UNORM, 8, false},
     false},
    {{"separate, RGBA16", QV_STORAGE_RGBA16, &qv_separate_rgba16, REF_SEPARATE},
     {"RGBA16", STORE_UNORM, 16, false},
     true},
    {{"separate, RGBA8", QV_STORAGE_RGBA8, &qv_separate_rgba8, REF_SEPARATE},
     {"RGBA8", STORE_UNORM, 8, false},
     true},
};

/* Of doubles that are added up in another order. */
static const double same = 1e-12;

typedef struct agreement {
    double channels, unequal; /* of the library */
    double farthest;          /* from the reference, 1 being full scale */
} agreement;

static void compare(agreement *into, const paper_picture *got, const paper_picture *expected)
{
    for (size_t i = 0; i < (size_t)got->width * got->height; i++) {
        for (int channel = 0; channel < 4; channel++) {
            const double off = got->rgba[i][channel] - expected->rgba[i][channel];
            into->channels++;
            into->unequal += off != 0;
            into->farthest = fmax(into->farthest, fabs(off));
        }
    }
}

static void compare_with_library(agreement *into, const picture_scene *scene, const check *c)
{
    model as = model_library;
    paper_picture expected, got;
    as.separate = c->separate;
    ours_picture(&expected, scene, &c->of);
    model_picture(&got, &as, scene, &c->by);
    compare(into, &got, &expected);
    paper_picture_free(&expected);
    paper_picture_free(&got);
}

/* At the library's points: the reference rounds them. */
static void compare_with_reference(agreement *into, const picture_scene *scene, const check *c)
{
    model as = model_reference;
    paper_picture expected, got, thin;
    ours_volume volume;
    as.position = model_library.position;
    as.separate = c->separate;
    ours_make(&volume, scene, &c->of);
    paper_render_reference(&expected, &volume.scene, c->of.mode, scene->edge, scene->edge);
    model_picture(&got, &as, scene, &c->by);
    paper_thin_out(&thin, &got);
    compare(into, &thin, &expected);
    ours_free(&volume);
    paper_picture_free(&expected);
    paper_picture_free(&got);
    paper_picture_free(&thin);
}

void part_model(const char *folder)
{
    table t;
    bool equal = true;
    printf("### 2.1 The model\n\n"
           "Bits that the library fixes are varied in a model of its pipeline. With the library's\n"
           "bits the model's pictures are the library's; with no rounding, the reference's.\n\n");
    table_begin(&t, folder, "pictures_model",
                "mode|channels|unequal to the library|farthest from the reference");
    for (size_t i = 0; i < COUNT(checks); i++) {
        agreement library = {0}, reference = {0};
        for (unsigned number = 0; number < picture_scenes; number++) {
            picture_scene scene;
            picture_scene_make(&scene, number);
            compare_with_library(&library, &scene, &checks[i]);
            compare_with_reference(&reference, &scene, &checks[i]);
            picture_scene_free(&scene);
        }
        table_text(&t, checks[i].of.name);
        table_number(&t, "%.0f", library.channels);
        table_number(&t, "%.0f", library.unequal);
        table_text(&t, reference.farthest < same ? "below 1e-12" : "1e-12 or more");
        equal = equal && library.unequal == 0 && reference.farthest < same;
    }
    table_end(&t);
    goal(equal, "the model is the library and the reference");
    goals_end();
}
