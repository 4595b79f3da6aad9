#include "freevoxels.h"

#include "attenuation.h"

#include <math.h>

static double spacing_of(const qv_volume *volume, int axis)
{
    return volume->spacing[axis] == 0 ? 1 : volume->spacing[axis] / 65536.0;
}

/* ---- Directions ----------------------------------------------------------- */

double ref_step_length(const qv_volume *volume, const double v[3])
{
    double square = 0, longest = 0;
    for (int axis = 0; axis < 3; axis++) {
        square += pow(v[axis] * spacing_of(volume, axis), 2);
        longest = fmax(longest, fabs(v[axis]));
    }
    return sqrt(square) / longest;
}

/* By qvol.h's count, in which the voxel itself has no place. */
static int direction_of(const int step[3])
{
    const int middle = 13, number = (step[0] + 1) + 3 * (step[1] + 1) + 9 * (step[2] + 1);
    return number < middle ? number : number - 1;
}

/* The axes by the magnitude of v, largest first. */
static void sort_axes(int axes[3], const double v[3])
{
    for (int axis = 0; axis < 3; axis++) {
        int place = axis;
        for (; place > 0 && fabs(v[axes[place - 1]]) < fabs(v[axis]); place--) {
            axes[place] = axes[place - 1];
        }
        axes[place] = axis;
    }
}

/*
 * v / m1 lies on a face of the cube of all directions, in the triangle between the face's
 * middle, the middle of an edge and a corner: the weights are its barycentric coordinates.
 */
void ref_surround(ref_surrounding *found, const double v[3])
{
    int axes[3], step[3] = {0, 0, 0};
    sort_axes(axes, v);
    const double m[4] = {fabs(v[axes[0]]), fabs(v[axes[1]]), fabs(v[axes[2]]), 0};
    for (int i = 0; i < 3; i++) {
        step[axes[i]] = v[axes[i]] < 0 ? -1 : 1;
        found->direction[i] = direction_of(step);
        found->weight[i] = (m[i] - m[i + 1]) / m[0];
    }
}

int ref_nearest_direction(const qv_volume *volume, uint32_t directions, const double v[3])
{
    int nearest = -1;
    double most = -HUGE_VAL;
    for (int direction = 0; direction < (int)QV_DIRECTIONS; direction++) {
        int step[3];
        double along = 0, square = 0;
        ref_direction_step(step, direction);
        for (int axis = 0; axis < 3; axis++) {
            const double component = step[axis] * spacing_of(volume, axis);
            along += component * v[axis] * spacing_of(volume, axis);
            square += component * component;
        }
        const double cosine = along / sqrt(square); /* times the length of v */
        if ((directions >> direction & 1u) != 0 && cosine > most) {
            most = cosine;
            nearest = direction;
        }
    }
    return nearest;
}

/* ---- Depth from bytes --------------------------------------------------------- */

static const uint8_t *bytes_of(const ref_bytes *bytes, int level, const int32_t at[3])
{
    int64_t size[2];
    for (int axis = 0; axis < 2; axis++) {
        size[axis] = (bytes->volume->size[axis] + (1 << level) - 1) >> level;
    }
    return bytes->level[level][at[0] + size[0] * (at[1] + size[1] * at[2])];
}

static double byte_depth(uint8_t byte)
{
    return byte == 0 ? REF_DARK_DEPTH : -log2(byte / 255.0);
}

/* The same in a set's nearest direction, as published: the light is the byte's own. */
static double nearest_depth(const ref_bytes *bytes, const uint8_t *of, const double v[3])
{
    const uint8_t byte = of[ref_nearest_direction(bytes->volume, bytes->directions, v)];
    return byte == 0 ? HUGE_VAL : byte_depth(byte);
}

/* Where opacities hold for a step of any direction, so do depths. */
static double depth_per_length(const qv_volume *volume, int direction, double depth)
{
    int step[3];
    ref_direction_step(step, direction);
    const double v[3] = {step[0], step[1], step[2]};
    const bool by_step = !ref_holds_extinction(volume->storage) && volume->unit_distance == 0;
    return by_step ? depth : depth / ref_step_length(volume, v);
}

double ref_depth_of_bytes(const void *in, int level, const int32_t at[3], const double v[3])
{
    const ref_bytes *bytes = in;
    const uint8_t *of = bytes_of(bytes, level, at);
    const qv_volume *volume = bytes->volume;
    const bool by_step = !ref_holds_extinction(volume->storage) && volume->unit_distance == 0;
    ref_surrounding around;
    double sum = 0;
    if (bytes->nearest) {
        return nearest_depth(bytes, of, v);
    }
    ref_surround(&around, v);
    for (int i = 0; i < 3; i++) {
        const double depth = byte_depth(of[around.direction[i]]);
        sum += around.weight[i] * depth_per_length(volume, around.direction[i], depth);
    }
    return by_step ? sum : sum * ref_step_length(volume, v);
}
