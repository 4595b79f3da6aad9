/*
 * report.c - the resolved scene as JSON.
 */
#include "report.h"
#include "crc32.h"
#include "lighting.h"
#include "report_slices.h"
#include "sampling.h"

#include <inttypes.h>
#include <stdio.h>

#define SAMPLES_ORTHOGRAPHIC                                                                       \
    "every integer k of either sign for which p = origin + x*across + y*down + "                   \
    "(k + phase/65536)*along lies in the box, 0 <= p < size on every axis"
#define SAMPLES_PERSPECTIVE                                                                        \
    "every integer k >= 0 for which p = origin + (k + phase/65536)*pace*v/|v| lies in the box, "   \
    "0 <= p < size on every axis; v = along + x*across + y*down"
#define PIECES                                                                                     \
    "the places s = k + phase/65536 - 1/2, k an integer, cut the ray's way through the box, "      \
    "0 <= p < size on every axis, into pieces; each is sampled at its middle and taken for its "   \
    "length; "
#define PIECES_ORTHOGRAPHIC PIECES "p = origin + x*across + y*down + s*along"
#define PIECES_PERSPECTIVE  PIECES "p = origin + s*pace*v/|v|, s >= 0, v = along + x*across + y*down"

static void vector(struct json *json, const char *key, const qv_coord v[3])
{
    json_triple(json, key, v[0], v[1], v[2]);
}

void report_view(struct json *json, const struct view *view)
{
    const qv_angle *angles = view->angles;
    json_object(json, "view");
    json_triple(json, "angles_q32", angles[0], angles[1], angles[2]);
    for (unsigned row = 0; row < 3; row++) {
        static const char *const names[3] = {"right_q30", "down_q30", "forward_q30"};
        const int32_t *r = view->view.rotation[row];
        json_triple(json, names[row], r[0], r[1], r[2]);
    }
    json_integer(json, "pitch_q16", view->view.pitch);
    json_integer(json, "field_of_view", view->field_of_view);
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
    report_view(json, view);
    json_close(json);
}

/* Which places of a ray are sampled. */
static const char *sample_rule(const struct view *view, bool by_length)
{
    if (view->field_of_view != 0) {
        return by_length ? PIECES_PERSPECTIVE : SAMPLES_PERSPECTIVE;
    }
    return by_length ? PIECES_ORTHOGRAPHIC : SAMPLES_ORTHOGRAPHIC;
}

static void report_sampling(struct json *json, const qv_scene *scene, const struct view *view,
                            const struct model *model, const struct settings *settings)
{
    bool by_length = sampling_by_length(settings, model->storage);
    bool back_to_front = settings_back_to_front(settings);
    json_object(json, "sampling");
    json_text(json, "mode", choice_name(sampling_names, sampling_mode(settings, model->storage)));
    json_text(json, "order", back_to_front ? "back-to-front" : "front-to-back");
    json_boolean(json, "by_length", by_length);
    if (scene->pyramid != NULL) {
        json_integer(json, "level_q8", scene->level);
        json_integer(json, "level_distance", scene->level_distance);
        json_text(json, "pieces_of_levels",
                  settings->slices.wanted
                      ? "one step long on every level"
                      : "2^l steps long on level l, counted from the border before k = 0");
    } else {
        json_null(json, "level_q8");
    }
    json_integer(json, "phase_q16", scene->phase);
    json_text(json, "samples", sample_rule(view, by_length));
    json_text(json, "position",
              "p rounded to 1/256 voxel, ties upwards; values clamped at centres");
    json_integer(json, "termination", back_to_front ? 0 : scene->termination);
    json_close(json);
}

void report_frame(struct json *json, const uint8_t background[4], const struct frame *frame)
{
    const uint8_t *b = background;
    const int64_t colour[4] = {b[0], b[1], b[2], b[3]};
    char checksum[16];
    snprintf(checksum, sizeof checksum, "%08" PRIx32,
             crc32_update(0, frame->bytes, frame->byte_count));
    json_object(json, "frame");
    json_integer(json, "width", frame->width);
    json_integer(json, "height", frame->height);
    json_text(json, "format", frame->format->name);
    json_unsigned(json, "row_bytes", frame->row_bytes);
    json_unsigned(json, "bytes", frame->byte_count);
    json_integers(json, "background", colour, 4);
    json_text(json, "crc32", checksum);
    json_close(json);
}

static void report_statistics(struct json *json, const struct frame *frame, bool of_rays)
{
    json_object(json, "statistics");
    json_unsigned(json, "rays", (uint64_t)frame->width * frame->height);
    if (of_rays) {
        json_unsigned(json, "samples", frame->samples);
        json_unsigned(json, "skipped", frame->skipped);
        json_unsigned(json, "terminated", frame->terminated);
    }
    json_decimal(json, "seconds", frame->seconds);
    json_close(json);
}

void report_scene(output *out, const struct model *model, const qv_scene *scene,
                  const struct levels *levels, const struct paging *paging, const struct view *view,
                  const struct slicing *slicing, const struct frame *frame,
                  const struct settings *settings)
{
    struct json json;
    json_begin(&json, out);
    report_model(&json, model);
    report_volume(&json, &scene->volume, model, scene->camera.step);
    if (scene->pyramid != NULL) {
        report_levels(&json, levels, &scene->volume, model, 0);
    }
    report_camera(&json, scene, view);
    if (settings->lighting.count != 0) {
        qv_lighting lighting;
        lighting_create(&lighting, settings);
        report_lighting(&json, &lighting);
    }
    report_sampling(&json, scene, view, model, settings);
    if (slicing != NULL) {
        report_slices(&json, slicing, frame, settings);
    } else {
        json_null(&json, "slices");
    }
    report_frame(&json, scene->background, frame);
    if (scene->volume.pages != NULL) {
        report_pages(&json, paging);
    }
    report_statistics(&json, frame, slicing == NULL);
    json_end(&json);
}
