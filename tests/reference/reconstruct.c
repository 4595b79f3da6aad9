#include "reference.h"

#include <math.h>

void ref_weights(double weight[8], const double fraction[3])
{
    for (int corner = 0; corner < 8; corner++) {
        weight[corner] = 1;
        for (int axis = 0; axis < 3; axis++) {
            const bool upper = (corner >> axis & 1) != 0;
            weight[corner] *= upper ? fraction[axis] : 1 - fraction[axis];
        }
    }
}

/* The voxel that contains the point; a point rounded onto the upper face takes the last. */
static void nearest(double sample[4], const qv_volume *volume, const double point[3])
{
    int32_t at[3];
    for (int axis = 0; axis < 3; axis++) {
        at[axis] = (int32_t)fmin(floor(point[axis]), volume->size[axis] - 1);
    }
    ref_voxel(sample, volume, at);
    for (int channel = 0; channel < 3; channel++) {
        sample[channel] *= sample[3];
    }
}

/* The cell between eight voxel centres and the position in it, clamped to the centres. */
static void locate(int32_t cell[3], double fraction[3], const qv_volume *volume,
                   const double point[3])
{
    for (int axis = 0; axis < 3; axis++) {
        const double last = volume->size[axis] - 1;
        const double position = fmax(0, fmin(point[axis] - 0.5, last));
        cell[axis] = (int32_t)floor(position);
        fraction[axis] = position - cell[axis];
    }
}

static void corner_voxel(double rgba[4], const qv_volume *volume, const int32_t cell[3], int corner)
{
    int32_t at[3];
    for (int axis = 0; axis < 3; axis++) {
        const int32_t next = cell[axis] + (corner >> axis & 1);
        at[axis] = next < volume->size[axis] ? next : cell[axis];
    }
    ref_voxel(rgba, volume, at);
}

/* Trilinear sums: opacity, and colour either as it stands or weighted by the voxel's opacity. */
static void trilinear(double sum[4], const qv_volume *volume, bool weighted, const double point[3])
{
    int32_t cell[3];
    double fraction[3], weight[8], rgba[4];
    locate(cell, fraction, volume, point);
    ref_weights(weight, fraction);
    for (int channel = 0; channel < 4; channel++) {
        sum[channel] = 0;
    }
    for (int corner = 0; corner < 8; corner++) {
        corner_voxel(rgba, volume, cell, corner);
        const double part = weighted ? weight[corner] * rgba[3] : weight[corner];
        for (int channel = 0; channel < 3; channel++) {
            sum[channel] += part * rgba[channel];
        }
        sum[3] += weight[corner] * rgba[3];
    }
}

void ref_reconstruct(double sample[4], const qv_volume *volume, ref_mode mode,
                     const double point[3])
{
    if (mode == REF_NEAREST) {
        nearest(sample, volume, point);
        return;
    }
    trilinear(sample, volume, mode == REF_WEIGHTED, point);
    if (mode == REF_SEPARATE) {
        for (int channel = 0; channel < 3; channel++) {
            sample[channel] *= sample[3];
        }
    }
}
