#include "level.h"

#include "pyramid.h"

#define BLEND_BITS 24 /* from Q8.8 to Q0.32 */

qv_status qv_level_check(const qv_scene *scene)
{
    qv_status status = qv_volume_check(&scene->volume);
    if (status == QV_OK)
        status = qv_pyramid_check(&scene->volume, scene->pyramid);
    if (status != QV_OK)
        return status;
    int rises = scene->level_distance != 0, has_eye = scene->camera.pace[0] != 0;
    if (scene->level > scene->pyramid->levels * 256u || scene->level_distance > QV_MOST_DISTANCE ||
        (rises && !has_eye))
        return QV_ERROR_LEVEL;
    return QV_OK;
}

/* Where the border before a stretch lies. */
static int64_t border(int64_t stretch)
{
    return stretch * QV_STEP - QV_HALF_STEP;
}

/* The span of a stretch, where the level rises with the distance. */
static void begin_at_distance(qv_span *span, int64_t stretch, const qv_scene *scene)
{
    int64_t octave = scene->level_distance; /* doubled to at most a stretch, below 2^22 */
    unsigned last = scene->pyramid->levels;
    span->level = scene->level >> 8;
    span->end = border(octave);
    if (stretch < octave)
        return;
    for (; 2 * octave <= stretch && span->level < last; octave *= 2)
        span->level++;
    span->end = INT64_MAX;
    if (span->level < last) {
        span->octave = (uint32_t)octave;
        span->end = border(2 * octave);
    }
}

void qv_span_begin(qv_span *span, const qv_ray *ray, const qv_scene *scene)
{
    span->octave = 0;
    span->blend = 0;
    span->rise = 0;
    if (scene->level_distance != 0) {
        begin_at_distance(span, qv_stretch_of(ray->enter), scene);
        return;
    }
    span->level = scene->level >> 8;
    span->blend = (uint32_t)scene->level << BLEND_BITS;
    span->end = INT64_MAX;
}

/* The middle lies in the octave, so that the share is below 1. Pieces are 2^level steps of
   the octave, which are fewer where a run has more than one. */
void qv_span_blend(qv_span *span, const qv_run *run)
{
    if (span->octave == 0)
        return;
    uint64_t beyond = (uint64_t)(run->middle - border(span->octave)); /* < 2^46 */
    span->blend = (uint32_t)fx_divide(beyond << (32u - QV_STEP_BITS), span->octave);
    span->rise = (uint32_t)fx_divide((uint64_t)1 << (32u + span->level), span->octave);
}

/* Makes the levels those of a span. The second is only looked for where it exists. */
static FX_NOINLINE void find(qv_levels *levels, unsigned finer, const qv_scene *scene)
{
    for (unsigned i = 0; i < 2 && finer + i <= scene->pyramid->levels; i++)
        levels->voxels[i] = qv_pyramid_voxels(&scene->volume, scene->pyramid, (uint8_t)(finer + i));
    levels->finer = finer;
}

int qv_cut_run_of_levels(qv_levels *levels, qv_run *run, qv_ray *ray, const qv_scene *scene)
{
    qv_span span;
    qv_span_begin(&span, ray, scene);
    if (!qv_cut_run(run, ray, span.end, span.level))
        return 0;
    qv_span_blend(&span, run);
    levels->blend = span.blend;
    levels->rise = span.rise;
    if (levels->finer != span.level)
        find(levels, span.level, scene);
    return 1;
}
