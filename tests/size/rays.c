/*
 * rays.c - a ray caster of one mode, by either camera.
 */
#include "size.h"

#define FIELD_OF_VIEW 0x20000000u /* 45 degrees */

qv_status use_orthographic(void)
{
    qv_scene scene;
    qv_view view;
    qv_status status = QV_OK;
    size_scene(&scene, &view, &qv_weighted_indexed8);
    SIZE_CALL(status, qv_orthographic(&scene.camera, &scene.volume, &view));
    return status == QV_OK ? size_render(&scene) : status;
}

qv_status use_perspective(void)
{
    qv_scene scene;
    qv_view view;
    qv_status status = QV_OK;
    size_scene(&scene, &view, &qv_weighted_indexed8);
    SIZE_CALL(status, qv_perspective(&scene.camera, &scene.volume, &view, FIELD_OF_VIEW));
    return status == QV_OK ? size_render(&scene) : status;
}

/* Renders what use_perspective prepared. */
qv_status use_progress(void)
{
    const qv_image image = {size_memory, SIZE_MEMORY, SIZE_WIDTH * 2, &qv_format_rgb565_le};
    qv_progress progress = {0};
    qv_status status = QV_MORE;
    while (status == QV_MORE) {
        status = QV_OK;
        SIZE_CALL(status,
                  qv_render_some(&image, &progress, &size_context, &size_frame, SIZE_WIDTH));
    }
    return status;
}

/* A volume's steps need not be its unit distance. */
qv_status use_extinction(void)
{
    qv_scene scene;
    qv_view view;
    qv_status status = QV_OK;
    size_scene(&scene, &view, &qv_extinction_indexed8);
    view.step = QV_ONE_Q16 / 2;
    SIZE_CALL(status, qv_perspective(&scene.camera, &scene.volume, &view, FIELD_OF_VIEW));
    return status == QV_OK ? size_render(&scene) : status;
}
