/*
 * stages.h - every stage; a file holds a group of them.
 */
#ifndef VECTORS_STAGES_H
#define VECTORS_STAGES_H

#include "vector.h"

/* stages_fixed.c */
extern const vector_stage stage_product, stage_scale, stage_quotient, stage_sine, stage_root,
    stage_unorm;

/* stages_ray.c */
extern const vector_stage stage_ray_orthographic, stage_ray_perspective;

/* stages_box.c */
extern const vector_stage stage_clip, stage_way, stage_piece;

/* stages_cell.c */
extern const vector_stage stage_cell;

/* stages_sample.c */
extern const vector_stage stage_weights, stage_sample8, stage_sample16, stage_separate8,
    stage_separate16;

/* stages_reconstruct.c */
extern const vector_stage stage_nearest, stage_bspline, stage_bspline_sample, stage_converted8,
    stage_converted16;

/* stages_light.c */
extern const vector_stage stage_under, stage_over, stage_readout;

/* stages_pixel.c */
extern const vector_stage stage_pixel;

/* stages_scalar.c */
extern const vector_stage stage_transfer, stage_index, stage_reduce;

/* stages_shade.c */
extern const vector_stage stage_gradient, stage_shade;

/* stages_depth.c */
extern const vector_stage stage_transmittance, stage_transmittance16;

/* stages_extinction.c */
extern const vector_stage stage_depth, stage_extinction, stage_reciprocal, stage_phi, stage_correct,
    stage_slices;

/* stages_entry.c */
extern const vector_stage stage_recode, stage_least_extinction, stage_mixture, stage_downsample,
    stage_associate;

/* stages_medium.c */
extern const vector_stage stage_medium;

/* stages_length.c */
extern const vector_stage stage_corrected, stage_extinction_under, stage_extinction_over,
    stage_level_blend;

/* stages_dither.c */
extern const vector_stage stage_dither, stage_hits, stage_plateau, stage_alpha, stage_slice_dither;

/* stages_blend.c */
extern const vector_stage stage_light, stage_blend_plain, stage_blend_dithered, stage_blend24;

/* stages_front.c */
extern const vector_stage stage_blend_front, stage_residual, stage_replay;

/* stages_buffer.c */
extern const vector_stage stage_pixel_blend, stage_pixel_show;

/* stages_freevoxel.c */
extern const vector_stage stage_order, stage_attenuation;

/* stages_lamp.c */
extern const vector_stage stage_attenuate, stage_lamp;

/* stages_splat.c */
extern const vector_stage stage_length, stage_scaled, stage_footprint, stage_splat_added,
    stage_splat_over;

/* stages_preweighted.c */
extern const vector_stage stage_preweighted_under, stage_preweighted_over;

/* stages_picture.c */
extern const vector_stage stage_picture;

/* stages_several.c */
extern const vector_stage stage_line, stage_palette, stage_coarser, stage_associated;

#endif
