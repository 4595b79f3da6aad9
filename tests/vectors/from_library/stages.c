/*
 * stages.c - the stages, in the order of the manifest.
 */
#include "stages.h"

const vector_stage *const vector_stages[] = {&stage_cell,
                                             &stage_weights,
                                             &stage_sample8,
                                             &stage_sample16,
                                             &stage_separate8,
                                             &stage_separate16,
                                             &stage_under,
                                             &stage_over,
                                             &stage_readout,
                                             &stage_pixel,
                                             &stage_transmittance,
                                             &stage_transmittance16,
                                             NULL};
