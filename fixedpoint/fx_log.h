/*
 * fx_log.h - optical depth of an opacity, the inverse of fx_exp.h, and the
 * reciprocal that reads the same table.
 */
#ifndef FX_LOG_H
#define FX_LOG_H

#include "fx_exp.h"

/*
 * The depth of full opacity, whose logarithm has none: 64, for which a voxel is
 * opaque at every step. With steps of 1/16 .. 1 voxel, the samples within a voxel
 * stand for more than half of it (for all of it where 1/step is whole), with
 * longer steps each sample stands for at least a voxel. So the depth between them
 * is 32 or more, where fx_transmittance and fx_transmittance16 are exactly 0. A
 * sample of a shorter stretch s, alone, has the opacity 1 - 2^-(64 s).
 */
#define FX_OPAQUE_WHOLE 64u
#define FX_OPAQUE_DEPTH ((fx_depth)FX_OPAQUE_WHOLE << 32)
#define FX_OPAQUE       ((fx_extinction)FX_OPAQUE_WHOLE << 24)

/*
 * -log2(transmittance), for every transmittance in Q0.32, 2^32 - 1 being 1. Error
 * at most 1.4 * 2^-28: the result is exactly 0 for 1, 32 within the error for the
 * least, and FX_OPAQUE_DEPTH for 0. Between numbers that differ by less than the
 * error it may fall where it should rise, by less than 2^-27.
 */
fx_depth fx_depth_of_transmittance(uint32_t transmittance);

/* The depth of an opacity in Q0.32, 2^32 - 1 being 1. Error as above. */
static inline fx_depth fx_depth_of_opacity(uint32_t opacity)
{
    return fx_depth_of_transmittance(0xFFFFFFFFu - opacity);
}

/* The depth of a stored opacity. 65537 is (2^32 - 1) / 65535. */
static inline fx_depth fx_depth_of_unorm16(fx_unorm16 opacity)
{
    return fx_depth_of_transmittance(65537u * (65535u - (uint32_t)opacity));
}

/*
 * Extinction of a stored opacity, -log2(1 - opacity): Q8.24, 0 at 0, FX_OPAQUE at
 * 65535, rising with the opacity. Error at most .61 * 2^-24.
 */
fx_extinction fx_extinction_of_unorm16(fx_unorm16 opacity);

/* The same for 8 bits, by a table of 1 KB: correctly rounded. */
fx_extinction fx_extinction_of_unorm8(fx_unorm8 opacity);

/*
 * 1 / v for v in 1/16 .. 1 as Q1.31: Q5.27. Error at most 2^-20 of the result;
 * exact at 1.
 */
uint32_t fx_reciprocal(uint32_t v);

#endif /* FX_LOG_H */
