/*
 * fx_exp.h - transmittance and opacity of an optical depth.
 *
 * Depths are in base 2: a depth of x lets 2^-x of the light through. log2(e) is
 * folded into them once, where extinction comes from, so that no function of a
 * sample multiplies by it; a depth's whole part is then a shift.
 */
#ifndef FX_EXP_H
#define FX_EXP_H

#include <stdint.h>

#include "fx_unorm.h"

/*
 * Optical depth that is summed up along a ray, Q32.32. Sums are exact, so that a
 * medium's transmittance does not depend on the steps that it is summed in.
 */
typedef uint64_t fx_depth;

/* Extinction: the depth of a stretch of length 1, Q8.24. */
typedef uint32_t fx_extinction;

#define FX_CLEAR_Q31 0x80000000u /* transmittance 1, Q1.31 */

/*
 * 2^-depth as Q1.31, for every depth; 0 from depth 32 on. Exact at whole depths
 * below 32, so 2^31 at 0; never rises with the depth. Error at most .78 * 2^-31,
 * so that the difference of two, a sample's opacity, is off by less than 2^-30.
 */
uint32_t fx_transmittance(fx_depth depth);

/* 1 - 2^-depth as Q1.31: exactly what fx_transmittance leaves. */
static inline uint32_t fx_opacity(fx_depth depth)
{
    return FX_CLEAR_Q31 - fx_transmittance(depth);
}

/*
 * 2^-depth for a depth in Q8.24, any of them, with less work: unorm16, the unit
 * of stored opacities, so that both ends, 0 and 65535, are exact. Never rises;
 * 65535 at 0, 0 from depth 17 on. Error at most .51 of 1/65535.
 */
fx_unorm16 fx_transmittance16(uint32_t depth);

/* 1 - 2^-depth: exactly what fx_transmittance16 leaves. */
static inline fx_unorm16 fx_opacity16(uint32_t depth)
{
    return (fx_unorm16)(65535u - fx_transmittance16(depth));
}

#endif /* FX_EXP_H */
