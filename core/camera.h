/*
 * camera.h - what the constructors and the check of cameras share.
 */
#ifndef QV_CAMERA_H
#define QV_CAMERA_H

#include "qvol.h"

#define QV_VOXEL ((qv_coord)1 << 32) /* 1 in Q31.32 */
/* In whole voxels: */
#define QV_MOST_PITCH  (1u << 12) /* of |across|, |down| */
#define QV_MOST_PACE   (1u << 8)  /* of |along| (orthographic), pace (perspective) */
#define QV_MOST_ORIGIN ((uint32_t)1 << 20)

/* The largest magnitude of the components. */
uint64_t qv_largest(const qv_coord v[3]);

/* Whether every component is at most so many voxels in magnitude. */
int qv_within(const qv_coord v[3], uint32_t voxels);

/* Ranges and independence as stated at qv_camera. QV_OK, QV_ERROR_NULL, _CAMERA. */
qv_status qv_camera_check(const qv_camera *camera);

/* A world length, Q16.16, as voxels of an axis, to nearest. At most 2^12 voxels for
   a pitch and 2^8 for a step that qv_view_check has passed. */
qv_coord qv_voxels(uint32_t length, const qv_volume *volume, unsigned axis);

/* Ranges of a view and of the volume's spacing, with the errors stated at
   qv_orthographic. */
qv_status qv_view_check(const qv_volume *volume, const qv_view *view);

/* The same without the step, which splats do not read. */
qv_status qv_frame_check(const qv_volume *volume, const qv_view *view);

/* What leads from pixel (0, 0) to the centre of the frame, on one axis. */
qv_coord qv_half_frame(const qv_camera *camera, unsigned axis, const qv_view *view);

#endif /* QV_CAMERA_H */
