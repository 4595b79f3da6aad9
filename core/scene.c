#include "camera.h"
#include "march.h"
#include "fx_unorm.h"

/* Levels with 17 fraction bits of colour * opacity: p * 131072 / 255 for p <=
   255^2, as 65536 = 255 * 257 + 1. At most 255 * 131072. */
static uint32_t associated_level(uint8_t colour, uint8_t opacity)
{
    uint32_t p = (uint32_t)colour * opacity;
    return 2u * (p * 257u + fx_div255_round(p));
}

qv_status qv_prepare_steps(qv_context *context, const qv_scene *scene)
{
    (void)context;
    qv_status status = qv_steps_check(scene);
    return status == QV_OK ? qv_volume_check(&scene->volume) : status;
}

static qv_status check_scene(const qv_scene *scene)
{
    if (!scene->sampling)
        return QV_ERROR_NULL;
    if (QV_FIELD(scene->sampling, storage) != scene->volume.storage)
        return QV_ERROR_STORAGE;
    if (scene->camera.step == 0)
        return QV_ERROR_STEP;
    return qv_camera_check(&scene->camera);
}

qv_status qv_init(qv_context *context, const qv_scene *scene)
{
    if (!context || !scene)
        return QV_ERROR_NULL;
    qv_status status = check_scene(scene);
    if (status == QV_OK)
        status = QV_FIELD(scene->sampling, prepare)(context, scene);
    if (status != QV_OK)
        return status;
    const uint8_t *background = scene->background;
    context->scene = *scene;
    for (unsigned c = 0; c < 4; c++)
        context->background[c] = associated_level(c < 3 ? background[c] : 255, background[3]);
    return QV_OK;
}
