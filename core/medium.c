#include "medium.h"

#include "storage.h"

/* Of the unit distance to the step, as a power of 2; and of the unit distance in world units. */
#define MOST_RATIO_BITS 12
#define MOST_UNIT       0x7FFFFFFFu

/* The full value's depth for a piece is below 2^22. */
#define MOST_DEPTH_BITS 22

#define LN2_Q32 0xB17217F8u

/* Levels that the scene's pieces may be of. */
static unsigned levels(const qv_scene *scene)
{
    return scene->pyramid ? scene->pyramid->levels : 0u;
}

/* The light of a step, with the whole part that the coarsest level's pieces need. At
   least one bit: factors near 1 may round up to it. */
static void set_light(qv_medium *medium, uint64_t light, unsigned most_level)
{
    uint64_t most = light << most_level; /* < 2^(22 + 32) */
    medium->light_shift = 1;
    while (most >> medium->light_shift >> 32 != 0)
        medium->light_shift++;
    medium->light = (uint32_t)(light >> medium->light_shift);
}

/* Step by unit distance, Q32.32, or 0 where that is out of range. */
static uint64_t unit_ratio(const qv_scene *scene)
{
    uint32_t step = scene->camera.step, unit = scene->volume.unit_distance;
    if (unit == 0 || unit == step)
        return (uint64_t)1 << 32;
    if (unit > MOST_UNIT || (uint64_t)unit << MOST_RATIO_BITS < step ||
        (uint64_t)step << MOST_RATIO_BITS < unit)
        return 0;
    return fx_divide(((uint64_t)step << 32) + unit / 2u, unit);
}

qv_status qv_prepare_corrected(qv_context *context, const qv_scene *scene)
{
    uint64_t ratio = unit_ratio(scene);
    if (ratio == 0)
        return QV_ERROR_UNIT;
    context->medium.depth = ratio;
    set_light(&context->medium, ratio, levels(scene));
    return QV_OK;
}

/* From the full value's depth for a step, Q32.32, below 2^22 also on the coarsest level. */
static qv_status set_extinction(qv_medium *medium, uint64_t depth, const qv_scene *scene)
{
    if (depth == 0 || depth >> (32 + MOST_DEPTH_BITS - levels(scene)) != 0)
        return QV_ERROR_EXTINCTION;
    uint64_t whole = fx_wide_product((uint32_t)(depth >> 32), LN2_Q32); /* < 2^54 */
    uint64_t fraction = fx_wide_product((uint32_t)depth, LN2_Q32) >> 32;
    set_light(medium, whole + fraction, levels(scene));
    return QV_OK;
}

/*
 * Extinction sums count 65536 * 255 or 65536 * 65535 for the full value. 2^32 of them are
 * worth the depth times 65536/255 = 257 + 1/255 or 65536/65535 = 1 + 1/65535; 1/255 =
 * 1/2^8 + 1/2^16 + ...: low by less than one in 2^30.
 */
qv_status qv_prepare_extinction(qv_context *context, const qv_scene *scene)
{
    uint64_t depth = fx_wide_product(scene->volume.extinction, scene->camera.step);
    qv_status status = set_extinction(&context->medium, depth, scene);
    if (status != QV_OK)
        return status;
    if (qv_channel_bytes(scene->volume.storage) == 1) /* depth < 2^54 */
        context->medium.depth = (depth << 8) + depth + (depth >> 8) + (depth >> 16) + (depth >> 24);
    else
        context->medium.depth = depth + (depth >> 16);
    return QV_OK;
}

/* Sums count 2^31 for a depth of 64, less what rounding takes: a little more makes a voxel
   of full opacity opaque at every step. */
qv_status qv_prepare_converted(qv_context *context, const qv_scene *scene)
{
    uint64_t ratio = unit_ratio(scene);
    if (ratio == 0)
        return QV_ERROR_UNIT;
    qv_status status = set_extinction(&context->medium, ratio << 6, scene);
    if (status == QV_OK)
        context->medium.depth = (ratio << 7) + (ratio >> 20); /* < 2^(12 + 32 + 8) */
    return status;
}
