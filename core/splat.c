#include "splat.h"

#include "bearing.h"
#include "cell.h"
#include "entry.h"
#include "kernel.h"
#include "lighting.h"
#include "pyramid.h"
#include "thickness.h"

/* Pixels of a row that are weighed at a time. */
#define STRIP 16u

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

/*
 * What a voxel of an opacity, Q1.31, brings to a pixel that it covers alone: levels, Q10.22, of
 * colours and opacity.
 */
static void light_of(uint32_t light[4], const qv_splats *splats, const qv_sight *sight,
                     uint32_t opacity, const qv_freevoxel *voxel, fx_unorm16 colour[3])
{
    const qv_splat_scene *scene = &splats->scene;
    if (QV_FIELD(scene->splatting, attenuated))
        opacity = fx_high_product(
            opacity, qv_bearing_transmittance(&sight->viewer, voxel->attenuation, scene->inside));
    light[3] = (uint32_t)((fx_wide_product(opacity, sight->gain) + 0x40000000u) >> 31);
    qv_lighting_colour(colour, &scene->lighting, splats->lamp, voxel->attenuation);
    for (unsigned c = 0; c < 3; c++) /* 65537 is (2^32 - 1) / 65535 */
        light[c] = fx_high_product(light[3], 65537u * colour[c]);
}

/* A splat's pixels in a rectangle: columns and lines, from .. end - 1. */
typedef struct window {
    qv_footprint across, down;
    int32_t column[2], line[2];
} window;

/* Returns 0 where there are none. */
static int set_window(window *w, const qv_sums *sums, const qv_splats *splats,
                      const qv_sight *sight)
{
    const qv_kernel *kernel = splats->scene.kernel;
    const qv_rect *rect = &sums->rect;
    qv_footprint_of(&w->across, kernel, sight->x, sight->width);
    qv_footprint_of(&w->down, kernel, sight->y, sight->height);
    qv_footprint_range(&w->column[0], &w->column[1], &w->across, rect->left, rect->right);
    qv_footprint_range(&w->line[0], &w->line[1], &w->down, rect->top, rect->bottom);
    return w->column[0] < w->column[1] && w->line[0] < w->line[1];
}

/* Adds light to the lines of a strip of columns: by a line's weight Q10.21, by a column's
   Q10.20. */
static void put_strip(const qv_sums *sums, const qv_splatting *splatting, const window *w,
                      int32_t column, unsigned count, const uint32_t light[4])
{
    uint16_t weights[STRIP];
    size_t width = (size_t)(sums->rect.right - sums->rect.left);
    size_t first = (size_t)(w->line[0] - sums->rect.top) * width;
    uint32_t *row = sums->sums + QV_SUM_CHANNELS * (first + (size_t)(column - sums->rect.left));
    qv_footprint_weights(weights, &w->across, column, count);
    for (int32_t y = w->line[0]; y < w->line[1]; y++, row += QV_SUM_CHANNELS * width) {
        uint32_t of_row[4];
        uint16_t weight = qv_footprint_weight(&w->down, y);
        for (unsigned c = 0; c < 4; c++)
            of_row[c] = fx_product_shift16(light[c], weight);
        QV_FIELD(splatting, row)(row, weights, count, of_row);
    }
}

static void put_light(const qv_sums *sums, const qv_splatting *splatting, const window *w,
                      const uint32_t light[4])
{
    for (int32_t column = w->column[0]; column < w->column[1]; column += (int32_t)STRIP) {
        uint32_t left = (uint32_t)(w->column[1] - column);
        put_strip(sums, splatting, w, column, left < STRIP ? (unsigned)left : STRIP, light);
    }
}

void qv_splat_put(const qv_sums *sums, const qv_splats *splats, const qv_freevoxel *voxel)
{
    const qv_volume *volume = &splats->scene.volume;
    unsigned storage = voxel->level == 0 ? volume->storage : qv_entry_storage(volume->storage);
    fx_unorm16 entry[4];
    int32_t half[3];
    qv_sight sight;
    window w;
    uint32_t light[4];
    qv_entry_read(entry, qv_entry(voxel->voxel, volume, storage), storage);
    if (entry[3] == 0 || !qv_splat_belongs(splats, voxel->position, voxel->level))
        return;
    qv_half_voxels(half, volume->size, voxel->position, voxel->level);
    if (!qv_sight_of(&sight, splats, half, voxel->level) || !set_window(&w, sums, splats, &sight))
        return;
    uint32_t opacity =
        opacity_of(splats, &sight, QV_FIELD(splats->scene.domain, weight)(entry[3]), voxel->level);
    light_of(light, splats, &sight, opacity, voxel, entry);
    if (light[3] != 0)
        put_light(sums, splats->scene.splatting, &w, light);
}

/* Position and memory of one voxel. */
static qv_status check_voxel(const qv_splats *splats, const qv_freevoxel *voxel)
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
