#include "splat.h"

#include "bearing.h"
#include "cell.h"
#include "entry.h"
#include "kernel.h"
#include "lighting.h"
#include "pyramid.h"
#include "thickness.h"

/* Pixels of a row that are weighed at a time. */
#define STRIP 8u

/*
 * Opacity of a voxel over a step towards the viewer, Q1.31. The thickness is that of the longest
 * step; a voxel of a level is as many steps of level 0 thick as it is voxels wide.
 */
static uint32_t opacity_of(const qv_splats *splats, const qv_sight *sight, uint32_t weight,
                           unsigned level)
{
    qv_thickness thickness = {splats->factor, splats->shift};
    if (!splats->compass.any_length) /* length <= 2^31 */
        thickness.factor = (uint32_t)(fx_wide_product(splats->factor, sight->length) >> 31);
    return fx_opacity(qv_thickness_depth(&thickness, weight) << level); /* < 2^(50 + 12) */
}

/* What a voxel of an opacity, Q1.31, brings to a pixel that it covers alone: levels, Q10.22, of
   opacity. */
static FX_NOINLINE uint32_t gain_of(const qv_splats *splats, const qv_sight *sight,
                                    const qv_freevoxel *voxel, fx_unorm16 fourth)
{
    const qv_splat_scene *scene = &splats->scene;
    uint32_t weight = QV_FIELD(scene->domain, weight)(fourth);
    uint32_t opacity = opacity_of(splats, sight, weight, voxel->level);
    if (QV_FIELD(scene->splatting, attenuated))
        opacity = fx_high_product(
            opacity, qv_bearing_transmittance(&sight->viewer, voxel->attenuation, scene->inside));
    return (uint32_t)((fx_wide_product(opacity, sight->gain) + 0x40000000u) >> 31);
}

/* A splat's pixels in a rectangle: columns and lines, from .. end - 1. */
typedef struct window {
    int32_t column[2], line[2];
} window;

/* Returns 0 where there are none. */
static FX_NOINLINE int set_window(window *w, const qv_sums *sums, const qv_splats *splats,
                                  const qv_sight *sight)
{
    const qv_kernel *kernel = splats->scene.kernel;
    const qv_rect *rect = &sums->rect;
    qv_footprint footprint;
    qv_footprint_place(&footprint, kernel, sight->x, sight->width);
    qv_footprint_range(&w->column[0], &w->column[1], &footprint, rect->left, rect->right);
    qv_footprint_place(&footprint, kernel, sight->y, sight->height);
    qv_footprint_range(&w->line[0], &w->line[1], &footprint, rect->top, rect->bottom);
    return w->column[0] < w->column[1] && w->line[0] < w->line[1];
}

/* What is added to the sums: light by the weights of the pixels in a window. */
typedef struct splat {
    qv_footprint across, down;
    const window *in;
    const uint32_t *light;
} splat;

/* Adds light to the lines of a strip of columns: by a line's weight Q10.21, by a column's
   Q10.20. */
static FX_NOINLINE void put_strip(const qv_sums *sums, const qv_splatting *splatting,
                                  const splat *s, int32_t column, unsigned count)
{
    uint16_t weights[STRIP];
    size_t width = (size_t)(sums->rect.right - sums->rect.left);
    size_t first = (size_t)(s->in->line[0] - sums->rect.top) * width;
    uint32_t *row = sums->sums + QV_SUM_CHANNELS * (first + (size_t)(column - sums->rect.left));
    qv_footprint_weights(weights, &s->across, column, count);
    for (int32_t y = s->in->line[0]; y < s->in->line[1]; y++, row += QV_SUM_CHANNELS * width) {
        uint32_t of_row[4];
        uint16_t weight = qv_footprint_weight(&s->down, y);
        for (unsigned c = 0; c < 4; c++)
            of_row[c] = fx_product_shift16(s->light[c], weight);
        QV_FIELD(splatting, row)(row, weights, count, of_row);
    }
}

static FX_NOINLINE void put_light(const qv_sums *sums, const qv_splat_scene *scene,
                                  const qv_sight *sight, const window *w, const uint32_t light[4])
{
    splat s;
    qv_footprint_of(&s.across, scene->kernel, sight->x, sight->width);
    qv_footprint_of(&s.down, scene->kernel, sight->y, sight->height);
    s.in = w;
    s.light = light;
    for (int32_t column = w->column[0]; column < w->column[1]; column += (int32_t)STRIP) {
        uint32_t left = (uint32_t)(w->column[1] - column);
        put_strip(sums, scene->splatting, &s, column, left < STRIP ? (unsigned)left : STRIP);
    }
}

void qv_splat_put(const qv_sums *sums, const qv_splats *splats, const qv_freevoxel *voxel)
{
    const qv_splat_scene *scene = &splats->scene;
    unsigned storage = scene->volume.storage;
    unsigned of_voxel = voxel->level == 0 ? storage : qv_entry_storage(storage);
    fx_unorm16 entry[4];
    qv_sight sight;
    window w;
    uint32_t light[4];
    qv_entry_read(entry, qv_entry(voxel->voxel, &scene->volume, of_voxel), of_voxel);
    if (entry[3] == 0 || !qv_splat_belongs(splats, voxel->position, voxel->level) ||
        !qv_sight_of(&sight, splats, voxel->position, voxel->level) ||
        !set_window(&w, sums, splats, &sight))
        return;
    light[3] = gain_of(splats, &sight, voxel, entry[3]);
    if (light[3] == 0)
        return;
    qv_lighting_colour(entry, &scene->lighting, splats->lamp, voxel->attenuation);
    for (unsigned c = 0; c < 3; c++) /* 65537 is (2^32 - 1) / 65535 */
        light[c] = fx_high_product(light[3], 65537u * entry[c]);
    put_light(sums, scene, &sight, &w, light);
}

/* Position and memory of one voxel. */
static FX_NOINLINE qv_status check_voxel(const qv_splats *splats, const qv_freevoxel *voxel)
{
    const qv_splat_scene *scene = &splats->scene;
    int read = QV_FIELD(scene->splatting, attenuated) || scene->lighting.count != 0;
    if (!voxel->voxel || (read && !voxel->attenuation))
        return QV_ERROR_NULL;
    if (voxel->level > qv_pyramid_levels(scene->volume.size))
        return QV_ERROR_LEVEL;
    for (unsigned axis = 0; axis < 3; axis++)
        if (voxel->position[axis] >= qv_level_size(scene->volume.size[axis], voxel->level))
            return QV_ERROR_SIZE;
    unsigned storage = scene->volume.storage;
    unsigned of_voxel = voxel->level == 0 ? storage : qv_entry_storage(storage);
    return qv_aligned(voxel->voxel, qv_voxel_alignment(of_voxel)) ? QV_OK : QV_ERROR_STRIDE;
}

qv_status qv_splat(const qv_sums *sums, const qv_splats *splats, const qv_freevoxel *voxel)
{
    if (!splats || !voxel)
        return QV_ERROR_NULL;
    qv_status status = qv_sums_check(sums);
    if (status == QV_OK)
        status = check_voxel(splats, voxel);
    if (status == QV_OK)
        qv_splat_put(sums, splats, voxel);
    return status;
}

qv_status qv_splat_stream(const qv_sums *sums, const qv_splats *splats,
                          int (*next)(void *user, qv_freevoxel *voxel), void *user)
{
    if (!splats || !next)
        return QV_ERROR_NULL;
    qv_status status = qv_sums_check(sums);
    while (status == QV_OK) {
        qv_freevoxel voxel;
        int more = next(user, &voxel);
        if (more <= 0)
            return (qv_status)more;
        status = check_voxel(splats, &voxel);
        if (status == QV_OK)
            qv_splat_put(sums, splats, &voxel);
    }
    return status;
}
