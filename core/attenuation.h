/*
 * attenuation.h - where the bytes of FreeVoxels lie, and what they are made of.
 */
#ifndef QV_ATTENUATION_H
#define QV_ATTENUATION_H

#include "fx_exp.h"
#include "fx_wide.h"
#include "access.h"
#include "pyramid.h"
#include "qvol.h"

/* Whether such records can lie in so much memory. QV_OK, QV_ERROR_DIRECTION (set), _SIZE,
   _ATTENUATION. */
qv_status qv_attenuation_check(const qv_attenuation *attenuation, uint64_t bytes);

/* How the voxels of a level follow each other; linear where the descriptor names no order. */
static inline const qv_order *qv_attenuation_order(const qv_attenuation *attenuation)
{
    return attenuation->order ? attenuation->order : &qv_order_linear;
}

/* Bytes from a voxel's to those of the next index: as many as the set has, or more. */
uint16_t qv_attenuation_record(const qv_attenuation *attenuation);

/* The bytes of a voxel of the level; `record` is qv_attenuation_record, and all was checked. */
static inline qv_address qv_attenuation_of(const qv_attenuation *attenuation, uint16_t record,
                                           const uint16_t position[3])
{
    const qv_order *order = qv_attenuation_order(attenuation);
    uint64_t index = QV_FIELD(order, index)(attenuation->size, position);
    return qv_at(attenuation->records, (qv_offset)index * (qv_offset)record);
}

/* round(255 * 2^-depth), ties upwards, within .50002 of it; 255 * 2^-9 rounds to 0. Of Q1.31, 24
   fraction bits are kept: 255 * 2^24 + 2^23 < 2^32. */
static inline uint8_t qv_attenuation_byte(fx_depth depth)
{
    if (depth >> 32 >= 9u)
        return 0;
    return (uint8_t)(((fx_transmittance(depth) >> 7) * 255u + 0x800000u) >> 24);
}

/* ---- What is written ---------------------------------------------------------- */

/* The bytes of one direction. */
typedef struct qv_target {
    uint8_t *first; /* that of the voxel with index 0 */
    const qv_order *order;
    const uint16_t *size;
    uint16_t record;
} qv_target;

/* Those of a level of this size, in memory of so many bytes. QV_OK, QV_ERROR_DIRECTION, _SIZE,
   _ATTENUATION. */
qv_status qv_target_init(qv_target *target, void *to, size_t bytes,
                         const qv_attenuation *attenuation, const uint16_t size[3],
                         uint8_t direction);

/* From there to that of a voxel. */
static inline size_t qv_target_offset(const qv_target *target, const uint16_t position[3])
{
    return (size_t)QV_FIELD(target->order, index)(target->size, position) * target->record;
}

/* ---- Blocks ------------------------------------------------------------------- */

/* Sums of the depths of 2 x 2 x 2 voxels, each at most 64: Q9.22, at most 2^31. */
#define QV_BLOCK_FRACTION 22u

/* Where among them the sum of a voxel's block lies. */
static inline size_t qv_attenuation_block(const uint16_t size[3], const uint16_t position[3])
{
    size_t row = (size_t)(position[2] >> 1) * qv_coarser_size(size[1]) + (position[1] >> 1);
    return row * qv_coarser_size(size[0]) + (position[0] >> 1);
}

#endif /* QV_ATTENUATION_H */
