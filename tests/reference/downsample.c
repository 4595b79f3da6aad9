#include "downsample.h"

#include "reference.h"

#include <math.h>

static const double full_depth = 64; /* of full opacity */

/* Index of a voxel of the volume that repeats itself mirrored in its faces without end. */
static int32_t reflected(int32_t at, int32_t size)
{
    const int32_t place = (at % (2 * size) + 2 * size) % (2 * size);
    return place < size ? place : 2 * size - 1 - place;
}

static double weight_of(double channel, ref_domain domain)
{
    if (domain == REF_AVERAGE_STORED) {
        return channel;
    }
    return channel == 1 ? full_depth : -log1p(-channel) / log(2);
}

static double channel_of(double weight, ref_domain domain)
{
    return domain == REF_AVERAGE_STORED ? weight : -expm1(-weight * log(2));
}

/* The share of tap (i, j, k), each 0 .. 3. */
static double share_of(const double filter[2], const int32_t tap[3])
{
    double share = 1;
    for (int axis = 0; axis < 3; axis++) {
        share *= tap[axis] == 1 || tap[axis] == 2 ? filter[1] : filter[0];
    }
    return share;
}

/* Adds a tap's weight, and its colours times the weight. */
static void add_tap(double sum[4], const qv_volume *finer, const double filter[2],
                    ref_domain domain, const int32_t at[3], const int32_t tap[3])
{
    double rgba[4];
    int32_t voxel[3];
    for (int axis = 0; axis < 3; axis++) {
        voxel[axis] = reflected(2 * at[axis] - 1 + tap[axis], finer->size[axis]);
    }
    ref_voxel(rgba, finer, voxel);
    const double weight = share_of(filter, tap) * weight_of(rgba[3], domain);
    for (int c = 0; c < 3; c++) {
        sum[c] += weight * rgba[c];
    }
    sum[3] += weight;
}

void ref_downsample(double rgba[4], const qv_volume *finer, const double filter[2],
                    ref_domain domain, const int32_t at[3])
{
    double sum[4] = {0, 0, 0, 0};
    for (int32_t i = 0; i < 64; i++) {
        const int32_t tap[3] = {i % 4, i / 4 % 4, i / 16};
        add_tap(sum, finer, filter, domain, at, tap);
    }
    for (int c = 0; c < 3; c++) {
        rgba[c] = sum[3] == 0 ? 0 : sum[c] / sum[3];
    }
    rgba[3] = channel_of(sum[3], domain);
}
