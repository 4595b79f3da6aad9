/*
 * stages.h - every stage, a file for each group of them.
 */
#ifndef VECTORS_STAGES_H
#define VECTORS_STAGES_H

#include "vector.h"

extern const vector_stage stage_weights, stage_sample8, stage_sample16, stage_separate8,
    stage_separate16;
extern const vector_stage stage_under, stage_over, stage_readout, stage_pixel;
extern const vector_stage stage_transmittance, stage_transmittance16;
extern const vector_stage stage_cell;

#endif
