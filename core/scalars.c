#include "scalars.h"

#include "access.h"
#include "layout.h"

qv_status qv_scalars_check(const qv_scalars *scalars)
{
    uint32_t bytes = qv_scalar_bytes(scalars->type);
    if (!scalars->values)
        return QV_ERROR_NULL;
    if (bytes == 0)
        return QV_ERROR_STORAGE;
    if (!qv_aligned(scalars->values, (unsigned)bytes))
        return QV_ERROR_STRIDE;
    return qv_layout_check(scalars->size, scalars->stride, scalars->values_bytes, bytes, bytes);
}
