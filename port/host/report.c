/*
 * report.c - the resolved scene as JSON.
 */
#include "report.h"
#include "crc32.h"

#include <inttypes.h>
#include <stdio.h>

#define FIRST_SAMPLE_ORTHOGRAPHIC                                                                  \
    "every integer k of either sign for which p = origin + x*across + y*down + "                   \
    "(k + phase/65536)*along lies in the box, 0 <= p < size on every axis"
#define FIRST_SAMPLE_PERSPECTIVE                                                                   \
    "every integer k >= 0 for which p = origin + (k + phase/65536)*pace*v/|v| lies in the box, "   \
    "0 <= p < size on every axis; v = along + x*across + y*down"

static void triple(struct json *json, const char *key, int64_t x, int64_t y, int64_t z)
{
    const int64_t values[3] = {x, y, z};
    json_integers(json, key, values, 3);
}

static void vector(struct json *json, const char *key, const qv_coord v[3])
{
    triple(json, key, v[0], v[1], v[2]);
}

void report_input(struct json *json, const struct scan *scan)
{
    char orientation[4];
    scan_orientation_text(scan, orientation);
    json_object(json, "input");
    json_text(json, "file", scan->file);
    json_text(json, "format", scan->format);
    triple(json, "size", scan->size[0], scan->size[1], scan->size[2]);
    json_text(json, "type", choice_name(element_names, (int)scan->type));
    json_unsigned(json, "bytes", scan->bytes);
    json_decimals(json, "spacing", scan->spacing, 3);
    json_text(json, "orientation", scan->oriented ? orientation : "unknown");
    json_decimal(json, "slope", scan->slope);
    json_decimal(json, "offset", scan->offset);
    json_close(json);
}

static const char *scalar_type_name(uint8_t type)
{
    static const char *const names[] = {"", "u8", "u16", "s16"};
    return names[type];
}

/* How stored values became the scalars, in world order, that are classified. */
static void report_scalars(struct json *json, const struct model *model)
{
    const struct scalar_view *view = &model->view;
    const qv_scalars *scalars = &view->scalars;
    const uint8_t *axis = model->scan.turn.axis;
    const bool *reversed = model->scan.turn.reversed;
    json_object(json, "scalars");
    json_text(json, "type", scalar_type_name(scalars->type));
    triple(json, "size", scalars->size[0], scalars->size[1], scalars->size[2]);
    triple(json, "stored_axis", axis[0], axis[1], axis[2]);
    triple(json, "reversed", reversed[0], reversed[1], reversed[2]);
    json_decimals(json, "window", view->window, 2);
    json_integer(json, "low", view->low);
    json_integer(json, "high", view->high);
    json_text(json, "conversion",
              view->converted ? "round(65535 * (slope * stored + offset - window[0]) / "
                                "(window[1] - window[0])), clamped to 0 .. 65535"
                              : "none");
    json_text(json, "index", "round(255 * (scalar - low) / (high - low)), clamped to 0 .. 255");
    json_close(json);
}

static void report_shading(struct json *json, const struct model *model)
{
    const qv_shading *shading = &model->shading;
    if (!model->shaded) {
        json_null(json, "shading");
        return;
    }
    json_object(json, "shading");
    triple(json, "light", shading->light[0], shading->light[1], shading->light[2]);
    triple(json, "viewer", shading->viewer[0], shading->viewer[1], shading->viewer[2]);
    json_integer(json, "ambient", shading->ambient);
    json_integer(json, "diffuse", shading->diffuse);
    json_integer(json, "specular", shading->specular);
    json_integer(json, "gloss", shading->gloss);
    json_integer(json, "least_gradient", shading->least_gradient);
    json_close(json);
}

/* One line for each of the 256 entries. */
static void report_table(struct json *json, const uint16_t *words, const uint8_t *bytes)
{
    json_array(json, "table");
    for (unsigned i = 0; i < QV_PALETTE_ENTRIES; i++) {
        int64_t entry[4];
        for (unsigned c = 0; c < 4; c++) {
            entry[c] = words != NULL ? words[4 * i + c] : bytes[4 * i + c];
        }
        json_integers(json, NULL, entry, 4);
    }
    json_close(json);
}

static void report_transfer(struct json *json, const struct model *model)
{
    bool wide = model->palette_bytes != QV_PALETTE8_BYTES;
    json_object(json, "transfer");
    if (!model->classified_before) {
        json_text(json, "name", model->transfer.name);
    } else if (model->palette != NULL) {
        json_text(json, "name", "palette");
    } else {
        json_null(json, "name");
    }
    if (model->palette != NULL) { /* what the samples read */
        json_integer(json, "bits", wide ? 16 : 8);
        report_table(json, wide ? model->palette : NULL, wide ? NULL : model->palette);
    } else if (!model->classified_before) {
        json_integer(json, "bits", 16);
        report_table(json, &model->table.rgba[0][0], NULL);
    }
    json_close(json);
}

/* From the file to classified voxels. */
static void report_model(struct json *json, const struct model *model)
{
    report_input(json, &model->scan);
    if (!model->classified_before) {
        report_scalars(json, model);
        report_shading(json, model);
    }
    report_transfer(json, model);
}

/* Unit distance 0 is the step: opacities hold for one sample. */
static void report_volume(struct json *json, const qv_scene *scene, const struct model *model)
{
    const qv_volume *volume = &scene->volume;
    uint32_t unit = volume->unit_distance != 0 ? volume->unit_distance : scene->camera.step;
    json_object(json, "volume");
    json_text(json, "storage", storage_name(model->storage));
    json_integer(json, "palette_bytes", volume->palette_bytes);
    triple(json, "size", volume->size[0], volume->size[1], volume->size[2]);
    triple(json, "stride", volume->stride[0], volume->stride[1], volume->stride[2]);
    triple(json, "spacing_q16", volume->spacing[0], volume->spacing[1], volume->spacing[2]);
    json_integer(json, "unit_distance_q16", unit);
    json_decimal(json, "world_unit", model->world_unit);
    json_unsigned(json, "bytes", volume->voxels_bytes);
    json_close(json);
}

static void report_camera(struct json *json, const qv_scene *scene, const struct view *view)
{
    const qv_camera *camera = &scene->camera;
    bool perspective = view->field_of_view != 0;
    json_object(json, "camera");
    json_text(json, "kind", perspective ? "perspective" : "orthographic");
    json_text(json, "fraction", "voxels with 32 fraction bits");
    vector(json, "origin", camera->origin);
    vector(json, "across", camera->across);
    vector(json, "down", camera->down);
    vector(json, "along", camera->along);
    vector(json, "pace", camera->pace);
    json_integer(json, "step_q16", camera->step);
    json_object(json, "view");
    for (unsigned row = 0; row < 3; row++) {
        static const char *const names[3] = {"right_q30", "down_q30", "forward_q30"};
        const int32_t *r = view->view.rotation[row];
        triple(json, names[row], r[0], r[1], r[2]);
    }
    json_integer(json, "pitch_q16", view->view.pitch);
    json_integer(json, "field_of_view", view->field_of_view);
    json_close(json);
    json_close(json);
}

static void report_sampling(struct json *json, const qv_scene *scene, const struct view *view,
                            const struct settings *settings)
{
    json_object(json, "sampling");
    json_text(json, "mode", choice_name(sampling_names, settings->sampling));
    json_text(json, "order", settings->back_to_front ? "back-to-front" : "front-to-back");
    json_integer(json, "phase_q16", scene->phase);
    json_text(json, "samples",
              view->field_of_view != 0 ? FIRST_SAMPLE_PERSPECTIVE : FIRST_SAMPLE_ORTHOGRAPHIC);
    json_text(json, "position",
              "p rounded to 1/256 voxel, ties upwards; values clamped at centres");
    json_integer(json, "termination", settings->back_to_front ? 0 : scene->termination);
    json_close(json);
}

static void report_frame(struct json *json, const qv_scene *scene, const struct frame *frame)
{
    const uint8_t *b = scene->background;
    const int64_t background[4] = {b[0], b[1], b[2], b[3]};
    char checksum[16];
    snprintf(checksum, sizeof checksum, "%08" PRIx32,
             crc32_update(0, frame->bytes, frame->byte_count));
    json_object(json, "frame");
    json_integer(json, "width", frame->width);
    json_integer(json, "height", frame->height);
    json_text(json, "format", frame->format->name);
    json_unsigned(json, "row_bytes", frame->row_bytes);
    json_unsigned(json, "bytes", frame->byte_count);
    json_integers(json, "background", background, 4);
    json_text(json, "crc32", checksum);
    json_close(json);
}

static void report_statistics(struct json *json, const struct frame *frame)
{
    json_object(json, "statistics");
    json_unsigned(json, "rays", (uint64_t)frame->width * frame->height);
    json_unsigned(json, "samples", frame->samples);
    json_unsigned(json, "skipped", frame->skipped);
    json_unsigned(json, "terminated", frame->terminated);
    json_decimal(json, "seconds", frame->seconds);
    json_close(json);
}

void report_scene(output *out, const struct model *model, const qv_scene *scene,
                  const struct view *view, const struct frame *frame,
                  const struct settings *settings)
{
    struct json json;
    json_begin(&json, out);
    json_text(&json, "program", "qvol");
    json_text(&json, "version", qv_version());
    json_integer(&json, "specification", QV_SPECIFICATION);
    report_model(&json, model);
    if (model->mask != NULL) {
        json_object(&json, "mask");
        json_text(&json, "rule", "where its scalar is above 0, its voxel replaces the input's");
        report_model(&json, model->mask);
        json_close(&json);
    }
    report_volume(&json, scene, model);
    report_camera(&json, scene, view);
    report_sampling(&json, scene, view, settings);
    report_frame(&json, scene, frame);
    report_statistics(&json, frame);
    json_end(&json);
}
