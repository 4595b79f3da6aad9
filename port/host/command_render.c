/*
 * command_render.c - from a volume to a picture.
 */
#include "commands.h"
#include "error.h"
#include "frame_file.h"
#include "illuminate.h"
#include "paging.h"
#include "report.h"
#include "sampling.h"
#include "scene.h"

#include <stdlib.h>
#include <string.h>

/* Sampling that knows no lengths is given opacities for those that the number of slices makes. */
static void convert_opacities(struct model *model, const struct settings *settings)
{
    const qv_scalars *scalars = &model->classifier.scalars;
    if (settings->slices.count == 0 || sampling_by_length(settings, model->storage)) {
        return;
    }
    if (model->classified_before) {
        usage_error("--slices", "the opacities of %s stay; give --step, or another --sampling",
                    model->scan.file);
    }
    model_hold_steps(model, scene_step(scalars->size, scalars->spacing, settings));
}

/* Lit voxels are entries, whatever they were. */
static void light_voxels(qv_scene *scene, struct model *model, const struct settings *settings)
{
    qv_volume *volume = &scene->volume;
    if (settings->lighting.count == 0) {
        return;
    }
    illuminate(volume, model, scene_step(volume->size, volume->spacing, settings), settings);
    scene->sampling = sampling_choose(settings, model->storage);
}

/* The picture gets its name last: where it is, its report is too. */
int command_render(const struct settings *settings)
{
    picture_writer *writer;
    struct model model;
    struct frame frame;
    struct view view;
    struct levels levels = {0};
    struct slicing slicing, *by_slices = NULL;
    struct paging paging = {0};
    qv_scene scene = {0};
    output picture, report;
    writer = frame_file_writer(settings);
    frame_create(&frame, settings);
    model_read(&model, settings, settings->operands[0], QV_STORAGE_RGBA16);
    scene.sampling = sampling_choose(settings, model.storage);
    convert_opacities(&model, settings);
    model_volume(&scene.volume, &model, settings);
    light_voxels(&scene, &model, settings);
    if (settings->cache.pages != 0) {
        paging_create(&paging, &scene.volume, settings);
    }
    if (settings->level_given) {
        levels_create(&levels, &scene.volume, &model, settings);
        scene.pyramid = &levels.pyramid;
    }
    scene_create(&scene, &view, &model, settings);
    if (settings->slices.wanted) {
        by_slices = &slicing;
        slicing_create(by_slices, &scene, settings);
    }
    frame_render(&frame, &scene, by_slices, settings);
    output_open(&picture, settings->output);
    frame_file_write(&picture, &frame, writer);
    if (settings->json != NULL) {
        output_open(&report, settings->json);
        report_scene(&report, &model, &scene, &levels, &paging, &view, by_slices, &frame, settings);
        output_commit(&report);
    }
    output_commit(&picture);
    frame_free(&frame);
    levels_free(&levels);
    paging_free(&paging);
    model_free(&model);
    return EXIT_SUCCESS;
}
