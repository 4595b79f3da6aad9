#include "access.h"
#include "attenuation.h"
#include "block.h"
#include "fx_inline.h"
#include "fx_wide.h"
#include "layout.h"
#include "order.h"
#include "overlap.h"
#include "splat.h"
#include "storage.h"

/*
 * Back to front: on each axis the voxels on this side of the viewer by rising index, up to him, and
 * those beyond him by falling index, down to him. (No voxel hides another that
 * comes later on any axis.)
 */
typedef struct path {
    uint16_t first, end; /* voxels of the block */
    uint16_t viewer;     /* the first of them beyond the viewer */
} path;

static uint32_t path_steps(const path *p)
{
    return (uint32_t)p->end - p->first;
}

static uint16_t path_at(const path *p, uint32_t step)
{
    uint32_t rising = (uint32_t)p->viewer - p->first;
    return (uint16_t)(step < rising ? p->first + step : p->end - 1u - (step - rising));
}

/* Where the viewer is, in voxels of level 0, on an axis, -1 .. 4097. */
static int32_t viewer_at(const qv_splats *splats, unsigned axis)
{
    int32_t size = splats->scene.volume.size[axis];
    if (splats->scene.field_of_view == 0)
        return splats->scene.view.rotation[2][axis] > 0 ? -1 : size + 1;
    int64_t eye = fx_shift_floor(splats->eye[axis] + size * (int64_t)65536, 17);
    if (eye < 0)
        return -1;
    return eye > size ? size + 1 : (int32_t)eye;
}

/* The viewer's own voxel is the last of those beyond him. */
static FX_NOINLINE void set_path(path *p, const qv_splats *splats, unsigned axis, unsigned level,
                                 const qv_block *block)
{
    int32_t viewer = viewer_at(splats, axis);
    uint32_t at = viewer < 0 ? 0 : (uint32_t)viewer >> level;
    p->first = block->first[axis];
    p->end = block->end[axis];
    p->viewer = p->first;
    if (at > p->first)
        p->viewer = (uint16_t)(at < p->end ? at : p->end);
}

static qv_status check_level(const qv_splats *splats, const qv_volume *level, uint8_t number)
{
    const qv_volume *whole = &splats->scene.volume;
    qv_status status = qv_voxels_check(level);
    if (status != QV_OK)
        return status;
    if (number > qv_pyramid_levels(whole->size))
        return QV_ERROR_LEVEL;
    if (level->storage != (number == 0 ? whole->storage : qv_entry_storage(whole->storage)))
        return QV_ERROR_STORAGE;
    for (unsigned axis = 0; axis < 3; axis++)
        if (level->size[axis] != qv_level_size(whole->size[axis], number))
            return QV_ERROR_SIZE;
    return QV_OK;
}

static qv_status check_attenuation(const qv_splats *splats, const qv_volume *level,
                                   const qv_attenuation *attenuation)
{
    const qv_splat_scene *scene = &splats->scene;
    if (!attenuation)
        return QV_FIELD(scene->splatting, attenuated) || scene->lighting.count != 0 ? QV_ERROR_NULL
                                                                                    : QV_OK;
    if (!attenuation->records)
        return QV_ERROR_NULL;
    if (attenuation->directions != scene->directions)
        return QV_ERROR_DIRECTION;
    if (!qv_box_equals(attenuation->size, level->size))
        return QV_ERROR_SIZE;
    return qv_attenuation_check(attenuation, attenuation->bytes);
}

/* Whether sums are also what they would be made of. */
static int overlaps(const qv_sums *sums, const qv_volume *level, const qv_attenuation *attenuation)
{
    uint64_t width = (uint64_t)(sums->rect.right - sums->rect.left);
    uint64_t bytes = width * (uint32_t)(sums->rect.bottom - sums->rect.top); /* < 2^32 */
    bytes *= QV_SUM_CHANNELS * sizeof(uint32_t);
    return qv_voxels_meet(level, sums->sums, bytes) || qv_palette_meets(level, sums->sums, bytes) ||
           (attenuation && qv_records_meet(attenuation, sums->sums, bytes));
}

/* Bytes lie `record` apart from voxel to voxel. */
static void put_voxel(const qv_sums *sums, const qv_splats *splats, const qv_volume *level,
                      const qv_attenuation *attenuation, uint16_t record, qv_freevoxel *voxel)
{
    voxel->voxel = qv_voxel_at(level, voxel->position);
    if (attenuation)
        voxel->attenuation = qv_attenuation_of(attenuation, record, voxel->position);
    qv_splat_put(sums, splats, voxel);
}

/* All that a block is made of and goes to. */
static FX_NOINLINE qv_status check(const qv_sums *sums, const qv_splats *splats,
                                   const qv_volume *level, const qv_attenuation *attenuation,
                                   uint8_t number, const qv_block *block)
{
    qv_status status = qv_sums_check(sums);
    if (status == QV_OK)
        status = check_level(splats, level, number);
    if (status == QV_OK)
        status = check_attenuation(splats, level, attenuation);
    if (status != QV_OK)
        return status;
    if (!qv_block_valid(block, level->size))
        return QV_ERROR_SIZE;
    return overlaps(sums, level, attenuation) ? QV_ERROR_OVERLAP : QV_OK;
}

qv_status qv_splat_block(const qv_sums *sums, const qv_splats *splats, const qv_volume *level,
                         const qv_attenuation *attenuation, uint8_t number, const qv_block *block)
{
    if (!splats || !level || !block)
        return QV_ERROR_NULL;
    qv_status status = check(sums, splats, level, attenuation, number, block);
    if (status != QV_OK)
        return status;
    path way[3];
    for (unsigned axis = 0; axis < 3; axis++)
        set_path(&way[axis], splats, axis, number, block);
    uint16_t record = attenuation ? qv_attenuation_record(attenuation) : 0;
    qv_freevoxel voxel = {0, 0, {0, 0, 0}, number};
    for (uint32_t z = 0; z < path_steps(&way[2]); z++) {
        voxel.position[2] = path_at(&way[2], z);
        for (uint32_t y = 0; y < path_steps(&way[1]); y++) {
            voxel.position[1] = path_at(&way[1], y);
            for (uint32_t x = 0; x < path_steps(&way[0]); x++) {
                voxel.position[0] = path_at(&way[0], x);
                put_voxel(sums, splats, level, attenuation, record, &voxel);
            }
        }
    }
    return QV_OK;
}
