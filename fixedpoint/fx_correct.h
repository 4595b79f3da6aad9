/*
 * fx_correct.h - opacity for another distance than the one it was stored for.
 *
 * Kraus and Buerger 2008, equations 16 and 17, without a division: by the optical
 * depth of the opacity, which a distance multiplies. Ratios are of the new distance
 * to the stored one, Q16.16.
 */
#ifndef FX_CORRECT_H
#define FX_CORRECT_H

#include "fx_exp.h"

#define FX_RATIO_LEAST    4096u    /* 1/16 */
#define FX_RATIO_GREATEST 1048576u /* 16 */

/* depth * ratio, cut to Q32.32: for every ratio, Q16.16, and products below 2^32. */
fx_depth fx_depth_scale(fx_depth depth, uint32_t ratio);

/* depth * ratio, cut to Q32.32: for a ratio in Q32.32 and products below 2^32. Never more
   than the product, and less by less than 2^-32. */
fx_depth fx_depth_times(fx_depth depth, uint64_t ratio);

/*
 * phi(scaled) / phi(depth), Q5.27, for depths below 23: times their ratio it is what
 * opacity-weighted colour is to be multiplied by. Error at most .4 * 2^-16 of the result.
 */
uint32_t fx_phi_share(fx_depth depth, fx_depth scaled);

/*
 * 1 - (1 - opacity)^ratio, for every ratio. Exactly the opacity for ratio 1; 0 and
 * 65535 stay what they are: full opacity has no finite depth here. Never falls as
 * the opacity or the ratio rises. Error at most .505 of 1/65535 for ratios of 1/16 ..
 * 16.
 */
fx_unorm16 fx_correct_opacity(fx_unorm16 opacity, uint32_t ratio);

/*
 * What opacity-weighted colour is to be multiplied by: corrected by stored opacity,
 * from the ratio (at opacity 0) to 1 (at 65535). Q5.27, for ratios of 1/16 .. 16.
 * Error at most .5 * 2^-16, and at most .4 * 2^-16 of the result.
 */
uint32_t fx_correct_colour(fx_unorm16 opacity, uint32_t ratio);

/*
 * Equation 3 of Williams et al.: the opacity, Q0.32, of each of `wanted` slices in place of
 * `slices`, 1 - (1 - opacity)^(slices / wanted). slices 1 .. 65535, wanted 1 .. 2^31 - 1. Exactly
 * the opacity for as many slices; 0 and 2^32 - 1 stay what they are. Error at most
 * (slices / wanted + 2) * 2^-28. Between opacities that differ by less than the error
 * it may fall where it should rise.
 */
uint32_t fx_correct_slices(uint32_t opacity, uint32_t slices, uint32_t wanted);

#endif /* FX_CORRECT_H */
