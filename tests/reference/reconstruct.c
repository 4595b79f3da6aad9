#include "reference.h"

#include <math.h>

bool ref_is_by_length(ref_mode mode)
{
    return mode >= REF_CORRECTED;
}

bool ref_is_by_extinction(ref_mode mode)
{
    return mode == REF_EXTINCTION || mode == REF_BSPLINE_EXTINCTION;
}

static bool is_bspline(ref_mode mode)
{
    return mode == REF_BSPLINE_WEIGHTED || mode == REF_BSPLINE_EXTINCTION;
}

static int32_t clamp(double index, int32_t size)
{
    return (int32_t)fmax(0, fmin(index, size - 1));
}

/* The voxel that contains the point; a point rounded onto the upper face takes the last. */
static void nearest(double sample[4], const qv_volume *volume, const double point[3])
{
    int32_t at[3];
    for (int axis = 0; axis < 3; axis++) {
        at[axis] = clamp(floor(point[axis]), volume->size[axis]);
    }
    ref_voxel(sample, volume, at);
    for (int channel = 0; channel < 3; channel++) {
        sample[channel] *= sample[3];
    }
}

/* The two voxel centres on either side; beyond the outermost both are that one. */
void ref_linear_taps(ref_taps *taps, double point, int32_t size)
{
    const double place = point - 0.5, lower = floor(place);
    taps->count = 2;
    for (int i = 0; i < 2; i++) {
        taps->at[i] = clamp(lower + i, size);
    }
    taps->weight[0] = lower + 1 - place;
    taps->weight[1] = place - lower;
}

/* The nearest voxel centre and its neighbours, u away from the middle one (de Boor). */
void ref_bspline_taps(ref_taps *taps, double point, int32_t size)
{
    const double middle = floor(point), u = point - middle - 0.5;
    taps->count = 3;
    for (int i = 0; i < 3; i++) {
        taps->at[i] = clamp(middle + i - 1, size);
    }
    taps->weight[0] = (0.5 - u) * (0.5 - u) / 2;
    taps->weight[1] = 0.75 - u * u;
    taps->weight[2] = (0.5 + u) * (0.5 + u) / 2;
}

/* Adds a voxel: its fourth channel as the mode has it, and colour weighted or as it stands. */
static void add_voxel(double sum[4], const qv_volume *volume, ref_mode mode, const int32_t at[3],
                      double weight)
{
    double rgba[4];
    ref_voxel(rgba, volume, at);
    const double fourth = ref_is_by_extinction(mode) ? ref_extinction(rgba[3], volume) : rgba[3];
    const bool as_it_stands = mode == REF_SEPARATE || ref_is_associated(volume->storage);
    const double of_colour = as_it_stands ? 1 : fourth;
    for (int channel = 0; channel < 3; channel++) {
        sum[channel] += weight * of_colour * rgba[channel];
    }
    sum[3] += weight * fourth;
}

static void add_taps(double sum[4], const qv_volume *volume, ref_mode mode, const ref_taps taps[3])
{
    for (int z = 0; z < taps[2].count; z++) {
        for (int y = 0; y < taps[1].count; y++) {
            for (int x = 0; x < taps[0].count; x++) {
                const int32_t at[3] = {taps[0].at[x], taps[1].at[y], taps[2].at[z]};
                const double weight = taps[0].weight[x] * taps[1].weight[y] * taps[2].weight[z];
                add_voxel(sum, volume, mode, at, weight);
            }
        }
    }
}

void ref_reconstruct(double sample[4], const qv_volume *volume, ref_mode mode,
                     const double point[3])
{
    ref_taps taps[3];
    if (mode == REF_NEAREST) {
        nearest(sample, volume, point);
        return;
    }
    for (int axis = 0; axis < 3; axis++) {
        if (is_bspline(mode)) {
            ref_bspline_taps(&taps[axis], point[axis], volume->size[axis]);
        } else {
            ref_linear_taps(&taps[axis], point[axis], volume->size[axis]);
        }
    }
    for (int channel = 0; channel < 4; channel++) {
        sample[channel] = 0;
    }
    add_taps(sample, volume, mode, taps);
    for (int channel = 0; channel < 3; channel++) {
        sample[channel] *= mode == REF_SEPARATE ? sample[3] : 1;
    }
}
