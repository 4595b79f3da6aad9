/*
 * report_export.c - the report of classify and pyramid.
 */
#include "report_export.h"
#include "report_model.h"
#include "settings_slices.h"

#include <stdio.h>

#define TEXT_BYTES 128

static const char *byte_order(const struct export *export)
{
    if (export->is_array) {
        return "the compiler's";
    }
    return export->settings->big_endian ? "big" : "little";
}

static uint32_t table_bytes(const struct settings *settings)
{
    qv_dither dither = {0};
    settings_alpha(&dither, settings);
    return qv_dither_table_bytes(dither.period, (uint8_t)settings->dither_table);
}

/* Voxels and levels are one file, or an array each. */
static void report_file(struct json *json, const struct export *export)
{
    uint64_t bytes = export->volume->voxels_bytes;
    if (export->levels != NULL) {
        bytes += export->levels->pyramid.bytes;
    }
    json_object(json, "output");
    json_text(json, "file", export->settings->output);
    json_text(json, "kind", export->is_array ? "C arrays" : "raw");
    json_unsigned(json, "bytes", bytes);
    json_integer(json, "palette_bytes", export->model->palette_bytes);
    json_unsigned(json, "dither_table_bytes", table_bytes(export->settings));
    json_text(json, "byte_order", byte_order(export));
    json_close(json);
}

static void option(struct json *json, const char *name, const char *value)
{
    json_text(json, NULL, name);
    json_text(json, NULL, value);
}

static void decimal_option(struct json *json, const char *name, uint32_t q16)
{
    char text[DECIMAL_BYTES];
    print_decimal(text, (double)q16 / QV_ONE_Q16);
    option(json, name, text);
}

static void report_type(struct json *json, const struct export *export)
{
    const struct model *model = export->model;
    const char *order = export->settings->big_endian ? "be" : "le";
    bool indexed = storage_is_indexed(model->storage);
    char text[TEXT_BYTES];
    snprintf(text, sizeof text, "%s%s", storage_name(model->storage),
             !indexed && storage_channel_bytes(model->storage) == 2 ? order : "");
    option(json, "--type", text);
}

static void report_palette(struct json *json, const struct export *export)
{
    char text[FILENAME_MAX + sizeof ".palette"];
    snprintf(text, sizeof text, "%s.palette", export->settings->output);
    option(json, "--palette", text);
    option(json, "--endian", export->settings->big_endian ? "big" : "little");
}

static void report_geometry(struct json *json, const struct export *export)
{
    const qv_volume *volume = export->volume;
    char text[TEXT_BYTES];
    char spacing[3][DECIMAL_BYTES];
    for (unsigned a = 0; a < 3; a++) {
        print_decimal(spacing[a], volume->spacing[a] * export->model->world_unit / QV_ONE_Q16);
    }
    snprintf(text, sizeof text, "%ux%ux%u", volume->size[0], volume->size[1], volume->size[2]);
    option(json, "--dims", text);
    snprintf(text, sizeof text, "%sx%sx%s", spacing[0], spacing[1], spacing[2]);
    option(json, "--spacing", text);
}

/* With these options qvol reads the raw file; arrays need none. */
static void report_reading(struct json *json, const struct export *export)
{
    json_array(json, "read");
    report_geometry(json, export);
    report_type(json, export);
    if (export->model->palette != NULL) {
        report_palette(json, export);
    }
    if (export->volume->unit_distance != 0) {
        decimal_option(json, "--unit-distance", export->volume->unit_distance);
    }
    if (export->volume->extinction != 0) {
        decimal_option(json, "--extinction", export->volume->extinction);
    }
    json_close(json);
}

void report_export(output *out, const struct export *export)
{
    struct json json;
    uint64_t before = export->is_array ? 0 : export->volume->voxels_bytes;
    json_begin(&json, out);
    report_model(&json, export->model);
    report_volume(&json, export->volume, export->model, 0);
    if (export->levels != NULL) {
        report_levels(&json, export->levels, export->volume, export->model, before);
    }
    report_file(&json, export);
    if (!export->is_array) {
        report_reading(&json, export);
    }
    json_end(&json);
}
