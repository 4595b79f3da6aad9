/*
 * command_render.c - from a volume to a picture.
 */
#include "commands.h"
#include "error.h"
#include "frame.h"
#include "report.h"
#include "sampling.h"
#include "scene.h"

#include <stdlib.h>
#include <string.h>

/* The writer of pictures, or null for the device's own bytes. */
static picture_writer *choose_writer(const struct settings *settings)
{
    const char *name = settings->output;
    picture_writer *writer = picture_writer_by_name(name);
    switch (settings->container) {
    case CONTAINER_PNG:
        return picture_writer_png();
    case CONTAINER_PAM:
        return write_pam;
    case CONTAINER_RAW:
        return NULL;
    default:
        break;
    }
    if (writer == NULL && is_standard_stream(name)) {
        return write_pam;
    }
    if (writer == NULL && !has_ending(name, ".raw") && !has_ending(name, ".bin")) {
        usage_error("--output", "'%s' does not end in .png, .pam, .raw or .bin; give --as", name);
    }
    return writer;
}

/* What can be refused before anything is read. */
static void check_outputs(const struct settings *settings)
{
    if (settings->output == NULL) {
        usage_error("--output", "is missing");
    }
    if (settings->json != NULL && strcmp(settings->json, settings->output) == 0) {
        usage_error("--json", "report and picture cannot both go to '%s'", settings->json);
    }
}

static void write_frame(output *out, const struct frame *frame, picture_writer *writer)
{
    struct picture picture;
    if (writer == NULL) {
        output_write(out, frame->bytes, frame->byte_count);
        return;
    }
    pixel_format_show(&picture, frame->format, frame->bytes, frame->width, frame->height);
    writer(out, &picture);
    free(picture.pixels);
}

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

/* The picture gets its name last: where it is, its report is too. */
int command_render(const struct settings *settings)
{
    picture_writer *writer;
    struct model model;
    struct frame frame;
    struct view view;
    struct levels levels = {0};
    struct slicing slicing, *by_slices = NULL;
    qv_scene scene = {0};
    output picture, report;
    check_outputs(settings);
    writer = choose_writer(settings);
    frame_create(&frame, settings);
    model_read(&model, settings, settings->operands[0], QV_STORAGE_RGBA16);
    scene.sampling = sampling_choose(settings, model.storage);
    convert_opacities(&model, settings);
    model_volume(&scene.volume, &model, settings);
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
    write_frame(&picture, &frame, writer);
    if (settings->json != NULL) {
        output_open(&report, settings->json);
        report_scene(&report, &model, &scene, &levels, &view, by_slices, &frame, settings);
        output_commit(&report);
    }
    output_commit(&picture);
    frame_free(&frame);
    levels_free(&levels);
    model_free(&model);
    return EXIT_SUCCESS;
}
