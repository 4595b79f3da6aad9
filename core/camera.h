/*
 * camera.h - what the constructors and the check of cameras share.
 */
#ifndef QV_CAMERA_H
#define QV_CAMERA_H

#include "qvol.h"

#define QV_VOXEL       ((qv_coord)1 << 32) /* 1 in Q31.32 */
#define QV_MOST_PITCH  (QV_VOXEL << 12)    /* of |across|, |down| */
#define QV_MOST_PACE   (QV_VOXEL << 6)     /* of |along| or pace */
#define QV_LEAST_PACE  (QV_VOXEL >> 8)
#define QV_MOST_ORIGIN (QV_VOXEL << 20)

/* Ranges and independence as stated at qv_camera. QV_OK, QV_ERROR_NULL, _CAMERA. */
qv_status qv_camera_check(const qv_camera *camera);

/* A world length as voxels of an axis: v / spacing, to nearest; v in Q31.32, |v|
   < 2^54, spacing Q16.16 of 2^8 .. 2^24. */
qv_coord qv_to_voxels(qv_coord v, uint32_t spacing);

/* Ranges of a view and of what it makes of the volume's spacing, with the errors
   stated at qv_orthographic. */
qv_status qv_view_check(const qv_volume *volume, const qv_view *view);

/* What leads from pixel (0, 0) to the centre of the frame, on one axis. */
qv_coord qv_half_frame(const qv_camera *camera, unsigned axis, const qv_view *view);

#endif /* QV_CAMERA_H */
