/*
 * part_budget.c - the error of a picture split over the stages: each alone in a pipeline that is
 * exact, and each left out of the library's.
 */
#include "pictures.h"

#include <math.h>

/* A pipeline, what it stores voxels in, and whether its pixels are packed to 8 bits. */
typedef struct pipeline {
    model of;
    store by;
    bool packed;
} pipeline;

/* Copies one stage of a pipeline to another. */
typedef void copy_stage(pipeline *to, const pipeline *from);

static void copy_storage(pipeline *to, const pipeline *from)
{
    to->by = from->by;
}

static void copy_position(pipeline *to, const pipeline *from)
{
    to->of.position = from->of.position;
}

static void copy_weights(pipeline *to, const pipeline *from)
{
    to->of.weights = from->of.weights;
}

static void copy_terms(pipeline *to, const pipeline *from)
{
    to->of.terms = from->of.terms;
}

static void copy_opacity(pipeline *to, const pipeline *from)
{
    to->of.opacity = from->of.opacity;
}

static void copy_transmittance(pipeline *to, const pipeline *from)
{
    to->of.transmittance = from->of.transmittance;
}

static void copy_light(pipeline *to, const pipeline *from)
{
    to->of.light = from->of.light;
}

static void copy_read_out(pipeline *to, const pipeline *from)
{
    to->of.read_out = from->of.read_out;
}

static void copy_packing(pipeline *to, const pipeline *from)
{
    to->packed = from->packed;
}

typedef struct budget_stage {
    const char *name;
    copy_stage *copy;
} budget_stage;

static const budget_stage stages[] = {
    {"storage", copy_storage},
    {"position, 8 bits", copy_position},
    {"weights, 16 bits", copy_weights},
    {"terms of sums, cut", copy_terms},
    {"opacity to 32 bits, cut", copy_opacity},
    {"transmittance, 31 bits", copy_transmittance},
    {"light, 31 bits", copy_light},
    {"read-out, 8.16 bits", copy_read_out},
    {"packing to 8 bits", copy_packing},
};

/* ---- Pictures ------------------------------------------------------------------------- */

static void pack(paper_picture *picture)
{
    for (size_t i = 0; i < (size_t)picture->width * picture->height; i++) {
        for (int channel = 0; channel < 4; channel++) {
            picture->rgba[i][channel] = ref_level(picture->rgba[i][channel], 255) / 255.0;
        }
    }
}

static picture_error error_of(const pipeline *of, const picture_scene *scene,
                              const paper_picture *truth)
{
    picture_error found = {0};
    paper_picture got;
    model_picture(&got, &of->of, scene, &of->by);
    if (of->packed) {
        pack(&got);
    }
    error_take(&found, &got, truth);
    return found;
}

/* ---- The table ------------------------------------------------------------------------- */

static void add_row(table *t, const char *scene, const char *storage, const char *stage,
                    const picture_error *alone, const picture_error *without,
                    const picture_error *all)
{
    table_text(t, scene);
    table_text(t, storage);
    table_text(t, stage);
    table_number(t, "%.2g", error_rms(alone));
    table_number(t, "%.2g", alone->worst);
    table_number(t, "%.2g", alone->sum / alone->channels);
    table_number(t, "%.3f", 100 * alone->squares / all->squares);
    table_number(t, "%.4g", error_rms(without));
}

/* A stage alone: of storage, against real voxels; of any other, against the same stored ones. */
static picture_error error_alone(const budget_stage *stage, const pipeline *ours,
                                 const picture_scene *scene, const paper_picture *truth)
{
    pipeline one = {model_reference, ours->by, false};
    paper_picture exact;
    if (stage->copy == copy_storage) {
        return error_of(&one, scene, truth);
    }
    model_picture(&exact, &one.of, scene, &one.by);
    stage->copy(&one, ours);
    const picture_error found = error_of(&one, scene, &exact);
    paper_picture_free(&exact);
    return found;
}

static picture_error error_without(const budget_stage *stage, const pipeline *ours,
                                   const picture_scene *scene, const paper_picture *truth)
{
    const pipeline exact = {model_reference, store_real, false};
    pipeline others = *ours;
    stage->copy(&others, &exact);
    return error_of(&others, scene, truth);
}

static void add_budget(table *t, unsigned number, unsigned bits)
{
    const char *storage = bits == 8 ? "RGBA8" : "RGBA16";
    const pipeline ours = {model_library, {storage, STORE_UNORM, bits, false}, true};
    picture_scene scene;
    paper_picture truth;
    picture_error sum = {0};
    picture_scene_make(&scene, number);
    truth_picture(&truth, &scene);
    const picture_error all = error_of(&ours, &scene, &truth);
    for (size_t i = 0; i < COUNT(stages); i++) {
        const picture_error alone = error_alone(&stages[i], &ours, &scene, &truth);
        const picture_error without = error_without(&stages[i], &ours, &scene, &truth);
        add_row(t, scene.name, storage, stages[i].name, &alone, &without, &all);
        sum.channels = alone.channels;
        sum.squares += alone.squares;
        sum.sum += alone.sum;
        sum.worst += alone.worst;
    }
    add_row(t, scene.name, storage, "the sum of these", &sum, &all, &all);
    add_row(t, scene.name, storage, "the library", &all, &all, &all);
    paper_picture_free(&truth);
    picture_scene_free(&scene);
}

void part_budget(const char *folder)
{
    static const unsigned numbers[] = {scene_head, scene_shells, scene_haze};
    table t;
    printf("### 2.6 Error budget\n\n"
           "Weighted sampling front to back, packed to rgba8888, against double precision of real "
           "voxels and\npoints. Alone: only this stage rounds, against a pipeline that is exact "
           "from storage on. Without: all\nbut this one. Shares are of squared errors: they add up "
           "to 100 %% where errors are independent.\n\n"
           "Plot: `pictures_budget.png`.\n\n");
    table_begin(&t, folder, "pictures_budget",
                "scene|storage|stage|alone: RMS|worst|bias|share of squares, %|without: RMS");
    for (size_t i = 0; i < COUNT(numbers); i++) {
        add_budget(&t, numbers[i], 16);
        add_budget(&t, numbers[i], 8);
    }
    table_end(&t);
}
