#include "march.h"

/*
 * A port may name a header in QV_TWIN_HEADER that defines QV_MARCH_WEIGHTED8: qv_march of
 * qv_take_weighted for entries of 8 bits by means of its own, with the same bits.
 */
#ifdef QV_TWIN_HEADER
#include QV_TWIN_HEADER
#endif
#ifndef QV_MARCH_WEIGHTED8
#define QV_MARCH_WEIGHTED8 qv_march
#endif

#define QV_DEFINE_WEIGHTED8(suffix, storage)                                                       \
    QV_DEFINE_SAMPLING(QV_MARCH_WEIGHTED8, weighted, suffix, qv_prepare_steps, qv_take_weighted,   \
                       QV_READ_OUT_8, storage)

QV_DEFINE_WEIGHTED8(rgba8, QV_STORAGE_RGBA8)
QV_DEFINE_WEIGHTED8(indexed8, QV_STORAGE_INDEXED8)
QV_DEFINE_STEPS(weighted, rgba16, QV_READ_OUT_16, QV_STORAGE_RGBA16)
QV_DEFINE_STEPS(weighted, indexed8_16, QV_READ_OUT_16, QV_STORAGE_INDEXED8_16)
