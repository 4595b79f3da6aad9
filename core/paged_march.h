/*
 * paged_march.h - the sampling modes through pages, defined as the others are.
 */
#ifndef QV_PAGED_MARCH_H
#define QV_PAGED_MARCH_H

#include "march.h"
#include "march_lengths.h"
#include "medium.h"
#include "paged.h"

/* Voxels on an axis that a sample reads. */
#define QV_LINEAR_TAPS 2u
#define QV_SPLINE_TAPS 3u

/* What modes that know no lengths make of a scene, and what others do. */
qv_status qv_prepare_steps_paged(qv_context *context, const qv_scene *scene);

typedef qv_status qv_medium_of(qv_medium *medium, const qv_scene *scene, unsigned levels);

static inline qv_status qv_prepare_paged(qv_context *context, const qv_scene *scene,
                                         qv_medium_of *medium, unsigned taps)
{
    qv_status status = qv_pages_check(&scene->volume, taps);
    return status == QV_OK ? medium(&context->medium, scene, 0) : status;
}

#define QV_DEFINE_STEPS_PAGED(mode, suffix, read_out, storage)                                     \
    QV_DEFINE_SAMPLING(mode, suffix##_paged, qv_prepare_steps_paged, qv_take_paged_##mode,         \
                       read_out, storage)

/* The file that uses it defines the function that prepares a context. */
#define QV_DEFINE_LENGTHS_PAGED(mode, suffix, kind, family, read_out, storage)                     \
    QV_DEFINE_BY_LENGTH(mode, suffix##_paged, prepare_##mode##_##kind, family, read_out, storage)

/* Of the storages that a list names, those whose voxels may lie in pages. */
#define QV_EACH_PAGED_STEPS(mode)                                                                  \
    QV_PAGED_ENTRIES(QV_STEPS_ENTRIES(QV_DEFINE_STEPS_PAGED, mode))                                \
    QV_STEPS_INDEXED(QV_DEFINE_STEPS_PAGED, mode)
#define QV_EACH_PAGED(KIND, mode, family)                                                          \
    QV_PAGED_ENTRIES(QV_##KIND##_ENTRIES(QV_DEFINE_LENGTHS_PAGED, mode, family))                   \
    QV_##KIND##_INDEXED(QV_DEFINE_LENGTHS_PAGED, mode, family)

#endif /* QV_PAGED_MARCH_H */
