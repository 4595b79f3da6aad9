/*
 * lighting.h - light of lamps on one voxel.
 */
#ifndef QV_LIGHTING_H
#define QV_LIGHTING_H

#include "bearing.h"
#include "fx_unorm.h"

/* Number and directions of the lamps. QV_OK, QV_ERROR_LIGHT. */
qv_status qv_lighting_check(const qv_lighting *lighting);

/* Bearings of the lamps of checked lighting, for volumes of this spacing. QV_OK,
   QV_ERROR_DIRECTION. */
qv_status qv_lighting_bearings(qv_bearing lamp[QV_LAMPS_MAX], const qv_lighting *lighting,
                               const qv_compass *compass, const uint32_t spacing[3]);

/* Lights a colour, for a voxel with these bytes, which are read only where lamps shine. The light
   is within 1.5 of 65535 of exact for the bytes (between depths, and 2^-13 for each lamp), the
   colour is rounded once more. */
void qv_lighting_colour(fx_unorm16 colour[3], const qv_lighting *lighting,
                        const qv_bearing lamp[QV_LAMPS_MAX], qv_address bytes);

#endif /* QV_LIGHTING_H */
