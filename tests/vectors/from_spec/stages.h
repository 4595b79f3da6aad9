/*
 * stages.h - the stages of tests/vectors: how each row's results follow from its inputs.
 */
#ifndef STAGES_H
#define STAGES_H

#include "csv.h"
#include "number.h"

typedef void stage_function(csv *c);

/* Sections 3 to 11. */
stage_function stage_cell, stage_weights;

/* Sections 12 to 17. */
stage_function stage_sample8, stage_sample16, stage_separate8, stage_separate16;
stage_function stage_under, stage_over, stage_readout, stage_pixel;

/* Part C. */
stage_function stage_transmittance, stage_transmittance16;

/* Several fields, whose names end with their numbers. */
void in_all(csv *c, const char *name, number value[], unsigned count);
void out_all(csv *c, const char *name, const number value[], unsigned count);
triple in_triple(csv *c, const char *name);
void out_triple(csv *c, const char *name, const triple *value);

#endif /* STAGES_H */
