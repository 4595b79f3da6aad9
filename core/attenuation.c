#include "attenuation.h"

#include "access.h"
#include "direction.h"
#include "order.h"

/* Offsets of records must fit a qv_offset, which is signed. */
#define OFFSET_BITS (8u * sizeof(qv_offset) - 1u)

uint16_t qv_attenuation_record(const qv_attenuation *attenuation)
{
    return attenuation->record != 0 ? attenuation->record
                                    : qv_directions_count(attenuation->directions);
}

static qv_status check_records(const qv_attenuation *attenuation)
{
    if (!qv_directions_known(attenuation->directions))
        return QV_ERROR_DIRECTION;
    if (!qv_box_valid(attenuation->size))
        return QV_ERROR_SIZE;
    if (qv_attenuation_record(attenuation) < qv_directions_count(attenuation->directions))
        return QV_ERROR_ATTENUATION;
    return QV_OK;
}

/* Up to the end of the last voxel's bytes. At most 2^24 * 2^(12 + 16). */
static uint64_t extent(const qv_attenuation *attenuation)
{
    const uint16_t *size = attenuation->size;
    uint32_t record = qv_attenuation_record(attenuation);
    uint32_t gap = record - qv_directions_count(attenuation->directions);
    return fx_wide_product((uint32_t)size[0] * size[1], record * size[2]) - gap;
}

qv_status qv_attenuation_check(const qv_attenuation *attenuation, uint64_t bytes)
{
    qv_status status = check_records(attenuation);
    if (status != QV_OK)
        return status;
    uint64_t needed = extent(attenuation);
    return needed > bytes || needed >> OFFSET_BITS != 0 ? QV_ERROR_ATTENUATION : QV_OK;
}

uint64_t qv_attenuation_bytes(const qv_attenuation *attenuation)
{
    if (!attenuation || check_records(attenuation) != QV_OK)
        return 0;
    return extent(attenuation);
}

/* At most 2^33 blocks. */
uint64_t qv_blocks_bytes(const uint16_t size[3])
{
    if (!size || !qv_box_valid(size))
        return 0;
    uint32_t slice = (uint32_t)qv_coarser_size(size[0]) * qv_coarser_size(size[1]);
    return fx_wide_product(slice, (uint32_t)sizeof(uint32_t) * qv_coarser_size(size[2]));
}

qv_address qv_attenuation_at(const qv_attenuation *attenuation, const uint16_t position[3])
{
    if (!attenuation || !attenuation->records || !position ||
        qv_attenuation_check(attenuation, attenuation->bytes) != QV_OK ||
        !qv_box_holds(attenuation->size, position))
        return 0;
    return qv_attenuation_of(attenuation, qv_attenuation_record(attenuation), position);
}

qv_status qv_target_init(qv_target *target, void *to, size_t bytes,
                         const qv_attenuation *attenuation, const uint16_t size[3],
                         uint8_t direction)
{
    qv_status status = qv_attenuation_check(attenuation, bytes);
    if (status != QV_OK)
        return status;
    if (direction >= QV_DIRECTIONS || (attenuation->directions >> direction & 1u) == 0)
        return QV_ERROR_DIRECTION;
    if (!qv_box_equals(attenuation->size, size))
        return QV_ERROR_SIZE;
    target->first = (uint8_t *)to + qv_direction_slot(attenuation->directions, direction);
    target->order = qv_attenuation_order(attenuation);
    target->size = attenuation->size;
    target->record = qv_attenuation_record(attenuation);
    return QV_OK;
}
