/*
 * downsample.h - the next coarser level of a volume in real numbers, from the declarations
 * of qvol.h alone.
 */
#ifndef REFERENCE_DOWNSAMPLE_H
#define REFERENCE_DOWNSAMPLE_H

#include "qvol.h"

/* What is averaged: the fourth channel, or the extinction of opacities. */
typedef enum ref_domain { REF_AVERAGE_STORED, REF_AVERAGE_EXTINCTION } ref_domain;

/* Voxel (at) of the next coarser level: colour (unweighted) and fourth channel in 0 .. 1,
   all 0 where nothing under the filter has any weight. The filter is given by its outer
   and inner taps. */
void ref_downsample(double rgba[4], const qv_volume *finer, const double filter[2],
                    ref_domain domain, const int32_t at[3]);

#endif /* REFERENCE_DOWNSAMPLE_H */
