/*
 * mapper.c - what 15 bits make of a picture: weights, samples, light and transmittance as in
 * VTK's vtkFixedPointVolumeRayCastMapper, of its source; opacity and colour tables of 15 bits.
 *
 * There 32767 is 1, the complement of a number is its 15 bits inverted, and products are divided
 * by 32768: weights are rounded, samples and what is composited rounded up. Rays end where less
 * than 255 of 32768 gets through.
 */
#include "pictures.h"

#include <math.h>
#include <stdlib.h>

enum { shift = 15, one = (1 << shift) - 1, half = 1 << (shift - 1), opaque = 255 };

static uint32_t up(uint32_t product)
{
    return (product + one) >> shift;
}

static uint32_t nearest(uint32_t product)
{
    return (product + half) >> shift;
}

typedef struct mapper_cell {
    size_t corner[8];
    uint32_t weight[8];
} mapper_cell;

static void find_cell(mapper_cell *found, const qv_volume *volume, const double point[3])
{
    const uint16_t *size = volume->size;
    size_t at[3][2];
    uint32_t w[3][2];
    for (int axis = 0; axis < 3; axis++) {
        const double place = floor((point[axis] - 0.5) * (one + 1) + 0.5) / (one + 1);
        const double lower = floor(place);
        for (int side = 0; side < 2; side++) {
            at[axis][side] = (size_t)fmax(0, fmin(lower + side, size[axis] - 1));
        }
        w[axis][1] = (uint32_t)((place - lower) * (one + 1));
        w[axis][0] = one - w[axis][1];
    }
    for (unsigned q = 0; q < 8; q++) {
        const unsigned x = q & 1, y = q >> 1 & 1, z = q >> 2;
        found->corner[q] = at[0][x] + size[0] * (at[1][y] + size[1] * at[2][z]);
        found->weight[q] = nearest(nearest(w[0][x] * w[1][y]) * w[2][z]);
    }
}

/* Weights sum to at most 32767 or so, and so does a sample: the sum is below 2^31. */
static void sample(uint32_t rgba[4], const mapper_cell *at, stored_voxels voxels)
{
    for (int channel = 0; channel < 4; channel++) {
        uint32_t sum = 0;
        for (unsigned q = 0; q < 8; q++) {
            sum += at->weight[q] * (uint32_t)voxels[at->corner[q]][channel];
        }
        rgba[channel] = up(sum);
    }
}

static void march(double rgba[4], const ref_ray *ray, const qv_volume *volume, stored_voxels voxels,
                  bool associated)
{
    uint32_t light[3] = {0, 0, 0}, remaining = one, of_sample[4];
    for (int64_t k = 0; k < ray->count && remaining >= opaque; k++) {
        double point[3];
        mapper_cell at;
        ref_point(point, ray, (double)k);
        find_cell(&at, volume, point);
        sample(of_sample, &at, voxels);
        for (int channel = 0; channel < 3 && of_sample[3] != 0; channel++) {
            const uint32_t colour =
                associated ? of_sample[channel] : up(of_sample[channel] * of_sample[3]);
            light[channel] += up(colour * remaining);
        }
        remaining = up(remaining * (one - of_sample[3]));
    }
    for (int channel = 0; channel < 3; channel++) {
        rgba[channel] = fmin(light[channel] / (double)one, 1);
    }
    rgba[3] = (one - remaining) / (double)one;
}

void mapper_picture(paper_picture *made, const picture_scene *scene, bool associated)
{
    const store by = {"15 bits", STORE_UNORM, shift, associated};
    stored_voxels voxels = store_make(scene, &by);
    paper_picture_make(made, scene->edge, scene->edge);
    for (int32_t y = 0; y < scene->edge; y++) {
        for (int32_t x = 0; x < scene->edge; x++) {
            ref_ray ray;
            ref_stored_ray(&ray, &scene->scene, x, y);
            march(made->rgba[y * scene->edge + x], &ray, &scene->scene.volume, voxels, associated);
        }
    }
    free(voxels);
}
