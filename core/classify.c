#include "qvol.h"

#include "access.h"
#include "block.h"
#include "entry.h"
#include "fx_inline.h"
#include "layout.h"
#include "scalars.h"
#include "shade.h"
#include "storage.h"

#define WINDOW_LEAST    (-65536)
#define WINDOW_GREATEST 131071
#define LAST_ENTRY      (QV_PALETTE_ENTRIES - 1u)

/* What the voxels of one call share. */
typedef struct pass {
    const qv_scalars *scalars;
    const qv_transfer *transfer;
    const qv_shader *shader; /* null: none */
    int32_t low;
    uint32_t window; /* high - low: 1 .. 196607 */
    uint8_t storage;
} pass;

/* round(255 * (s - low) / window), ties upwards, clamped. */
static uint32_t table_index(const pass *p, int32_t s)
{
    if (s <= p->low)
        return 0;
    uint32_t above = (uint32_t)(s - p->low); /* s - low <= 131071 */
    if (above >= p->window)
        return LAST_ENTRY;
    return (2u * LAST_ENTRY * above + p->window) / (2u * p->window); /* < 2^27 */
}

/* The value after the voxel less the one before it, along an axis; at the faces
   of the volume the voxel's own value stands for the missing one. */
static int32_t difference(const qv_scalars *scalars, qv_address at, unsigned axis,
                          uint16_t position)
{
    qv_offset stride = (qv_offset)scalars->stride[axis];
    qv_address before = position > 0 ? qv_at(at, -stride) : at;
    qv_address after = position + 1u < scalars->size[axis] ? qv_at(at, stride) : at;
    return qv_scalar(after, scalars->type) - qv_scalar(before, scalars->type);
}

static void colour(uint16_t rgba[4], const pass *p, qv_address at, const uint16_t position[3],
                   uint32_t index)
{
    memcpy(rgba, p->transfer->rgba[index], 4 * sizeof rgba[0]);
    if (p->shader) {
        int32_t d[3];
        for (unsigned axis = 0; axis < 3; axis++)
            d[axis] = difference(p->scalars, at, axis, position[axis]);
        qv_shade(rgba, p->shader, d);
    }
}

static void classify_voxel(uint8_t *voxel, const pass *p, const uint16_t position[3])
{
    qv_address at = qv_scalars_at(p->scalars, position);
    uint32_t index = table_index(p, qv_scalar(at, p->scalars->type));
    if (qv_storage_indexed(p->storage)) {
        *voxel = (uint8_t)index;
    } else {
        uint16_t rgba[4];
        colour(rgba, p, at, position, index);
        qv_entry_write(voxel, p->storage, rgba);
    }
}

static FX_NOINLINE void classify_block(uint8_t *voxel, const pass *p, const qv_block *block)
{
    uint16_t at[3];
    for (at[2] = block->first[2]; at[2] < block->end[2]; at[2]++)
        for (at[1] = block->first[1]; at[1] < block->end[1]; at[1]++)
            for (at[0] = block->first[0]; at[0] < block->end[0]; at[0]++) {
                classify_voxel(voxel, p, at);
                voxel += qv_voxel_bytes(p->storage);
            }
}

static FX_NOINLINE qv_status check_source(const qv_classifier *classifier)
{
    qv_status status = qv_scalars_check(&classifier->scalars);
    if (status == QV_OK)
        status = qv_spacing_check(classifier->scalars.spacing);
    if (status == QV_OK && (classifier->low < WINDOW_LEAST || classifier->high > WINDOW_GREATEST ||
                            classifier->low >= classifier->high))
        status = QV_ERROR_WINDOW;
    return status;
}

qv_status qv_classify(void *voxels, size_t bytes, uint8_t storage, const qv_classifier *classifier,
                      const qv_block *block)
{
    if (!voxels || !classifier || !block)
        return QV_ERROR_NULL;
    if (storage < QV_STORAGE_RGBA8 || storage > QV_STORAGE_INDEXED8_16)
        return QV_ERROR_STORAGE;
    int coloured = !qv_storage_indexed(storage);
    if (coloured && !classifier->transfer)
        return QV_ERROR_NULL;
    qv_status status = check_source(classifier);
    if (status != QV_OK)
        return status;

    qv_shader shader;
    uint32_t window = (uint32_t)(classifier->high - classifier->low);
    pass p = {&classifier->scalars, classifier->transfer, NULL, classifier->low, window, storage};
    if (coloured && classifier->shading) {
        status = qv_shader_init(&shader, classifier->shading, classifier->scalars.spacing, window);
        p.shader = &shader;
    }
    if (status == QV_OK && !qv_block_valid(block, classifier->scalars.size))
        status = QV_ERROR_SIZE;
    if (status == QV_OK && bytes < qv_block_bytes(block, qv_voxel_bytes(storage)))
        status = QV_ERROR_BUFFER;
    if (status == QV_OK)
        classify_block((uint8_t *)voxels, &p, block);
    return status;
}
