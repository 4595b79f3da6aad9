/*
 * command_freevoxel.c - from a volume to a FreeVoxel file.
 */
#include "commands.h"
#include "error.h"
#include "freevoxel_build.h"
#include "report_freevoxel.h"

#include <stdlib.h>
#include <string.h>

/* What can be refused before anything is read. */
static void check_outputs(const struct settings *settings)
{
    if (settings->output == NULL) {
        usage_error("--output", "is missing");
    }
    if (is_standard_stream(settings->output)) {
        usage_error("--output", "a file that is mapped into memory cannot be standard output");
    }
    if (settings->json != NULL && strcmp(settings->json, settings->output) == 0) {
        usage_error("--json", "report and FreeVoxels cannot both go to '%s'", settings->json);
    }
}

/* Opacities that are to hold for a length and were given none hold for 1. */
static void set_unit_distance(struct model *model, const struct settings *settings)
{
    bool stored = storage_holds_extinction(model->storage) || settings->extinction_given;
    if (settings->freevoxel.uncorrected && stored) {
        usage_error("--uncorrected", "extinction holds for any length");
    }
    if (model->unit_distance == 0 && !stored && !settings->freevoxel.uncorrected) {
        model->unit_distance = QV_ONE_Q16;
    }
}

/* Levels of the input, or made here: a voxel of a level stands for the eight below it. */
static void create_levels(struct levels *levels, const qv_volume *volume, const struct model *model,
                          const struct settings *settings)
{
    struct settings own = *settings;
    if (own.filter == FILTER_BY_SAMPLING && model->scan.levels == NULL) {
        own.filter = FILTER_BOX2;
    }
    levels_create(levels, volume, model, &own);
}

/* As many levels as are asked for, or as the size has. */
static uint8_t coarser_levels(const qv_volume *volume, const struct settings *settings)
{
    const struct freevoxel_settings *f = &settings->freevoxel;
    unsigned most = qv_pyramid_levels(volume->size);
    if (f->levels_given && f->levels > most) {
        usage_error("--levels", "%u, the volume has %u", f->levels, most);
    }
    return (uint8_t)(f->levels_given ? f->levels : most);
}

static void make_header(struct freevoxel_header *header, const qv_volume *volume,
                        const struct settings *settings)
{
    const struct freevoxel_settings *f = &settings->freevoxel;
    memset(header, 0, sizeof *header);
    header->volume = *volume;
    header->directions = f->directions != 0 ? f->directions : QV_DIRECTIONS_ALL;
    header->order = (uint8_t)f->order;
    header->coarser = coarser_levels(volume, settings);
    if (header->coarser != 0) {
        int usual = f->uncorrected ? FREEVOXEL_GEOMETRIC : FREEVOXEL_REBUILT;
        header->hierarchy = (uint8_t)(f->hierarchy_given ? f->hierarchy : usual);
    }
    freevoxel_header_lay_out(header);
}

static void write_report(const struct freevoxel_header *header, const struct model *model,
                         const qv_volume *volume, const struct settings *settings)
{
    struct json json;
    output out;
    if (settings->json == NULL) {
        return;
    }
    output_open(&out, settings->json);
    json_begin(&json, &out);
    report_model(&json, model);
    report_volume(&json, volume, model, 0);
    report_freevoxels(&json, header);
    json_end(&json);
    output_commit(&out);
}

int command_freevoxel(const struct settings *settings)
{
    struct model model;
    struct levels levels = {0};
    struct freevoxel_header header;
    qv_volume volume;
    output out;
    check_outputs(settings);
    model_read(&model, settings, settings->operands[0], QV_STORAGE_INDEXED8);
    if (storage_is_associated(model.storage)) {
        usage_error("--storage", "colours of FreeVoxels are not weighted: no associated8");
    }
    set_unit_distance(&model, settings);
    model_volume(&volume, &model, settings);
    make_header(&header, &volume, settings);
    if (header.coarser != 0) {
        create_levels(&levels, &volume, &model, settings);
    }
    output_open(&out, settings->output);
    freevoxel_build(output_map(&out, header.total_bytes), &header, &volume, &levels, &model,
                    settings);
    write_report(&header, &model, &volume, settings);
    output_commit(&out);
    levels_free(&levels);
    model_free(&model);
    return EXIT_SUCCESS;
}
