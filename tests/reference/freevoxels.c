#include "freevoxels.h"

#include "attenuation.h"

#include <math.h>
#include <stdlib.h>

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

/* ---- Bytes -------------------------------------------------------------------- */

static void level_size(int32_t size[3], const qv_volume *volume, int level)
{
    for (int axis = 0; axis < 3; axis++) {
        size[axis] = (volume->size[axis] + (1 << level) - 1) >> level;
    }
}

static uint8_t *byte_at(const ref_bytes *bytes, int level, const int32_t at[3])
{
    int32_t size[3];
    level_size(size, bytes->volume, level);
    return bytes->level[level][at[0] + size[0] * (at[1] + (int64_t)size[1] * at[2])];
}

/* The bytes of a level and direction, from the depths of the volume's voxels. */
static void fill_level(const ref_bytes *made, int level, int direction, const double *depths)
{
    int32_t size[3], at[3];
    level_size(size, made->volume, level);
    for (at[2] = 0; at[2] < size[2]; at[2]++) {
        for (at[1] = 0; at[1] < size[1]; at[1]++) {
            for (at[0] = 0; at[0] < size[0]; at[0]++) {
                const double depth = ref_mean_depth(depths, made->volume->size, level, at);
                byte_at(made, level, at)[direction] = (uint8_t)lround(ref_attenuation(depth));
            }
        }
    }
}

bool ref_bytes_make(ref_bytes *made, const qv_volume *volume, int coarsest)
{
    const ref_bytes none = {.volume = volume, .directions = QV_DIRECTIONS_ALL};
    const size_t voxels = (size_t)volume->size[0] * volume->size[1] * volume->size[2];
    double *depths = malloc(voxels * sizeof *depths);
    bool made_all = depths != NULL;
    *made = none;
    for (int level = 0; level <= coarsest; level++) {
        /* no level has more voxels than the volume */
        made->level[level] = malloc(voxels * sizeof *made->level[level]);
        made_all = made_all && made->level[level] != NULL;
    }
    for (int direction = 0; made_all && direction < (int)QV_DIRECTIONS; direction++) {
        ref_outer_depths(depths, volume, direction);
        for (int level = 0; level <= coarsest; level++) {
            fill_level(made, level, direction, depths);
        }
    }
    free(depths);
    return made_all;
}

void ref_bytes_free(ref_bytes *made)
{
    for (int level = 0; level < REF_LEVELS; level++) {
        free(made->level[level]);
        made->level[level] = NULL;
    }
}

/* ---- Depth from bytes --------------------------------------------------------- */

static double byte_depth(uint8_t byte)
{
    return byte == 0 ? HUGE_VAL : -log2(byte / 255.0);
}

/* Where opacities hold for a step of any direction, depths do not change with its length. */
static bool is_by_step(const qv_volume *volume)
{
    return !ref_holds_extinction(volume->storage) && volume->unit_distance == 0;
}

/* Depth along a step towards v, from the depths of the three directions round it. */
static double interpolate(const qv_volume *volume, const ref_surrounding *around,
                          const double depth[3], const double v[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        int step[3];
        ref_direction_step(step, around->direction[i]);
        const double along[3] = {step[0], step[1], step[2]};
        const double length = is_by_step(volume) ? 1 : ref_step_length(volume, along);
        sum += around->weight[i] > 0 ? around->weight[i] * depth[i] / length : 0;
    }
    return is_by_step(volume) ? sum : sum * ref_step_length(volume, v);
}

/* Of directions with a share, a byte of 0 counts as dark beside others; alone, all is dark. */
static void depths_around(double depth[3], const ref_surrounding *around, const uint8_t *bytes)
{
    bool dark = true;
    for (int i = 0; i < 3; i++) {
        dark = dark && (around->weight[i] == 0 || bytes[around->direction[i]] == 0);
    }
    for (int i = 0; i < 3; i++) {
        const double own = byte_depth(bytes[around->direction[i]]);
        depth[i] = dark ? HUGE_VAL : fmin(own, REF_DARK_DEPTH);
    }
}

/* The mean of what the bytes let through, each raised to the length of v's step, by their shares. */
static double depth_of_mean(const qv_volume *volume, const ref_surrounding *around,
                            const uint8_t *bytes, const double v[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        int step[3];
        ref_direction_step(step, around->direction[i]);
        const double along[3] = {step[0], step[1], step[2]};
        const double scale =
            is_by_step(volume) ? 1 : ref_step_length(volume, v) / ref_step_length(volume, along);
        const uint8_t byte = bytes[around->direction[i]];
        sum +=
            around->weight[i] > 0 && byte != 0 ? around->weight[i] * pow(byte / 255.0, scale) : 0;
    }
    return sum > 0 ? -log2(sum) : HUGE_VAL;
}

double ref_depth_of_bytes(const void *in, int level, const int32_t at[3], const double v[3])
{
    const ref_bytes *bytes = in;
    const qv_volume *volume = bytes->volume;
    const uint8_t *of = byte_at(bytes, level, at);
    ref_surrounding around;
    double depth[3];
    if (bytes->light == REF_LIGHT_NEAREST) {
        return byte_depth(of[ref_nearest_direction(volume, bytes->directions, v)]);
    }
    ref_surround(&around, v);
    if (bytes->light == REF_LIGHT_BETWEEN) {
        return depth_of_mean(volume, &around, of, v);
    }
    depths_around(depth, &around, of);
    return interpolate(volume, &around, depth, v);
}

/* ---- Depth between three directions, without bytes -------------------------------- */

bool ref_outside_make(ref_outside *made, const qv_volume *volume)
{
    const size_t voxels = (size_t)volume->size[0] * volume->size[1] * volume->size[2];
    double *depths = malloc(voxels * sizeof *depths);
    made->volume = volume;
    made->depth = malloc(voxels * sizeof *made->depth);
    const bool has_memory = depths != NULL && made->depth != NULL;
    for (int direction = 0; has_memory && direction < (int)QV_DIRECTIONS; direction++) {
        ref_outer_depths(depths, volume, direction);
        for (size_t i = 0; i < voxels; i++) {
            made->depth[i][direction] = depths[i];
        }
    }
    free(depths);
    return has_memory;
}

void ref_outside_free(ref_outside *made)
{
    free(made->depth);
    made->depth = NULL;
}

double ref_depth_between(const void *in, int level, const int32_t at[3], const double v[3])
{
    const ref_outside *outside = in;
    const uint16_t *size = outside->volume->size;
    const double *of = outside->depth[at[0] + size[0] * (at[1] + (int64_t)size[1] * at[2])];
    ref_surrounding around;
    double depth[3];
    (void)level;
    ref_surround(&around, v);
    for (int i = 0; i < 3; i++) {
        depth[i] = of[around.direction[i]];
    }
    return interpolate(outside->volume, &around, depth, v);
}
