/*
 * sample.h - reconstruction between voxels: what a sample's colour and opacity
 * are. Sums leave the kernel unrounded, in the units stated at fx_weight.h.
 *
 * Source: Wittenbrink, Malzbender, Goss 1998: equations 9 to 12, table 1.
 */
#ifndef QV_SAMPLE_H
#define QV_SAMPLE_H

#include "cell.h"
#include "weights.h"

typedef struct qv_sample {
    fx_sum light[3];  /* associated colour; 1 is 65536 * 255 * 255 or 65535 * 65535 */
    fx_share opacity; /* 1 is 65536 * 255 or 65536 * 65535 */
} qv_sample;

/* A mode: fills the sample and returns 1, or returns 0 where every opacity that
   it would read is 0. */
typedef int qv_mode(qv_sample *sample, const qv_cell *cell, const qv_volume *volume,
                    unsigned storage);

/* Opacities of the eight corners; returns whether one is not 0. */
QV_INLINE int qv_opacities(fx_channel opacity[8], const qv_address corner[8], unsigned storage)
{
    uint32_t any = 0;
    for (unsigned i = 0; i < 8; i++) {
        opacity[i] = qv_channel(corner[i], 3, storage);
        any |= fx_channel_bits(opacity[i]);
    }
    return any != 0;
}

/* share * colour in the unit of the storage. */
QV_INLINE fx_sum qv_weighted_colour(fx_share share, fx_channel colour, unsigned storage)
{
    if (qv_channel_bytes(storage) == 1)
        return fx_sum_of_share8(share, colour);
    return fx_sum_of_share16(share, colour);
}

/* Opacity-weighted: 4M 19A for the weights, 8M for the shares, 7A for the
   opacity, 3 * (8M 7A) for the colours. */
QV_INLINE int qv_sample_weighted(qv_sample *sample, const qv_cell *cell, const qv_volume *volume,
                                 unsigned storage)
{
    qv_address corner[8];
    fx_channel opacity[8];
    fx_weight weight[8];
    qv_corners(corner, cell, volume, storage);
    if (!qv_opacities(opacity, corner, storage))
        return 0;
    qv_weights(weight, cell->fraction);

    sample->opacity = fx_share_mul(weight[0], opacity[0]);
    for (unsigned c = 0; c < 3; c++)
        sample->light[c] =
            qv_weighted_colour(sample->opacity, qv_channel(corner[0], c, storage), storage);
    for (unsigned i = 1; i < 8; i++) {
        fx_share share = fx_share_mul(weight[i], opacity[i]);
        sample->opacity = fx_share_add(sample->opacity, share);
        for (unsigned c = 0; c < 3; c++) {
            fx_sum term = qv_weighted_colour(share, qv_channel(corner[i], c, storage), storage);
            sample->light[c] = fx_sum_add(sample->light[c], term);
        }
    }
    return 1;
}

/* colour * opacity of two separate sums: round(c * a / 2^16) for 8 bits (below
   65536 * 255^2), round(c * a / 2^32) for 16. */
QV_INLINE fx_sum qv_associate(fx_sum colour, fx_share opacity, unsigned storage)
{
    uint32_t c = fx_sum_bits(colour), a = fx_share_bits(opacity);
    if (qv_channel_bytes(storage) == 1) /* c, a <= 65536 * 255 < 2^24 */
        return fx_sum_of(fx_high_product(c << 8, a << 8));
    return fx_sum_of(fx_high_product(c, a));
}

/* Separate: 4M 19A for the weights, 4 * (8M 7A) for the channels. The products
   with the opacity are those of equation 4 and belong to compositing. */
QV_INLINE int qv_sample_separate(qv_sample *sample, const qv_cell *cell, const qv_volume *volume,
                                 unsigned storage)
{
    qv_address corner[8];
    fx_channel opacity[8];
    fx_weight weight[8];
    qv_corners(corner, cell, volume, storage);
    if (!qv_opacities(opacity, corner, storage))
        return 0;
    qv_weights(weight, cell->fraction);

    sample->opacity = fx_share_mul(weight[0], opacity[0]);
    for (unsigned i = 1; i < 8; i++)
        sample->opacity = fx_share_add(sample->opacity, fx_share_mul(weight[i], opacity[i]));
    for (unsigned c = 0; c < 3; c++) {
        fx_sum colour = fx_sum_of_weight(weight[0], qv_channel(corner[0], c, storage));
        for (unsigned i = 1; i < 8; i++) {
            fx_sum term = fx_sum_of_weight(weight[i], qv_channel(corner[i], c, storage));
            colour = fx_sum_add(colour, term);
        }
        sample->light[c] = qv_associate(colour, sample->opacity, storage);
    }
    return 1;
}

/* Nearest: the corner of the half of the cell that the sample lies in. */
QV_INLINE int qv_sample_nearest(qv_sample *sample, const qv_cell *cell, const qv_volume *volume,
                                unsigned storage)
{
    qv_address voxel = cell->base;
    for (unsigned axis = 0; axis < 3; axis++)
        if (fx_fraction_bits(cell->fraction[axis]) >= 128)
            voxel = qv_at(voxel, cell->next[axis]);
    qv_address entry = qv_entry(voxel, volume, storage);
    fx_channel opacity = qv_channel(entry, 3, storage);
    if (fx_channel_bits(opacity) == 0)
        return 0;
    sample->opacity = fx_share_mul(fx_weight_of(FX_WEIGHT_ONE), opacity);
    for (unsigned c = 0; c < 3; c++)
        sample->light[c] =
            qv_weighted_colour(sample->opacity, qv_channel(entry, c, storage), storage);
    return 1;
}

/*
 * A sample's opacity as Q0.32 with 2^32 - 1 for exactly 1: opacity * 2^32 / unit,
 * at most 3 units of 2^-32 low. 2^32 / (65536 * 255) = 257 + 1/255, and 1/255 =
 * 1/2^8 + 1/2^16 + ...; 2^32 / (65536 * 65535) = 1 + 1/65535.
 */
QV_INLINE uint32_t qv_opacity_q32(fx_share opacity, unsigned storage)
{
    uint32_t a = fx_share_bits(opacity);
    if (qv_channel_bytes(storage) == 1)
        return a * 257u + (a >> 8) + (a >> 16);
    return a + (a >> 16);
}

#endif /* QV_SAMPLE_H */
