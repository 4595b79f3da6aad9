/*
 * level.h - which level of a pyramid a ray sees where.
 */
#ifndef QV_LEVEL_H
#define QV_LEVEL_H

#include "stretch.h"

/* A part of a ray that sees one level, or two blended. */
typedef struct qv_span {
    int64_t end;    /* position where it ends at the latest */
    unsigned level; /* the finer of the two */
    uint32_t blend; /* share of the coarser at the ray's next piece, Q0.32; 0: none */
    uint32_t rise;  /* of the share from piece to piece */
} qv_span;

/*
 * The span that a ray's next piece lies in. With qv_scene.level_distance J, the level at
 * stretch j of the ray is, counted from the whole part of qv_scene.level, 0 where j < J and
 * o + (j - J 2^o) / (J 2^o) where J 2^o <= j < J 2^(o + 1); at most the coarsest. j is that
 * of the piece's middle, except that o is that of its beginning.
 */
void qv_span_begin(qv_span *span, const qv_ray *ray, const qv_scene *scene);

/* The share of the coarser level at the middle of the run that was taken from the span. */
void qv_span_blend(qv_span *span, const qv_run *run, int64_t begin, const qv_scene *scene);

/* Whether the scene has a pyramid, and the level is one of it. QV_OK, or an error of
   qv_pyramid_check, QV_ERROR_LEVEL. */
qv_status qv_level_check(const qv_scene *scene);

#endif /* QV_LEVEL_H */
