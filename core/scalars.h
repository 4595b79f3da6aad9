/*
 * scalars.h - volumes of scalars: the check of a descriptor, and its values.
 */
#ifndef QV_SCALARS_H
#define QV_SCALARS_H

#include "access.h"
#include "qvol.h"

/* Bytes of one value, also its alignment; 0 where the type is unknown. */
static inline uint32_t qv_scalar_bytes(uint8_t type)
{
    if (type == QV_SCALAR_U8)
        return 1;
    return type == QV_SCALAR_U16 || type == QV_SCALAR_S16 ? 2 : 0;
}

/* The least value of a known type; the greatest is 255 or 65535 above it. */
static inline int32_t qv_scalar_least(uint8_t type)
{
    return type == QV_SCALAR_S16 ? -32768 : 0;
}

/* The value at an address that qv_scalars_at gave: -32768 .. 65535. */
static inline int32_t qv_scalar(qv_address at, uint8_t type)
{
    if (type == QV_SCALAR_U8)
        return qv_read8(at);
    int32_t bits = qv_read16(at);
    return type == QV_SCALAR_S16 && bits >= 32768 ? bits - 65536 : bits;
}

/* Address of a value. Checked strides keep every sum within the memory given. */
static inline qv_address qv_scalars_at(const qv_scalars *scalars, const uint16_t position[3])
{
    qv_address at = scalars->values;
    for (unsigned axis = 0; axis < 3; axis++)
        if (position[axis] != 0)
            at = qv_at(at, (qv_offset)scalars->stride[axis] * (qv_offset)position[axis]);
    return at;
}

/* Everything but the spacing, which not every use reads. QV_OK or QV_ERROR_NULL
   (no values), _STORAGE (unknown type), _SIZE, _STRIDE. */
qv_status qv_scalars_check(const qv_scalars *scalars);

#endif /* QV_SCALARS_H */
