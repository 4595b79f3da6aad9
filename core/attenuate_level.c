#include "attenuation.h"

#include "order.h"
#include "overlap.h"

/* The voxels of level 0, first .. end - 1 on each axis, that a voxel of a level stands for. */
static void find_voxels(uint16_t first[3], uint16_t end[3], const uint16_t size[3], unsigned level,
                        const uint16_t position[3])
{
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t from = (uint32_t)position[axis] << level; /* < size <= 2^12 */
        uint32_t to = from + ((uint32_t)1 << level);
        first[axis] = (uint16_t)from;
        end[axis] = to < size[axis] ? (uint16_t)to : size[axis];
    }
}

/* Of the blocks, two voxels wide, that hold them. At most 2^33 of 2^31, and voxels where light
   comes in have no depth: less than 2^64. */
static uint64_t sum_of(const uint32_t *blocks, const uint16_t size[3], const uint16_t first[3],
                       const uint16_t end[3])
{
    uint64_t sum = 0;
    uint16_t at[3];
    for (at[2] = first[2]; at[2] < end[2]; at[2] = (uint16_t)(at[2] + 2u))
        for (at[1] = first[1]; at[1] < end[1]; at[1] = (uint16_t)(at[1] + 2u))
            for (at[0] = first[0]; at[0] < end[0]; at[0] = (uint16_t)(at[0] + 2u))
                sum += blocks[qv_attenuation_block(size, at)];
    return sum;
}

/* sum / voxels, to nearest. Of 2^31 voxels and more, up to 6 bits are cut from both, which takes
   less than 2^-30 of the ratio. */
static fx_depth mean(uint64_t sum, uint64_t voxels)
{
    for (; voxels >> 31 != 0; voxels >>= 1)
        sum >>= 1;
    return fx_divide(sum + voxels / 2u, (uint32_t)voxels) << (32u - QV_BLOCK_FRACTION);
}

/* The mean depth of a voxel of a level. */
static fx_depth mean_depth(const uint32_t *blocks, const uint16_t size[3], unsigned level,
                           const uint16_t position[3])
{
    uint16_t first[3], end[3];
    find_voxels(first, end, size, level, position);
    uint32_t extent[3];
    for (unsigned axis = 0; axis < 3; axis++)
        extent[axis] = (uint32_t)end[axis] - first[axis];
    return mean(sum_of(blocks, size, first, end),
                fx_wide_product(extent[0] * extent[1], extent[2]));
}

qv_status qv_attenuate_level(void *to, size_t bytes, const qv_attenuation *attenuation,
                             const uint32_t *blocks, const uint16_t size[3], uint8_t level,
                             uint8_t direction)
{
    if (!to || !attenuation || !blocks || !size)
        return QV_ERROR_NULL;
    if (!qv_box_valid(size))
        return QV_ERROR_SIZE;
    if (level == 0 || level > qv_pyramid_levels(size))
        return QV_ERROR_LEVEL;
    uint16_t end[3], at[3];
    qv_target target;
    for (unsigned axis = 0; axis < 3; axis++)
        end[axis] = qv_level_size(size[axis], level);
    qv_status status = qv_target_init(&target, to, bytes, attenuation, end, direction);
    if (status != QV_OK)
        return status;
    if (qv_regions_meet((uintptr_t)blocks - (uintptr_t)to, qv_attenuation_bytes(attenuation),
                        qv_blocks_bytes(size)))
        return QV_ERROR_OVERLAP;

    for (at[2] = 0; at[2] < end[2]; at[2]++)
        for (at[1] = 0; at[1] < end[1]; at[1]++)
            for (at[0] = 0; at[0] < end[0]; at[0]++) {
                fx_depth depth = mean_depth(blocks, size, level, at);
                target.first[qv_target_offset(&target, at)] = qv_attenuation_byte(depth);
            }
    return QV_OK;
}
