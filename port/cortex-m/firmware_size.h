/*
 * firmware_size.h - the two cameras between which the size programs differ.
 */
#ifndef FIRMWARE_SIZE_H
#define FIRMWARE_SIZE_H

#include "qvol.h"

/* Fills the camera; each program links one definition of it. */
qv_status size_camera(qv_camera *camera, const qv_volume *volume, const qv_view *view);

#endif /* FIRMWARE_SIZE_H */
