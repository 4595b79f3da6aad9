/*
 * bearing.h - light that comes from anywhere, by the bytes of the directions round it.
 *
 * A vector v, in voxels, whose magnitudes on the axes are a >= b >= c, lies between three
 * directions: along the first axis, along the first two, along all three. As
 * v = (a - b) d1 + (b - c) d2 + c d3, a light that comes along v crosses a layer of voxels where
 * each of the three does. Each direction's depth D belongs to steps of its own length L, and is
 * scaled to the length of v's: in a homogeneous medium behind a face the three then agree. Their
 * transmittances, or their depths, are interpolated with these shares of a.
 */
#ifndef QV_BEARING_H
#define QV_BEARING_H

#include "fx_inline.h"
#include "fx_wide.h"
#include "access.h"
#include "qvol.h"

/* Unit of qv_bearing.scale, Q13.19; of shares it is 2^30. */
#define QV_BEARING_ONE 0x80000u

/* Depth of a byte of 0 between others that are not, Q8.24: 10, a quarter of a byte's step. */
#define QV_HIDDEN ((uint32_t)10 << 24)

/* Prepares what bearings in a volume of this spacing have in common. */
void qv_compass_of(qv_compass *compass, const qv_volume *volume, uint32_t directions,
                   uint8_t interpolation);

/*
 * The bearing of v, whose largest magnitude is 2^30 .. 2^31 - 1. Sets length to that of a step
 * along it, as part of the longest, Q1.31. QV_OK, or QV_ERROR_DIRECTION where a direction with a
 * share is not in the set, or the nearest is more than 60 degrees off.
 */
qv_status qv_bearing_of(qv_bearing *bearing, uint32_t *length, const qv_compass *compass,
                        const int32_t v[3]);

/* The directions, of all 26, that have a share in some vector between four corners: those, and
   perhaps a few more. */
uint32_t qv_bearing_reach(int32_t corner[4][3]);

/* The directions of a set that may be the nearest to some vector between four corners: those less
   than 90 degrees from one of them. */
uint32_t qv_bearing_facing(const qv_compass *compass, int32_t corner[4][3]);

/*
 * Transmittance along a bearing for a voxel with these bytes, Q0.32 with 2^32 - 1 for 1. `inside`:
 * null, or the bytes of the voxel up to which light is followed (section 3.3: A_B / A_V, at most
 * 1). Of one direction it is the byte itself; between light within 2^-18, from fx_reciprocal in
 * shares and the bits of scales, and between depths within 2^-13, as a scale may be that of a
 * depth of 10; inside, by 1 / A_V as much.
 */
uint32_t qv_bearing_transmittance(const qv_bearing *bearing, qv_address bytes, qv_address inside);

/* Whether v leads anywhere. Rows of a view that are almost a rotation may put a voxel, or a corner
   of the frame, at the eye. */
static inline int qv_bearing_leads(const int64_t v[3])
{
    return (v[0] | v[1] | v[2]) != 0;
}

/* v, halved or doubled until its largest magnitude is 2^30 .. 2^31 - 1; how often it was halved
   (or, negative, doubled). v is not 0. */
int qv_bearing_scale(int32_t scaled[3], const int64_t v[3]);

/* The largest magnitude of the components. */
static inline uint32_t qv_bearing_largest(const int32_t v[3])
{
    uint32_t largest = 0;
    for (unsigned axis = 0; axis < 3; axis++)
        largest = fx_magnitude(v[axis]) > largest ? fx_magnitude(v[axis]) : largest;
    return largest;
}

/* A world vector, below 2^63 in magnitude, in voxels of this spacing, cut towards 0: numbers with
   16 fraction bits fewer. */
void qv_bearing_voxels(int64_t v[3], const int64_t world[3], const uint32_t spacing[3]);

#endif /* QV_BEARING_H */
