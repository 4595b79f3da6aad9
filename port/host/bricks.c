/*
 * bricks.c - parts of a volume that are drawn one by one.
 */
#include "bricks.h"

#include <stdbool.h>

/* Of a qv_coord. */
#define VOXEL ((qv_coord)1 << 32)

/* Bricks differ by a voxel at most. */
static uint32_t first_voxel(const qv_volume *volume, unsigned axis, uint32_t count, uint32_t place)
{
    return (uint32_t)((uint64_t)volume->size[axis] * place / count);
}

/* The brick that the viewer is in, or nearest to, on an axis. From infinity he looks along the
   axis or against it. */
static uint32_t brick_of_viewer(const qv_scene *scene, unsigned axis, uint32_t count)
{
    const qv_camera *camera = &scene->camera;
    uint32_t place = 0;
    if (camera->projection == &qv_projection_orthographic) {
        return camera->along[axis] > 0 ? 0 : count - 1;
    }
    while (place + 1 < count &&
           first_voxel(&scene->volume, axis, count, place + 1) * VOXEL <= camera->origin[axis]) {
        place++;
    }
    return place;
}

/* From the one side up to the viewer, then from the other down to him. */
static uint32_t place_of(uint32_t turn, uint32_t viewer, uint32_t count)
{
    return turn < viewer ? turn : count - 1 - (turn - viewer);
}

/* The volume becomes a view of itself; with the origin moved, the samples stay. */
static void cut(qv_scene *scene, unsigned axis, uint32_t first, uint32_t end)
{
    qv_volume *volume = &scene->volume;
    volume->voxels += (qv_offset)first * volume->stride[axis];
    volume->size[axis] = (uint16_t)(end - first);
    scene->camera.origin[axis] -= first * VOXEL;
}

void brick_scene(qv_scene *brick, const qv_scene *whole, const uint32_t count[3], uint32_t number)
{
    *brick = *whole;
    for (unsigned axis = 0; axis < 3; axis++) {
        uint32_t viewer = brick_of_viewer(whole, axis, count[axis]);
        uint32_t place = place_of(number % count[axis], viewer, count[axis]);
        number /= count[axis];
        cut(brick, axis, first_voxel(&whole->volume, axis, count[axis], place),
            first_voxel(&whole->volume, axis, count[axis], place + 1));
    }
}
