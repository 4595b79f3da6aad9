/*
 * sample.h - reconstruction between voxels: what a sample's colour and opacity
 * are. Sums leave the kernel unrounded, in the units stated at fx_weight.h.
 *
 * Source: Wittenbrink, Malzbender, Goss 1998: equations 9 to 12, table 1.
 */
#ifndef QV_SAMPLE_H
#define QV_SAMPLE_H

#include "cell.h"
#include "fx_bits.h"
#include "fx_log.h"
#include "weights.h"

typedef struct qv_sample {
    fx_sum light[3];  /* weighted colour; 1 is 65536 * 255 * 255 or 65535 * 65535 */
    fx_share opacity; /* or extinction; 1, or the full value, is 65536 * 255 or 65536 * 65535 */
    unsigned scale; /* of converted opacity: both are 2^scale times as large as fx_weight.h says */
} qv_sample;

/* A mode: fills the sample from where the ray stands and returns 1, or returns 0 where
   every opacity that it would read is 0. */
typedef int qv_mode(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,
                    unsigned storage);

FX_INLINE uint32_t qv_opacity_bits(qv_address entry, unsigned storage)
{
    return fx_channel_bits(qv_channel(entry, 3, storage));
}

/*
 * Whether one of a cell's corners has any opacity. Where something is to be seen, the first mostly
 * has; the others are asked together. Written out, as qv_corners is: most samples come no
 * farther, and compilers keep short loops as loops.
 */
FX_INLINE int qv_any_opacity(const qv_address corner[8], unsigned storage)
{
    if (qv_opacity_bits(corner[0], storage) != 0)
        return 1;
    uint32_t low = qv_opacity_bits(corner[1], storage) | qv_opacity_bits(corner[2], storage) |
                   qv_opacity_bits(corner[3], storage);
    uint32_t high = qv_opacity_bits(corner[4], storage) | qv_opacity_bits(corner[5], storage) |
                    qv_opacity_bits(corner[6], storage) | qv_opacity_bits(corner[7], storage);
    return (low | high) != 0;
}

/* What colours are multiplied with: their voxel's share of the sample's opacity or stored
   extinction, its share of the extinction of stored opacity, or its weight alone. */
typedef enum { QV_BY_SHARE, QV_BY_DENSITY, QV_BY_WEIGHT } qv_factor;

/* The extinction of an opacity, below 64: see fx_weight.h. It rises with the opacity. */
FX_INLINE fx_extinction qv_density_of(uint32_t opacity, unsigned storage)
{
    fx_extinction extinction = qv_channel_bytes(storage) == 1
                                   ? fx_extinction_of_unorm8((fx_unorm8)opacity)
                                   : fx_extinction_of_unorm16((fx_unorm16)opacity);
    return extinction - (extinction >> 30); /* FX_OPAQUE is 2^30 */
}

FX_INLINE fx_extinction qv_density(qv_address entry, unsigned storage)
{
    return qv_density_of(qv_opacity_bits(entry, storage), storage);
}

/*
 * The exponent of the power of 2 that takes the extinction of the largest opacity of a sample, which
 * is not 0, to 2^29 or more: thin media keep as many bits as dense ones.
 */
FX_INLINE unsigned qv_density_scale(uint32_t most, unsigned storage)
{
    return fx_leading_zeros(qv_density_of(most, storage)) - 2u; /* it is below 2^30 */
}

FX_INLINE uint32_t qv_larger(uint32_t a, uint32_t b)
{
    return a > b ? a : b;
}

/* The largest opacity of a cell's corners. */
FX_INLINE uint32_t qv_most_opacity(const qv_address corner[8], unsigned storage)
{
    uint32_t most = qv_opacity_bits(corner[0], storage);
    for (unsigned i = 1; i < 8; i++)
        most = qv_larger(most, qv_opacity_bits(corner[i], storage));
    return most;
}

/* A colour with 16 bits, from either storage: 8 bits are repeated. */
FX_INLINE fx_channel qv_colour16(fx_channel colour, unsigned storage)
{
    return qv_channel_bytes(storage) == 1 ? fx_channel_of(fx_channel_bits(colour) * 257u) : colour;
}

/* The three colours of a corner, each times its factor, in the unit of qv_sample for
   shares and of 65536 * 255 or 65536 * 65535 for weights. */
FX_INLINE void qv_terms(fx_sum term[3], fx_weight weight, fx_share share, qv_address entry,
                        unsigned storage, qv_factor factor)
{
    fx_channel red = qv_channel(entry, 0, storage);
    fx_channel green = qv_channel(entry, 1, storage);
    fx_channel blue = qv_channel(entry, 2, storage);
    if (factor == QV_BY_WEIGHT) {
        term[0] = fx_sum_of_weight(weight, red);
        term[1] = fx_sum_of_weight(weight, green);
        term[2] = fx_sum_of_weight(weight, blue);
    } else if (factor == QV_BY_DENSITY) {
        term[0] = fx_sum_of_share16(share, qv_colour16(red, storage));
        term[1] = fx_sum_of_share16(share, qv_colour16(green, storage));
        term[2] = fx_sum_of_share16(share, qv_colour16(blue, storage));
    } else if (qv_channel_bytes(storage) == 1) {
        term[0] = fx_sum_of_share8(share, red);
        term[1] = fx_sum_of_share8(share, green);
        term[2] = fx_sum_of_share8(share, blue);
    } else {
        term[0] = fx_sum_of_share16(share, red);
        term[1] = fx_sum_of_share16(share, green);
        term[2] = fx_sum_of_share16(share, blue);
    }
}

/* A voxel's share of the sample's opacity or extinction. The extinction of a stored opacity is made
   where it is used, times 2^scale: the stack keeps none of the others. */
FX_INLINE fx_share qv_share(fx_weight weight, qv_address entry, unsigned scale, unsigned storage,
                            qv_factor factor)
{
    if (factor == QV_BY_DENSITY)
        return fx_share_of_density(weight, fx_density_of(qv_density(entry, storage) << scale));
    return fx_share_mul(weight, qv_channel(entry, 3, storage));
}

/* Adds one voxel to the sums. */
FX_INLINE void qv_add_voxel(qv_sample *sum, fx_weight weight, qv_address entry, unsigned storage,
                            qv_factor factor)
{
    fx_sum term[3];
    FX_IN_ORDER();
    fx_share share = qv_share(weight, entry, sum->scale, storage, factor);
    qv_terms(term, weight, share, entry, storage, factor);
    sum->opacity = fx_share_add(sum->opacity, share);
    sum->light[0] = fx_sum_add(sum->light[0], term[0]);
    sum->light[1] = fx_sum_add(sum->light[1], term[1]);
    sum->light[2] = fx_sum_add(sum->light[2], term[2]);
}

/* Trilinear, of the entries of eight corners: 4M 12A for the weights, 8M 7A for the opacity or
   extinction, 3 * (8M 7A) for the colours, with every factor. */
FX_INLINE int qv_interpolate_corners(qv_sample *sample, const qv_address corner[8],
                                     const fx_fraction fraction[3], unsigned storage,
                                     qv_factor factor)
{
    fx_weight weight[8];
    if (!qv_any_opacity(corner, storage))
        return 0;
    FX_FORGET();
    qv_weights(weight, fraction);
    sample->scale = 0;
    if (factor == QV_BY_DENSITY)
        sample->scale = qv_density_scale(qv_most_opacity(corner, storage), storage);

    sample->opacity = qv_share(weight[0], corner[0], sample->scale, storage, factor);
    qv_terms(sample->light, weight[0], sample->opacity, corner[0], storage, factor);
    FX_UNROLL
    for (unsigned i = 1; i < 8; i++)
        qv_add_voxel(sample, weight[i], corner[i], storage, factor);
    return 1;
}

FX_INLINE int qv_interpolate(qv_sample *sample, const qv_cell *cell, const qv_volume *volume,
                             unsigned storage, qv_factor factor)
{
    qv_address corner[8];
    qv_corners(corner, cell, volume, storage);
    return qv_interpolate_corners(sample, corner, cell->fraction, storage, factor);
}

/* Opacity-weighted: equations 11 and 12; or extinction-weighted, of stored extinction. */
FX_INLINE int qv_cell_weighted(qv_sample *sample, const qv_cell *cell, const qv_volume *volume,
                               unsigned storage)
{
    return qv_interpolate(sample, cell, volume, storage, QV_BY_SHARE);
}

/* Extinction-weighted, of stored opacity. */
FX_INLINE int qv_cell_converted(qv_sample *sample, const qv_cell *cell, const qv_volume *volume,
                                unsigned storage)
{
    return qv_interpolate(sample, cell, volume, storage, QV_BY_DENSITY);
}

/* colour * opacity of two separate sums: round(c * a / 2^16) for 8 bits (below
   65536 * 255^2), round(c * a / 2^32) for 16. */
FX_INLINE fx_sum qv_associate(fx_sum colour, fx_share opacity, unsigned storage)
{
    uint32_t c = fx_sum_bits(colour), a = fx_share_bits(opacity);
    if (qv_channel_bytes(storage) == 1) /* c, a <= 65536 * 255 < 2^24 */
        return fx_sum_of(fx_high_product(c << 8, a << 8));
    return fx_sum_of(fx_high_product(c, a));
}

/* Separate: the products with the opacity are those of equation 4 and belong to
   compositing. */
FX_INLINE void qv_associate_light(qv_sample *sample, unsigned storage)
{
    for (unsigned c = 0; c < 3; c++)
        sample->light[c] = qv_associate(sample->light[c], sample->opacity, storage);
}

FX_INLINE int qv_cell_separate(qv_sample *sample, const qv_cell *cell, const qv_volume *volume,
                               unsigned storage)
{
    if (!qv_interpolate(sample, cell, volume, storage, QV_BY_WEIGHT))
        return 0;
    qv_associate_light(sample, storage);
    return 1;
}

/* Nearest: all of it is one entry's. */
FX_INLINE int qv_sample_entry(qv_sample *sample, qv_address entry, unsigned storage)
{
    fx_channel opacity = qv_channel(entry, 3, storage);
    if (fx_channel_bits(opacity) == 0)
        return 0;
    fx_weight one = fx_weight_of(FX_WEIGHT_ONE);
    sample->opacity = fx_share_mul(one, opacity);
    qv_terms(sample->light, one, sample->opacity, entry, storage, QV_BY_SHARE);
    return 1;
}

FX_INLINE int qv_cell_nearest(qv_sample *sample, const qv_cell *cell, const qv_volume *volume,
                              unsigned storage)
{
    return qv_sample_entry(sample, qv_entry(qv_cell_nearest_voxel(cell), volume, storage), storage);
}

/* The modes from where a ray stands: qv_sample_MODE. */
#define QV_SAMPLE_CELL(mode)                                                                       \
    FX_INLINE int qv_sample_##mode(qv_sample *sample, const qv_ray *ray, const qv_volume *volume,  \
                                   unsigned storage)                                               \
    {                                                                                              \
        qv_cell cell;                                                                              \
        qv_cell_locate(&cell, volume, ray);                                                        \
        return qv_cell_##mode(sample, &cell, volume, storage);                                     \
    }

QV_SAMPLE_CELL(nearest)
QV_SAMPLE_CELL(separate)
QV_SAMPLE_CELL(weighted)
QV_SAMPLE_CELL(converted)

/*
 * A sample's opacity as Q0.32 with 2^32 - 1 for exactly 1: opacity * 2^32 / unit,
 * at most 3 units of 2^-32 low. 2^32 / (65536 * 255) = 257 + 1/255, and 1/255 =
 * 1/2^8 + 1/2^16 + ...; 2^32 / (65536 * 65535) = 1 + 1/65535.
 */
FX_INLINE uint32_t qv_opacity_q32(fx_share opacity, unsigned storage)
{
    uint32_t a = fx_share_bits(opacity);
    if (qv_channel_bytes(storage) == 1)
        return a * 257u + (a >> 8) + (a >> 16);
    return a + (a >> 16);
}

#endif /* QV_SAMPLE_H */
