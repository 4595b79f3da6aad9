/*
 * stretch.h - a ray's way through the box, cut into pieces that know their length.
 *
 * Positions t on a ray are counted in steps from sample 0, with 24 fraction bits.
 * The stretch of sample k reaches from k - 1/2 to k + 1/2. Positions where a ray
 * enters and leaves are even, so that every piece has a middle.
 */
#ifndef QV_STRETCH_H
#define QV_STRETCH_H

#include "ray.h"

#define QV_STEP_BITS 24u
#define QV_STEP      ((int64_t)1 << QV_STEP_BITS)
#define QV_HALF_STEP (QV_STEP / 2)

/* Pieces of equal length that follow each other. */
typedef struct qv_run {
    qv_coord origin[3]; /* the ray's place as its projection made it */
    int64_t middle;     /* of the first piece, a position */
    uint32_t samples;   /* pieces that remain */
    uint32_t length;    /* of each, in steps of the volume, Q16.16 */
} qv_run;

/* What comes before the first run of a ray that was clipped: it stands where it was made. */
static inline void qv_run_begin(qv_run *run, const qv_ray *ray)
{
    for (unsigned axis = 0; axis < 3; axis++)
        run->origin[axis] = ray->place[axis];
}

/* The number of the stretch that a position lies in. */
int32_t qv_stretch_of(int64_t position);

/* Where the way of a ray may begin, as its projection made it: at the eye, if it has one. */
int64_t qv_path_begin(const qv_ray *ray, const qv_scene *scene);

/*
 * Finds enter and leave of a ray: the way through the box of the scene's volume, in
 * perspective from the eye on, of one slice within its borders. place stays. all and samples
 * count the pieces, 0 where the ray misses.
 * enter and leave are cut to 2^-23 step towards sample 0.
 */
void qv_path_clip(qv_ray *ray, const qv_context *context);

/* Takes the next run off a ray, whose place stays. As qv_next_run. */
int qv_cut_run(qv_run *run, qv_ray *ray, int64_t end, unsigned level);

/* Puts a ray to the middle of a run's first piece, in voxels of the level. */
void qv_stand_on_run(qv_ray *ray, const qv_run *run, unsigned level);

/*
 * Takes the next run off a ray, up to the position `end` at most: one piece up to the
 * next border, or all whole stretches that follow. Returns 0 where the ray is done.
 * The ray's place becomes the middle of its first piece, in voxels of the level, whose stretches
 * are 2^level steps long. Two steps, one after the other: the stack holds one of them at a time.
 */
FX_INLINE int qv_next_run(qv_run *run, qv_ray *ray, int64_t end, unsigned level)
{
    if (!qv_cut_run(run, ray, end, level))
        return 0;
    qv_stand_on_run(ray, run, level);
    return 1;
}

/* Turns a ray round, for level 0: what it leaves last, it enters first. */
void qv_path_reverse(qv_ray *ray);

#endif /* QV_STRETCH_H */
