/*
 * stages.h - the stages of tests/vectors: how each row's results follow from its inputs.
 */
#ifndef STAGES_H
#define STAGES_H

#include "csv.h"
#include "number.h"

typedef void stage_function(csv *c);

/* Section 2. */
stage_function stage_product, stage_scale, stage_quotient, stage_sine;
stage_function stage_root, stage_unorm;

/* Sections 8 to 11. */
stage_function stage_ray_orthographic, stage_ray_perspective, stage_clip, stage_cell;
stage_function stage_weights;

/* Sections 12 and 13. */
stage_function stage_sample8, stage_sample16, stage_separate8, stage_separate16;
stage_function stage_nearest;

/* Sections 14 to 17. */
stage_function stage_under, stage_over, stage_readout, stage_pixel;

/* Part B. */
stage_function stage_transfer, stage_index, stage_gradient, stage_shade;
stage_function stage_reduce;

/* Part C. */
stage_function stage_transmittance, stage_transmittance16, stage_depth, stage_extinction;
stage_function stage_reciprocal, stage_phi, stage_correct;

/* Parts D and E, and section 69. */
stage_function stage_recode, stage_least_extinction, stage_mixture, stage_downsample;
stage_function stage_associate;

/* Part F. */
stage_function stage_way, stage_piece, stage_medium, stage_bspline;
stage_function stage_bspline_sample, stage_converted8, stage_converted16, stage_corrected;
stage_function stage_extinction_under, stage_extinction_over, stage_level_blend;

/* Part G. */
stage_function stage_dither, stage_hits, stage_plateau, stage_alpha;
stage_function stage_slices, stage_slice_dither, stage_light, stage_blend_plain;
stage_function stage_blend_dithered, stage_blend24, stage_blend_front, stage_residual;
stage_function stage_replay;
stage_function stage_pixel_blend, stage_pixel_show;

/* Part H. */
stage_function stage_order, stage_attenuation, stage_length, stage_scaled;
stage_function stage_attenuate, stage_lamp;
stage_function stage_footprint, stage_splat_added, stage_splat_over;

/* Part I. */
stage_function stage_preweighted_under, stage_preweighted_over;

/* All of it, in pictures. */
stage_function stage_picture;

/* Several elements. */
stage_function stage_line, stage_palette, stage_coarser, stage_associated;

/* Several fields, whose names end with their numbers. */
void in_all(csv *c, const char *name, number value[], unsigned count);
void out_all(csv *c, const char *name, const number value[], unsigned count);
triple in_triple(csv *c, const char *name);
void out_triple(csv *c, const char *name, const triple *value);

#endif /* STAGES_H */
