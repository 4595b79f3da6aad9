/*
 * firmware_size_orthographic.c - the smallest useful firmware.
 */
#include "firmware_size.h"

qv_status size_camera(qv_camera *camera, const qv_volume *volume, const qv_view *view)
{
    return qv_orthographic(camera, volume, view);
}
