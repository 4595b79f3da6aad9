#include "reference.h"

#include <math.h>

/* The storage of a level: the channels of the volume or of its palette. */
static uint8_t level_storage(uint8_t storage)
{
    if (ref_holds_extinction(storage)) {
        return ref_is_wide(storage) ? QV_STORAGE_RGBT16 : QV_STORAGE_RGBT8;
    }
    return ref_is_wide(storage) ? QV_STORAGE_RGBA16 : QV_STORAGE_RGBA8;
}

/* Makes the next coarser level of a volume, its voxels at an address and tightly packed. */
static void coarsen(qv_volume *level, qv_address voxels)
{
    level->voxels = voxels;
    level->storage = level_storage(level->storage);
    level->palette = NULL;
    level->palette_bytes = 0;
    int32_t stride = ref_is_wide(level->storage) ? 8 : 4;
    for (int axis = 0; axis < 3; axis++) {
        const uint32_t spacing = level->spacing[axis] == 0 ? QV_ONE_Q16 : level->spacing[axis];
        level->size[axis] = (uint16_t)((level->size[axis] + 1) / 2);
        level->spacing[axis] = 2 * spacing;
        level->stride[axis] = stride;
        stride *= level->size[axis];
    }
    level->voxels_bytes = (uint64_t)stride;
}

void ref_pyramid_level(qv_volume *level, const qv_scene *scene, int number)
{
    *level = scene->volume;
    for (int i = 1; i <= number; i++) {
        /* level 1 begins the pyramid, each other where the one before it ends */
        coarsen(level, i == 1 ? scene->pyramid->voxels : level->voxels + level->voxels_bytes);
    }
}

static void constant_span(ref_span *span, double level, double end)
{
    span->level = (int)floor(level);
    span->begin = -HUGE_VAL;
    span->end = end;
    span->first = span->last = level - span->level;
}

/* One of the spans of a level that rises: from one doubling of the distance to the next. */
static void rising_span(ref_span *span, const qv_scene *scene, double position)
{
    const double distance = scene->level_distance;
    const int least = scene->level / 256, most = scene->pyramid->levels;
    const int doublings = position < distance ? -1 : (int)floor(log2(position / distance));
    if (doublings < 0) {
        constant_span(span, least, distance);
    } else if (least + doublings >= most) {
        constant_span(span, most, HUGE_VAL);
    } else {
        span->level = least + doublings;
        span->begin = ldexp(distance, doublings);
        span->end = 2 * span->begin;
        span->first = 0;
        span->last = 1;
    }
}

void ref_span_at(ref_span *span, const qv_scene *scene, double position)
{
    if (scene->pyramid == NULL) {
        constant_span(span, 0, HUGE_VAL);
    } else if (scene->level_distance == 0) {
        constant_span(span, scene->level / 256.0, HUGE_VAL);
    } else {
        rising_span(span, scene, position);
    }
}

double ref_share(const ref_span *span, double position)
{
    if (span->first == span->last) {
        return span->first; /* also of spans without an end */
    }
    const double part = (position - span->begin) / (span->end - span->begin);
    return span->first + part * (span->last - span->first);
}
