/*
 * weights.h - the eight weights of trilinear interpolation.
 *
 * Source: Wittenbrink, Malzbender, Goss 1998, section 6, multiplied out: 4
 * multiplications and, where the paper has 19 additions, 12, since differences are
 * shared. The weights sum to exactly 65536, because every product enters as often with
 * one sign as with the other. Only xyz is rounded, by at most 1/2, and each weight holds
 * it once; the exact weight is not negative, so the integer one is not either. What a
 * difference is taken from is a product of fractions and of 1 less a fraction, or a weight,
 * so that none wraps on the way.
 */
#ifndef QV_WEIGHTS_H
#define QV_WEIGHTS_H

#include "fx_weight.h"
#include "fx_inline.h"

FX_INLINE void qv_weights(fx_weight w[8], const fx_fraction f[3])
{
    fx_weight x = fx_weight_of_fraction(f[0]);
    fx_weight y = fx_weight_of_fraction(f[1]);
    fx_weight z = fx_weight_of_fraction(f[2]);
    fx_weight xy = fx_fraction_mul(f[0], f[1]);
    fx_weight xz = fx_fraction_mul(f[0], f[2]);
    fx_weight yz = fx_fraction_mul(f[1], f[2]);
    fx_weight xyz = fx_weight_mul(xy, f[2]);

    w[7] = xyz;
    w[6] = fx_weight_sub(yz, xyz);
    w[5] = fx_weight_sub(xz, xyz);
    w[3] = fx_weight_sub(xy, xyz);
    w[1] = fx_weight_sub(fx_weight_sub(x, xy), w[5]);
    fx_weight y_alone = fx_weight_sub(y, xy); /* (1 - x) y */
    w[2] = fx_weight_sub(y_alone, w[6]);
    w[4] = fx_weight_sub(fx_weight_sub(z, xz), w[6]);

    fx_weight below_x = fx_weight_sub(fx_weight_of(FX_WEIGHT_ONE), x);
    w[0] = fx_weight_sub(fx_weight_sub(below_x, y_alone), w[4]);
}

#endif /* QV_WEIGHTS_H */
