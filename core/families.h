/*
 * families.h - the families of modes that weigh by length: how they sample, and what they
 * make of samples.
 */
#ifndef QV_FAMILIES_H
#define QV_FAMILIES_H

#include "bspline.h"
#include "correct.h"

/* Has what a mode reads at a ray's place in memory, before the mode has a stack frame. */
typedef void qv_bring(const qv_ray *ray, const qv_volume *volume);

typedef struct qv_family {
    qv_mode *mode;
    qv_model *under, *over;
    int gathers;     /* whether light is gathered beside qv_light */
    qv_bring *bring; /* null where voxels lie in memory */
} qv_family;

static const qv_family qv_family_corrected = {qv_sample_weighted, QV_MODEL(qv_corrected_under),
                                              QV_MODEL(qv_corrected_over), 0, 0};
static const qv_family qv_family_extinction = {qv_sample_weighted, QV_MODEL(qv_extinction_under),
                                               QV_MODEL(qv_extinction_over), 1, 0};
static const qv_family qv_family_converted = {qv_sample_converted, QV_MODEL(qv_extinction_under),
                                              QV_MODEL(qv_extinction_over), 1, 0};
static const qv_family qv_family_bspline_corrected = {
    qv_bspline_weighted, QV_MODEL(qv_corrected_under), QV_MODEL(qv_corrected_over), 0, 0};
static const qv_family qv_family_bspline_extinction = {
    qv_bspline_weighted, QV_MODEL(qv_extinction_under), QV_MODEL(qv_extinction_over), 1, 0};
static const qv_family qv_family_bspline_converted = {
    qv_bspline_converted, QV_MODEL(qv_extinction_under), QV_MODEL(qv_extinction_over), 1, 0};

#endif /* QV_FAMILIES_H */
