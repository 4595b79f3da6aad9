#include "attenuation.h"

#include "reference.h"

#include <math.h>
#include <stdbool.h>

static const double most_depth = 64; /* of a voxel that is averaged */

void ref_direction_step(int step[3], int direction)
{
    const int number = direction < 13 ? direction : direction + 1;
    step[0] = number % 3 - 1;
    step[1] = number / 3 % 3 - 1;
    step[2] = number / 9 - 1;
}

static double spacing_of(const qv_volume *volume, int axis)
{
    return volume->spacing[axis] == 0 ? 1 : volume->spacing[axis] / 65536.0;
}

/* World length of a step. */
static double length_of(const qv_volume *volume, int direction)
{
    int step[3];
    double square = 0;
    ref_direction_step(step, direction);
    for (int axis = 0; axis < 3; axis++) {
        square += pow(step[axis] * spacing_of(volume, axis), 2);
    }
    return sqrt(square);
}

double ref_step_depth(const qv_volume *volume, int direction, const int32_t at[3])
{
    double rgba[4];
    ref_voxel(rgba, volume, at);
    if (!ref_holds_extinction(volume->storage) && volume->unit_distance == 0) {
        return ref_depth(rgba[3]);
    }
    return ref_extinction(rgba[3], volume) * length_of(volume, direction);
}

/* Moves on by a step of the direction. False where that leads outside. */
static bool go_on(int32_t at[3], const uint16_t size[3], int direction)
{
    int step[3];
    bool inside = true;
    ref_direction_step(step, direction);
    for (int axis = 0; axis < 3; axis++) {
        at[axis] += step[axis];
        inside = inside && at[axis] >= 0 && at[axis] < size[axis];
    }
    return inside;
}

double ref_outer_depth(const qv_volume *volume, int direction, const int32_t at[3])
{
    int32_t voxel[3] = {at[0], at[1], at[2]};
    double depth = 0;
    while (go_on(voxel, volume->size, direction)) {
        depth += ref_step_depth(volume, direction, voxel);
    }
    return depth;
}

static int64_t index_of(const uint16_t size[3], const int32_t at[3])
{
    return at[0] + (int64_t)size[0] * (at[1] + (int64_t)size[1] * at[2]);
}

static void position_of(int32_t at[3], const uint16_t size[3], int64_t index)
{
    at[0] = (int32_t)(index % size[0]);
    at[1] = (int32_t)(index / size[0] % size[1]);
    at[2] = (int32_t)(index / size[0] / size[1]);
}

/* By its outer neighbour, which comes first: one with a higher index for directions above 12. */
void ref_outer_depths(double *depths, const qv_volume *volume, int direction)
{
    const int64_t count = (int64_t)volume->size[0] * volume->size[1] * volume->size[2];
    for (int64_t i = 0; i < count; i++) {
        const int64_t index = direction > 12 ? count - 1 - i : i;
        int32_t outer[3];
        position_of(outer, volume->size, index);
        depths[index] = 0;
        if (go_on(outer, volume->size, direction)) {
            depths[index] =
                depths[index_of(volume->size, outer)] + ref_step_depth(volume, direction, outer);
        }
    }
}

static int32_t end_of(int32_t at, int level, int32_t size)
{
    const int32_t end = (at + 1) << level;
    return end < size ? end : size;
}

double ref_mean_depth(const double *depths, const uint16_t size[3], int level, const int32_t at[3])
{
    double sum = 0, count = 0;
    int32_t v[3];
    for (v[2] = at[2] << level; v[2] < end_of(at[2], level, size[2]); v[2]++) {
        for (v[1] = at[1] << level; v[1] < end_of(at[1], level, size[1]); v[1]++) {
            for (v[0] = at[0] << level; v[0] < end_of(at[0], level, size[0]); v[0]++) {
                sum += fmin(depths[index_of(size, v)], most_depth);
                count++;
            }
        }
    }
    return sum / count;
}

double ref_attenuation(double depth)
{
    return 255 * exp2(-depth);
}
