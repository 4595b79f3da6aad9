#include "kernel.h"

#include "fx_log.h"
#include "fx_wide.h"

#define HALF_PIXEL 0x8000

/* Half of the kernel's integral, Q0.32. */
#define HALF ((uint32_t)1 << 31)

/* 1 / (1/2) as Q5.27, which fx_reciprocal only comes near. */
#define TWO_Q27 ((uint32_t)2 << 27)

void qv_footprint_of(qv_footprint *footprint, const qv_kernel *kernel, int64_t centre,
                     uint32_t size)
{
    qv_footprint_place(footprint, kernel, centre, size);
    uint32_t half = footprint->half;
    footprint->shift = 0;
    for (; half >> 30 == 0; half <<= 1)
        footprint->shift++; /* at most 20 */
    footprint->reciprocal = half == (uint32_t)1 << 30 ? TWO_Q27 : fx_reciprocal(half);
}

static int32_t clamp(int64_t v, int32_t least, int32_t most)
{
    if (v < least)
        return least;
    return v > most ? most : (int32_t)v;
}

/* Pixel k reaches from k - 1/2 to k + 1/2. */
void qv_footprint_range(int32_t *first, int32_t *end, const qv_footprint *footprint, int32_t from,
                        int32_t to)
{
    int64_t middle = footprint->centre + HALF_PIXEL;
    *first = clamp(fx_shift_floor(middle - footprint->half, 16), from, to);
    *end = clamp(fx_shift_floor(middle + footprint->half - 1, 16) + 1, from, to);
}

/*
 * The integral of the kernel from its middle to a part of half its width, Q.16 of
 * QV_KERNEL_PARTS: Q0.32. Between entries it is a parabola through them and the next, which bends
 * down by 0 .. 35: at a place f between them the chord lacks bend * f (1 - f) / 2.
 */
static uint32_t integral(const qv_kernel *kernel, uint32_t part)
{
    uint32_t entry = part >> 16, place = part & 0xFFFFu;
    if (entry >= QV_KERNEL_PARTS)
        return HALF;
    const uint16_t *at = QV_FIELD(kernel, integral) + entry;
    uint32_t lower = fx_table16(at), upper = fx_table16(at + 1);
    uint32_t bend = 2u * upper - lower - fx_table16(at + 2);
    uint32_t lack = place * (65536u - place) >> 17;               /* <= 2^13 */
    return (lower << 16) + (upper - lower) * place + bend * lack; /* <= 2^31 */
}

/* The integral from the middle to the edge left of a pixel, times the voxel's size: Q1.15 a
   pixel, at most 2^26 in magnitude. */
static int32_t edge(const qv_footprint *footprint, int32_t pixel)
{
    int64_t way = (int64_t)pixel * 65536 - HALF_PIXEL - footprint->centre;
    uint64_t distance = way < 0 ? 0u - (uint64_t)way : (uint64_t)way;
    uint32_t share = HALF;
    if (distance < footprint->half) {
        /* distance / half: their product is Q27 by Q31, less the shift; wanted is Q22 */
        uint64_t quotient = fx_wide_product((uint32_t)distance, footprint->reciprocal);
        share = integral(footprint->kernel, (uint32_t)(quotient >> (36u - footprint->shift)));
    }
    int32_t part = (int32_t)(fx_wide_product(footprint->size, share) >> 33);
    return way < 0 ? -part : part;
}

uint16_t qv_footprint_weight(const qv_footprint *footprint, int32_t pixel)
{
    return (uint16_t)(edge(footprint, pixel + 1) - edge(footprint, pixel));
}

void qv_footprint_weights(uint16_t *weights, const qv_footprint *footprint, int32_t pixel,
                          unsigned count)
{
    int32_t left = edge(footprint, pixel);
    for (unsigned i = 0; i < count; i++) {
        int32_t right = edge(footprint, pixel + 1 + (int32_t)i);
        weights[i] = (uint16_t)(right - left);
        left = right;
    }
}
