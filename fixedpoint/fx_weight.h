/*
 * fx_weight.h - the numbers of trilinear interpolation and their operations.
 *
 *   fx_fraction  Q0.8    place between two voxel centres
 *   fx_tap       Q0.17   of one voxel on one axis, of a B-spline: at most 1/2
 *   fx_weight    Q1.16   of one voxel, 65536 is 1
 *   fx_channel           colour or opacity as stored, 8 or 16 bits
 *   fx_density           extinction of a stored opacity, Q8.24, below 64
 *   fx_share             weight * opacity: the weighted weight of equation 11; or
 *                        weight * extinction
 *   fx_sum               share or weight * channel, and sums of them
 *
 * Units of 1:        8-bit storage       16-bit storage
 *   fx_share         65536 * 255         65536 * 65535
 *   fx_sum, weighted 65536 * 255 * 255   65535 * 65535
 *   fx_sum, separate 65536 * 255         65536 * 65535
 * Shares of an fx_density count 2^25 for 1, so 2^31 for 64, and sums of them times a
 * colour 2^31 * 65535 / 65536, whatever the storage.
 *
 * Eight weights sum to 65536, so sums of 8-bit storage are at most 65536 * 255^2
 * = 4261478400 and those of 16-bit storage at most 65536 * 65535 = 4294901760:
 * both below 2^32. Source: Wittenbrink, Malzbender, Goss 1998, section 6.
 */
#ifndef FX_WEIGHT_H
#define FX_WEIGHT_H

#include "fx_number.h"
#include "fx_wide.h"

FX_NUMBER(fx_fraction)
FX_NUMBER(fx_tap)
FX_NUMBER(fx_weight)
FX_NUMBER(fx_channel)
FX_NUMBER(fx_density)
FX_NUMBER(fx_share)
FX_NUMBER(fx_sum)

#define FX_WEIGHT_ONE 65536u

/* The fraction as a weight: exact. */
static inline fx_weight fx_weight_of_fraction(fx_fraction f)
{
    return fx_weight_of(fx_fraction_bits(f) << 8);
}

/* f * g: exact. */
static inline fx_weight fx_fraction_mul(fx_fraction f, fx_fraction g)
{
    FX_COUNT(fx_multiplications);
    return fx_weight_of(fx_fraction_bits(f) * fx_fraction_bits(g));
}

/* w * f, to nearest, ties upwards: the one rounding among the weights. */
static inline fx_weight fx_weight_mul(fx_weight w, fx_fraction f)
{
    FX_COUNT(fx_multiplications);
    return fx_weight_of((fx_weight_bits(w) * fx_fraction_bits(f) + 128u) >> 8);
}

/* f^2 / 2 for f in 1/256, 0 .. 1: exact. */
static inline fx_tap fx_tap_of_square(uint32_t f)
{
    FX_COUNT(fx_multiplications);
    return fx_tap_of(f * f);
}

/* t, to nearest, ties upwards. */
static inline fx_weight fx_weight_of_tap(fx_tap t)
{
    return fx_weight_of((fx_tap_bits(t) + 1u) >> 1);
}

/* w * t, to nearest, ties upwards, for w <= 3/4: w * t <= 3/4 * 2^32. */
static inline fx_weight fx_weight_tap_mul(fx_weight w, fx_tap t)
{
    FX_COUNT(fx_multiplications);
    return fx_weight_of((fx_weight_bits(w) * fx_tap_bits(t) + 65536u) >> 17);
}

static inline fx_weight fx_weight_add(fx_weight v, fx_weight w)
{
    FX_COUNT(fx_additions);
    return fx_weight_of(fx_weight_bits(v) + fx_weight_bits(w));
}

/* v - w for w <= v; counted as an addition, as the paper counts. */
static inline fx_weight fx_weight_sub(fx_weight v, fx_weight w)
{
    FX_COUNT(fx_additions);
    return fx_weight_of(fx_weight_bits(v) - fx_weight_bits(w));
}

/* w * a: exact; at most 65536 * 65535. */
static inline fx_share fx_share_mul(fx_weight w, fx_channel a)
{
    FX_COUNT(fx_multiplications);
    return fx_share_of(fx_weight_bits(w) * fx_channel_bits(a));
}

/* w * e, to nearest: at most 2^31. w <= 2^16 and e < 2^30. */
static inline fx_share fx_share_of_density(fx_weight w, fx_density e)
{
    FX_COUNT(fx_multiplications);
    return fx_share_of(fx_high_product(fx_weight_bits(w) << 15, fx_density_bits(e) << 2));
}

static inline fx_share fx_share_add(fx_share s, fx_share t)
{
    FX_COUNT(fx_additions);
    return fx_share_of(fx_share_bits(s) + fx_share_bits(t));
}

/* w * c for separate interpolation: exact. */
static inline fx_sum fx_sum_of_weight(fx_weight w, fx_channel c)
{
    FX_COUNT(fx_multiplications);
    return fx_sum_of(fx_weight_bits(w) * fx_channel_bits(c));
}

/* s * c for 8-bit storage: exact. */
static inline fx_sum fx_sum_of_share8(fx_share s, fx_channel c)
{
    FX_COUNT(fx_multiplications);
    return fx_sum_of(fx_share_bits(s) * fx_channel_bits(c));
}

/* floor(s * c / 2^16) for 16-bit storage: at most one unit of 2^-32 low. */
static inline fx_sum fx_sum_of_share16(fx_share s, fx_channel c)
{
    FX_COUNT(fx_multiplications);
    return fx_sum_of(fx_product_shift16(fx_share_bits(s), (uint16_t)fx_channel_bits(c)));
}

static inline fx_sum fx_sum_add(fx_sum s, fx_sum t)
{
    FX_COUNT(fx_additions);
    return fx_sum_of(fx_sum_bits(s) + fx_sum_bits(t));
}

#endif /* FX_WEIGHT_H */
