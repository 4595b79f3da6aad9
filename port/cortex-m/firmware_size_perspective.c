/*
 * firmware_size_perspective.c - the same with a perspective camera.
 */
#include "firmware_size.h"

#define FIELD_OF_VIEW 0x20000000u /* 45 degrees */

qv_status size_camera(qv_camera *camera, const qv_volume *volume, const qv_view *view)
{
    return qv_perspective(camera, volume, view, FIELD_OF_VIEW);
}
