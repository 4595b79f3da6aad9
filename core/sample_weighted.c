#include "march.h"

/*
 * A port may name a header in QV_TWIN_HEADER that defines QV_MARCH_WEIGHTED8: qv_march of
 * qv_cell_weighted for entries of 8 bits by means of its own, with the same bits.
 */
#ifdef QV_TWIN_HEADER
#include QV_TWIN_HEADER
#endif
#ifndef QV_MARCH_WEIGHTED8
#define QV_MARCH_WEIGHTED8 qv_march
#endif

QV_DEFINE_SAMPLINGS(weighted, QV_MARCH_WEIGHTED8)
