#include "order.h"

qv_status qv_order_index(uint64_t *index, const qv_order *order, const uint16_t size[3],
                         const uint16_t position[3])
{
    if (!index || !order || !size || !position)
        return QV_ERROR_NULL;
    if (!qv_box_valid(size) || !qv_box_holds(size, position))
        return QV_ERROR_SIZE;
    *index = QV_FIELD(order, index)(size, position);
    return QV_OK;
}

qv_status qv_order_position(uint16_t position[3], const qv_order *order, const uint16_t size[3],
                            uint64_t index)
{
    if (!position || !order || !size)
        return QV_ERROR_NULL;
    if (!qv_box_valid(size) || index >= qv_box_voxels(size))
        return QV_ERROR_SIZE;
    QV_FIELD(order, position)(position, size, index);
    return QV_OK;
}
