/*
 * splat.h - where a voxel falls in the picture, and what it brings there.
 *
 * Voxels lie at (2 p + 1) 2^level - size on each axis, half voxels of level 0 from the centre of
 * the box: below 2^14. An eye sees what an orthographic view through the centre shows, enlarged by
 * the eye's distance from the centre over its distance from the voxel along the view.
 */
#ifndef QV_SPLAT_H
#define QV_SPLAT_H

#include "fx_scaled.h"
#include "fx_wide.h"
#include "qvol.h"

/* Numbers of a qv_splats with an exponent: width and height of a voxel in pixels at the distance
   of the centre; the gain of a voxel that is one layer of voxels and one world unit thick; the
   distance from the centre to the eye in world units. */
enum { QV_WIDTH = 0, QV_HEIGHT = 1, QV_GAIN = 2, QV_DISTANCE = 3 };

static inline fx_scaled qv_splats_number(const qv_splats *splats, unsigned which)
{
    fx_scaled number = {splats->mantissa[which], splats->exponent[which]};
    return number;
}

static inline void qv_splats_set(qv_splats *splats, unsigned which, fx_scaled number)
{
    splats->mantissa[which] = number.mantissa;
    splats->exponent[which] = number.exponent;
}

/* number * 2^level. */
static inline fx_scaled qv_scaled_up(fx_scaled number, unsigned level)
{
    number.exponent = (int16_t)(number.exponent + (int)level);
    return number;
}

/*
 * How far from the middle of the frame an eye sees voxels, in pixels, Q16.16: a width or height of
 * the frame, and the kernel of what is drawn at the distance of the volume's centre, or of the
 * widest voxel of coarser levels. At most 2^31 + 3 * 2^28.
 */
uint32_t qv_splats_reach(const qv_splats *splats, unsigned axis);

/* Whether a voxel of a level that is seen so much enlarged is at most as wide and high as the
   scene's detail allows. */
int qv_splats_fine(const qv_splats *splats, fx_scaled enlarged, unsigned level);

/* A voxel's place before the viewer. */
typedef struct qv_sight {
    int64_t x, y;           /* its centre in pixels, Q47.16; whole numbers are centres of pixels */
    uint32_t width, height; /* of the voxel in pixels, Q16.16 */
    uint32_t gain;          /* what full light of opacity 1 brings: 255 levels, Q10.22; at most
                               4 times that, which cubes pass from 76 degrees off the axis on */
    uint32_t length;        /* of a step towards the viewer, as part of the longest, Q1.31 */
    qv_bearing viewer;      /* which of its bytes count */
} qv_sight;

/* Half voxels from the centre of the box to a voxel. */
static inline void qv_half_voxels(int32_t half[3], const uint16_t size[3],
                                  const uint16_t position[3], unsigned level)
{
    for (unsigned axis = 0; axis < 3; axis++)
        half[axis] = (int32_t)((2u * position[axis] + 1u) << level) - size[axis];
}

/* Its sight; 0 where a voxel is not drawn, for its size or for lying behind the eye. */
int qv_sight_of(qv_sight *sight, const qv_splats *splats, const uint16_t position[3],
                unsigned level);

/* Whether a voxel belongs to what is drawn: neither it nor what it is part of is drawn as part of
   something coarser, nor is it itself too coarse. */
int qv_splat_belongs(const qv_splats *splats, const uint16_t position[3], unsigned level);

/* Adds a voxel whose position, memory and sums were checked. */
void qv_splat_put(const qv_sums *sums, const qv_splats *splats, const qv_freevoxel *voxel);

/* Whether the sums of a rectangle lie in the memory given. QV_OK, QV_ERROR_NULL, _RECT, _BUFFER. */
qv_status qv_sums_check(const qv_sums *sums);

#endif /* QV_SPLAT_H */
