#include "medium.h"

#include "storage.h"

/* Powers of 2: of step to unit distance, either way; of the coarsest level's step to it; and
   of the full value's depth for that step. */
#define MOST_RATIO_BITS 12
#define MOST_LEVEL_BITS 11
#define MOST_DEPTH_BITS 22

#define ONE_Q32 ((uint64_t)1 << 32)
#define LN2_Q32 0xB17217F8u

/* The light of a step, with the whole part that the coarsest level's pieces need. At
   least one bit: factors near 1 may round up to it. */
static void set_light(qv_medium *medium, uint64_t light, unsigned levels)
{
    uint64_t most = light << levels; /* < 2^(22 + 32) */
    medium->light_shift = 1;
    while (most >> medium->light_shift >> 32 != 0)
        medium->light_shift++;
    medium->light = (uint32_t)(light >> medium->light_shift);
}

/* Step by unit distance, Q32.32, to nearest, or 0 where that is out of range. A unit distance
   of 32 bits is halved, and the step with it, for the sake of the division. */
static uint64_t unit_ratio(const qv_scene *scene)
{
    uint32_t step = scene->camera.step, unit = scene->volume.unit_distance;
    if (unit == 0 || unit == step)
        return ONE_Q32;
    if ((uint64_t)unit << MOST_RATIO_BITS < step || (uint64_t)step << MOST_RATIO_BITS < unit)
        return 0;
    unsigned cut = (unsigned)(unit >> 31);
    return fx_divide((((uint64_t)step << 32) + unit / 2u) >> cut, unit >> cut);
}

qv_status qv_medium_corrected(qv_medium *medium, const qv_scene *scene, unsigned levels)
{
    uint64_t ratio = unit_ratio(scene);
    if (ratio == 0 || ratio << levels > ONE_Q32 << MOST_LEVEL_BITS) /* <= 2^(12 + 32 + 12) */
        return QV_ERROR_UNIT;
    medium->depth = ratio;
    set_light(medium, ratio, levels);
    return QV_OK;
}

/* From the full value's depth for a step, Q32.32, below 2^22 also on the coarsest level. */
static qv_status set_extinction(qv_medium *medium, uint64_t depth, unsigned levels)
{
    if (depth == 0 || depth >> (32 + MOST_DEPTH_BITS - levels) != 0)
        return QV_ERROR_EXTINCTION;
    uint64_t whole = fx_wide_product((uint32_t)(depth >> 32), LN2_Q32); /* < 2^54 */
    uint64_t fraction = fx_wide_product((uint32_t)depth, LN2_Q32) >> 32;
    set_light(medium, whole + fraction, levels);
    return QV_OK;
}

/*
 * Extinction sums count 65536 * 255 or 65536 * 65535 for the full value. 2^32 of them are
 * worth the depth times 65536/255 = 257 + 1/255 or 65536/65535 = 1 + 1/65535; 1/255 =
 * 1/2^8 + 1/2^16 + ...: low by less than one in 2^30.
 */
qv_status qv_medium_extinction(qv_medium *medium, const qv_scene *scene, unsigned levels)
{
    uint64_t depth = fx_wide_product(scene->volume.extinction, scene->camera.step);
    qv_status status = set_extinction(medium, depth, levels);
    if (status != QV_OK)
        return status;
    if (qv_channel_bytes(scene->volume.storage) == 1) /* depth < 2^54 */
        medium->depth = (depth << 8) + depth + (depth >> 8) + (depth >> 16) + (depth >> 24);
    else
        medium->depth = depth + (depth >> 16);
    return QV_OK;
}

/* Sums count 2^31 for a depth of 64, less what rounding takes: a little more makes a voxel
   of full opacity opaque at every step. */
qv_status qv_medium_converted(qv_medium *medium, const qv_scene *scene, unsigned levels)
{
    uint64_t ratio = unit_ratio(scene);
    if (ratio == 0)
        return QV_ERROR_UNIT;
    qv_status status = set_extinction(medium, ratio << 6, levels);
    if (status == QV_OK)
        medium->depth = (ratio << 7) + (ratio >> 20); /* < 2^(12 + 32 + 8) */
    return status;
}

qv_status qv_prepare_corrected(qv_context *context, const qv_scene *scene)
{
    qv_status status = qv_volume_check(&scene->volume);
    return status == QV_OK ? qv_medium_corrected(&context->medium, scene, 0) : status;
}

qv_status qv_prepare_extinction(qv_context *context, const qv_scene *scene)
{
    qv_status status = qv_volume_check(&scene->volume);
    return status == QV_OK ? qv_medium_extinction(&context->medium, scene, 0) : status;
}

qv_status qv_prepare_converted(qv_context *context, const qv_scene *scene)
{
    qv_status status = qv_volume_check(&scene->volume);
    return status == QV_OK ? qv_medium_converted(&context->medium, scene, 0) : status;
}
