/*
 * thickness.h - the optical depth of a voxel along a stretch of some length.
 */
#ifndef QV_THICKNESS_H
#define QV_THICKNESS_H

#include "fx_exp.h"
#include "fx_inline.h"
#include "fx_wide.h"
#include "qvol.h"

/* What turns a voxel's weight (qv_domain, at most 2^30) into depth: factor * 2^-shift in Q32.32. */
typedef struct qv_thickness {
    uint32_t factor;
    uint8_t shift; /* 3 .. 54; of steps, 3 .. 35 */
} qv_thickness;

/*
 * That of a length in world units, Q9.23, not 0, for the fourth channel of a volume. Where
 * opacities have no unit distance, they hold for the length, whatever it is. Within 2^-26 of
 * itself. QV_OK, QV_ERROR_UNIT, QV_ERROR_EXTINCTION.
 */
qv_status qv_thickness_of(qv_thickness *thickness, const qv_volume *volume, uint32_t length);

/* The depth of a voxel, cut; at most 2^(12 + 6 + 32). */
FX_INLINE fx_depth qv_thickness_depth(const qv_thickness *thickness, uint32_t weight)
{
    return fx_wide_product(weight, thickness->factor) >> thickness->shift;
}

#endif /* QV_THICKNESS_H */
