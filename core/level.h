/*
 * level.h - which levels of a pyramid a ray sees where, and how two are blended.
 *
 * A ray's pieces on level l are 2^l steps long; their borders are those borders between
 * the stretches of single steps that lie 2^l apart, from that of stretch 0 on. A point of
 * the volume lies at 2^-l of its coordinates on level l.
 */
#ifndef QV_LEVEL_H
#define QV_LEVEL_H

#include "stretch.h"

/* Of qv_scene.level_distance. */
#define QV_MOST_DISTANCE (((uint32_t)1 << 23) - 1u)

/* A part of a ray that sees one level, or two blended. */
typedef struct qv_span {
    int64_t end;     /* the position up to which */
    unsigned level;  /* the finer of the two */
    uint32_t octave; /* stretch from which the coarser comes in, all in at twice that; or 0 */
    uint32_t blend;  /* share of the coarser in the next piece, Q0.32; 0: it is not read */
    uint32_t rise;   /* of that share from piece to piece */
} qv_span;

/*
 * The span that a ray's next piece lies in. Everywhere qv_scene.level, where
 * level_distance is 0. With a distance D the level is the whole part of qv_scene.level up
 * to stretch D, and rises by o + (j - 2^o D) / (2^o D) at j from 2^o D to 2^(o+1) D. It
 * stops at the coarsest. j is where the middle of a piece lies, in steps from the border
 * of stretch 0; o is that of the stretch where the piece begins.
 */
void qv_span_begin(qv_span *span, const qv_ray *ray, const qv_scene *scene);

/* Sets the share of the coarser level, and its rise, for a run taken from the span. */
void qv_span_blend(qv_span *span, const qv_run *run);

/* Two neighbouring levels, and how they are blended. Size and strides follow from the number. */
typedef struct qv_levels {
    qv_address voxels[2];
    unsigned finer;       /* number of the first; QV_NO_LEVEL at the start */
    uint32_t blend, rise; /* of the span */
} qv_levels;

#define QV_NO_LEVEL 255u

/* Takes the next run off a ray in the span that it lies in, and finds the levels there. Returns 0
   where the ray is done. */
int qv_cut_run_of_levels(qv_levels *levels, qv_run *run, qv_ray *ray, const qv_scene *scene);

/* The same, and puts the ray there, as qv_next_run. */
FX_INLINE int qv_next_run_of_levels(qv_levels *levels, qv_run *run, qv_ray *ray,
                                    const qv_scene *scene)
{
    if (!qv_cut_run_of_levels(levels, run, ray, scene))
        return 0;
    qv_stand_on_run(ray, run, levels->finer);
    return 1;
}

/* Whether the scene has a pyramid, and the level is one of its. QV_OK, QV_ERROR_LEVEL or
   an error of qv_pyramid_check. */
qv_status qv_level_check(const qv_scene *scene);

#endif /* QV_LEVEL_H */
