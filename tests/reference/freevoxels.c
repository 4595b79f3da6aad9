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

/* ---- Depth between three directions ----------------------------------------------- */

/* Where opacities hold for a step of any direction, depths do not change with its length. */
static double scale_to(const qv_volume *volume, int direction, const double v[3])
{
    int step[3];
    ref_direction_step(step, direction);
    const double along[3] = {step[0], step[1], step[2]};
    const bool by_step = !ref_holds_extinction(volume->storage) && volume->unit_distance == 0;
    return by_step ? 1 : ref_step_length(volume, v) / ref_step_length(volume, along);
}

/* The three directions round v, and the depth of each for steps as long as v's. */
typedef struct triangle {
    ref_surrounding around;
    double depth[3];
} triangle;

static double between_depths(const triangle *of)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += of->around.weight[i] > 0 ? of->around.weight[i] * of->depth[i] : 0;
    }
    return sum;
}

static double between_light(const triangle *of)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += of->around.weight[i] * exp2(-of->depth[i]);
    }
    return -log2(sum);
}

/* ---- Depth from bytes --------------------------------------------------------- */

static double byte_depth(uint8_t byte)
{
    return byte == 0 ? HUGE_VAL : -log2(byte / 255.0);
}

/* Whether nothing passes in any direction that has a share. */
static bool all_dark(const ref_surrounding *around, const uint8_t *bytes)
{
    bool dark = true;
    for (int i = 0; i < 3; i++) {
        dark = dark && (around->weight[i] == 0 || bytes[around->direction[i]] == 0);
    }
    return dark;
}

double ref_depth_of_bytes(const void *in, int level, const int32_t at[3], const double v[3])
{
    const ref_bytes *bytes = in;
    const qv_volume *volume = bytes->volume;
    const uint8_t *of = byte_at(bytes, level, at);
    triangle found;
    if (bytes->light == REF_LIGHT_NEAREST) {
        const int direction = ref_nearest_direction(volume, bytes->directions, v);
        return byte_depth(of[direction]) * scale_to(volume, direction, v);
    }
    ref_surround(&found.around, v);
    if (all_dark(&found.around, of)) {
        return HUGE_VAL;
    }
    for (int i = 0; i < 3; i++) {
        const int direction = found.around.direction[i];
        const double own = byte_depth(of[direction]);
        const double counts = bytes->light == REF_LIGHT_DEPTHS ? fmin(own, REF_DARK_DEPTH) : own;
        found.depth[i] = counts * scale_to(volume, direction, v);
    }
    return bytes->light == REF_LIGHT_DEPTHS ? between_depths(&found) : between_light(&found);
}

/* ---- Depth without bytes ---------------------------------------------------------- */

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
    triangle found;
    (void)level;
    ref_surround(&found.around, v);
    for (int i = 0; i < 3; i++) {
        const int direction = found.around.direction[i];
        found.depth[i] = of[direction] * scale_to(outside->volume, direction, v);
    }
    return between_light(&found);
}
