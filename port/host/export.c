/*
 * export.c - raw files and C arrays.
 */
#include "export.h"
#include "error.h"
#include "report_export.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SWAP_BYTES 65536

void export_check_settings(const struct settings *settings)
{
    if (settings->output == NULL) {
        usage_error("--output", "is missing");
    }
    if (settings->json != NULL && strcmp(settings->json, settings->output) == 0) {
        usage_error("--json", "report and voxels cannot both go to '%s'", settings->json);
    }
}

void export_check_model(const struct model *model, const struct settings *settings)
{
    if (model->palette != NULL && is_standard_stream(settings->output)) {
        usage_error("--output", "the palette of indexed8 needs a file beside the voxels");
    }
}

void export_begin(struct export *export, const struct model *model, const qv_volume *volume,
                  const struct levels *levels, const struct settings *settings)
{
    bool wide = storage_channel_bytes(model->storage) == 2;
    memset(export, 0, sizeof *export);
    export->settings = settings;
    export->model = model;
    export->volume = volume;
    export->levels = levels;
    export->is_array = settings_want_array(settings);
    export->swap = wide && settings->big_endian != machine_is_big_endian();
    output_open(&export->out, settings->output);
    if (export->is_array) {
        flash_array_begin(&export->array, &export->out, model, volume, levels, settings);
    }
}

/* Whole words; what is written may be in use elsewhere. */
static void write_swapped(output *out, const uint8_t *bytes, size_t count)
{
    static uint8_t buffer[SWAP_BYTES];
    while (count > 0) {
        size_t part = count < sizeof buffer ? count : sizeof buffer;
        memcpy(buffer, bytes, part);
        swap_words(buffer, part, 2);
        output_write(out, buffer, part);
        bytes += part;
        count -= part;
    }
}

/* Entries are R,G,B,A or R,G,B,T. */
static void write_entries(const struct export *export, output *out, const void *entries,
                          size_t bytes)
{
    if (export->swap) {
        write_swapped(out, entries, bytes);
    } else {
        output_write(out, entries, bytes);
    }
}

void export_voxels(struct export *export, const void *voxels, size_t bytes)
{
    if (export->is_array) {
        flash_array_voxels(&export->array, voxels, bytes);
    } else if (storage_is_indexed(export->model->storage)) {
        output_write(&export->out, voxels, bytes);
    } else {
        write_entries(export, &export->out, voxels, bytes);
    }
}

/* OUT.palette, beside the voxels. */
static void write_palette(const struct export *export)
{
    const struct model *model = export->model;
    const char *beside = export->settings->output;
    output out;
    size_t bytes = strlen(beside) + sizeof ".palette";
    char *name = allocate(bytes, beside, NULL);
    snprintf(name, bytes, "%s.palette", beside);
    output_open(&out, name);
    write_entries(export, &out, model->palette, model->palette_bytes);
    output_commit(&out);
    free(name);
}

static void write_rest(struct export *export)
{
    if (export->is_array) {
        flash_array_end(&export->array);
        return;
    }
    if (export->levels != NULL) {
        const qv_pyramid *pyramid = &export->levels->pyramid;
        write_entries(export, &export->out, pyramid->voxels, (size_t)pyramid->bytes);
    }
    if (export->model->palette != NULL) {
        write_palette(export);
    }
}

void export_end(struct export *export)
{
    const char *json = export->settings->json;
    write_rest(export);
    if (json != NULL) {
        output report;
        output_open(&report, json);
        report_export(&report, export);
        output_commit(&report);
    }
    output_commit(&export->out);
}
