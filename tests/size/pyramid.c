/*
 * pyramid.c - coarser levels: one is made, and the mode that reads them all renders.
 */
#include "size.h"

#define FIELD_OF_VIEW 0x20000000u /* 45 degrees */

enum { LEVELS = 2, LEVEL_BYTES = 3 * 3 * 3 * 4 };

/* Program memory is not written here: any bytes that lie there are the levels. */
static void describe(qv_pyramid *pyramid, const qv_volume *volume)
{
    qv_attenuation bytes;
    volume_attenuation(&bytes);
    pyramid->voxels = bytes.records;
    pyramid->levels = LEVELS;
    measure_begin();
    pyramid->bytes = qv_pyramid_bytes(volume->size, volume->storage, LEVELS);
    measure_end();
}

static qv_status make_level(const qv_volume *volume, const qv_pyramid *pyramid)
{
    qv_volume level;
    qv_status status = QV_OK;
    SIZE_CALL(status, qv_pyramid_level(&level, volume, pyramid, 0));
    SIZE_CALL(status, qv_downsample(size_memory, LEVEL_BYTES, &level, &qv_filter_box4,
                                    &qv_domain_extinction, 0, VOLUME_EDGE / 2 + 1));
    return status;
}

qv_status use_pyramid(void)
{
    qv_scene scene;
    qv_view view;
    qv_pyramid pyramid;
    size_scene(&scene, &view, &qv_extinction_indexed8_levels);
    describe(&pyramid, &scene.volume);
    scene.pyramid = &pyramid;
    qv_status status = make_level(&scene.volume, &pyramid);
    SIZE_CALL(status, qv_perspective(&scene.camera, &scene.volume, &view, FIELD_OF_VIEW));
    SIZE_CALL(status, qv_detail(&scene, &view));
    return status == QV_OK ? size_render(&scene) : status;
}
