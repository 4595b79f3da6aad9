/*
 * splat_scene.c - a scene of splats.
 */
#include "splat_scene.h"
#include "error.h"
#include "lighting.h"
#include "settings_freevoxel.h"

#include <string.h>

/* Of one level alone, or of all from that one on. */
static void set_levels(qv_splat_scene *scene, const struct freevoxel_file *file,
                       const struct settings *settings)
{
    const struct splat_settings *s = &settings->splat;
    unsigned most = file->header.coarser;
    if (s->level > most) {
        usage_error("--level", "%u, %s has %u", s->level, file->name, most);
    }
    if (s->levels && s->level == most) {
        usage_error("--levels", "%s has no levels above %u", file->name, most);
    }
    scene->level = (uint8_t)s->level;
    scene->coarsest = (uint8_t)(s->levels ? most : s->level);
    scene->detail = settings_detail(settings);
}

/* The bytes of the voxel that an eye lies in. */
static void set_inside(qv_splat_scene *scene, const struct freevoxel_file *file)
{
    uint16_t position[3];
    if (qv_splat_eye(position, scene)) {
        qv_attenuation attenuation;
        freevoxel_file_attenuation(&attenuation, file, 0);
        scene->inside = qv_attenuation_at(&attenuation, position);
    }
}

/* What an option leads to names it; else it is the file. */
static void check_splats(qv_status status, const struct freevoxel_file *file)
{
    switch (status) {
    case QV_OK:
        return;
    case QV_ERROR_VIEW:
        usage_error("view", "%s; change --zoom, --size or --perspective", qv_status_text(status));
    case QV_ERROR_INSIDE:
        usage_error("view", "%s; move it by --zoom, --perspective or angles",
                    qv_status_text(status));
    case QV_ERROR_DIRECTION:
        data_error(file->name, "directions",
                   "one that the view or a light needs is missing; --interpolation nearest takes "
                   "what there is");
    default:
        data_error(file->name, "scene", "%s", qv_status_text(status));
    }
}

void splat_scene_create(qv_splats *splats, struct view *view, const struct freevoxel_file *file,
                        const struct settings *settings)
{
    const qv_volume *volume = &file->header.volume;
    const struct splat_settings *s = &settings->splat;
    bool stored = storage_holds_extinction((qv_storage)volume->storage);
    qv_splat_scene scene;
    memset(&scene, 0, sizeof scene);
    view_create(view, volume, settings);
    scene.splatting = s->splatting == SPLATTING_OVER ? &qv_splatting_over : &qv_splatting_added;
    scene.kernel = s->kernel == KERNEL_LINEAR ? &qv_kernel_linear : &qv_kernel_quadratic;
    scene.domain = stored ? &qv_domain_stored : &qv_domain_extinction;
    scene.directions = file->header.directions;
    scene.field_of_view = view->field_of_view;
    scene.interpolation = (uint8_t)s->interpolation;
    scene.view = view->view;
    scene.volume = *volume;
    memcpy(scene.background, settings->background, sizeof scene.background);
    set_levels(&scene, file, settings);
    lighting_create(&scene.lighting, settings);
    set_inside(&scene, file);
    check_splats(qv_splat_init(splats, &scene), file);
}
