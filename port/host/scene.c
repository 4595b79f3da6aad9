/*
 * scene.c - the library's scene from settings.
 */
#include "scene.h"
#include "error.h"

#include <math.h>

#define FULL_TURN 4294967296.0
#define Q30       1073741824.0
/* Of qv_scene.level. */
#define LEVEL_ONE 256

static double world_diagonal(const qv_volume *volume)
{
    double sum = 0;
    for (unsigned a = 0; a < 3; a++) {
        double side = volume->size[a] * (double)volume->spacing[a] / QV_ONE_Q16;
        sum += side * side;
    }
    return sqrt(sum);
}

/* At zoom 1 the smaller side of the frame spans the diagonal of the box. */
static uint32_t pitch(const qv_volume *volume, const struct settings *settings)
{
    double side = fmin(settings->size[0], settings->size[1]);
    double units = world_diagonal(volume) / (side * settings->zoom);
    return (uint32_t)lround(fmin(units * QV_ONE_Q16, INT32_MAX));
}

double scene_depth(const uint16_t size[3], const uint32_t spacing[3],
                   const struct settings *settings)
{
    int32_t rotation[3][3];
    double depth = 0;
    settings_rotation(rotation, settings);
    for (unsigned a = 0; a < 3; a++) {
        double forward = fabs((double)rotation[2][a]) / Q30;
        depth += forward * size[a] * spacing[a] / QV_ONE_Q16;
    }
    return depth;
}

uint32_t scene_step(const uint16_t size[3], const uint32_t spacing[3],
                    const struct settings *settings)
{
    uint32_t slices = settings->slices.count;
    double step = settings->step;
    if (slices != 0) {
        step = scene_depth(size, spacing, settings) / slices;
        if (step < STEP_LEAST || step > STEP_MOST) {
            usage_error("--slices", "%u of them are %g apart, which is not %g to %d", slices, step,
                        STEP_LEAST, STEP_MOST);
        }
    }
    return (uint32_t)lround(step * QV_ONE_Q16);
}

/* So many slices lie evenly about the box's centre, where the grid of samples has its 0: an
   even number of them between its places. */
static uint16_t scene_phase(const struct settings *settings)
{
    double phase = settings->phase;
    if (settings->slices.count != 0) {
        phase = settings->slices.count % 2 == 0 ? 0.5 : 0;
    }
    return (uint16_t)lround(fmin(phase * 65536, 65535));
}

void view_create(struct view *view, const qv_volume *volume, const struct settings *settings)
{
    for (unsigned i = 0; i < 3; i++)
        view->angles[i] = binary_angle(settings->angles[i]);
    settings_rotation(view->view.rotation, settings);
    view->view.pitch = pitch(volume, settings);
    view->view.step = scene_step(volume->size, volume->spacing, settings);
    view->view.width = (uint16_t)settings->size[0];
    view->view.height = (uint16_t)settings->size[1];
    view->field_of_view = (qv_angle)llround(settings->perspective / 360 * FULL_TURN);
}

/* The library knows the ranges; the message names what leads out of them. */
static void set_camera(qv_scene *scene, const struct view *view)
{
    qv_status status =
        view->field_of_view == 0
            ? qv_orthographic(&scene->camera, &scene->volume, &view->view)
            : qv_perspective(&scene->camera, &scene->volume, &view->view, view->field_of_view);
    if (status < 0) {
        usage_error("view", "%s; change --zoom, --size, --step or --perspective",
                    qv_status_text(status));
    }
}

/* The library would refuse a level beyond the last as well, but not name the option. */
static void set_level(qv_scene *scene, const struct view *view, const struct model *model,
                      const struct settings *settings)
{
    double most = scene->pyramid->levels;
    if (settings->level_auto) {
        check_status(qv_detail(scene, &view->view), model, "levels");
    } else if (settings->level > most) {
        usage_error("--level", "%g is beyond the last level, %g", settings->level, most);
    } else {
        scene->level = (uint16_t)lround(settings->level * LEVEL_ONE);
    }
}

/* Errors that an option leads to name it. */
static void check_scene(const qv_scene *scene, const struct model *model)
{
    qv_context context;
    qv_status status = qv_init(&context, scene);
    if (status == QV_ERROR_CAMERA || status == QV_ERROR_STEP) {
        usage_error("view", "%s; change --zoom, --size, --step or --perspective",
                    qv_status_text(status));
    }
    if (status == QV_ERROR_PAGES) {
        usage_error("--cache", "%u pages are fewer than a sample may need at a time",
                    scene->volume.pages->count);
    }
    if (status == QV_ERROR_UNIT ||
        (status == QV_ERROR_EXTINCTION && !storage_holds_extinction(model->storage))) {
        usage_error("--unit-distance", "%s", qv_status_text(status));
    }
    if (status == QV_ERROR_EXTINCTION) {
        usage_error("--extinction", "%s", qv_status_text(status));
    }
    check_status(status, model, "scene");
}

void scene_create(qv_scene *scene, struct view *view, const struct model *model,
                  const struct settings *settings)
{
    view_create(view, &scene->volume, settings);
    set_camera(scene, view);
    scene->phase = scene_phase(settings);
    scene->termination = settings->termination < 0
                             ? QV_TERMINATION_DEFAULT
                             : (uint16_t)lround(settings->termination * 65535);
    for (unsigned c = 0; c < 4; c++) {
        scene->background[c] = settings->background[c];
    }
    if (settings->level_given) {
        set_level(scene, view, model, settings);
    }
    check_scene(scene, model);
}
