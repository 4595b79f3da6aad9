#include "fx_phi.h"

#include "fx_bits.h"
#include "fx_inline.h"
#include "fx_phi_table.h"
#include "fx_wide.h"

/*
 * 0 .. 2 and each octave from 2 on have 8 segments. In the octave from 2^n, values
 * are scaled by 2^n; from 32 on 2^-x does not show, and all octaves are alike.
 */
#define SEGMENT_BITS 3
#define OCTAVES      6

/* The least significant bits of the table's columns: 2^-31, 2^-31, 2^-21, 2^-24. */
#define SQUARE_SHIFT 10
#define CUBE_SHIFT   9

/*
 * phi falls and is convex, and all its derivatives alternate in sign: from the end
 * of a segment backwards, every term grows with the distance. So rounding cannot
 * make the sum fall towards 0. position is Q0.32 of the octave.
 */
FX_INLINE uint32_t octave_value(unsigned octave, uint32_t position)
{
    unsigned row = octave << SEGMENT_BITS | (unsigned)(position >> (32 - SEGMENT_BITS));
    uint32_t back = ~(position << SEGMENT_BITS); /* of a segment, Q0.32 */
    uint16_t back16 = (uint16_t)(back >> 16);
    uint32_t square = (uint32_t)fx_table16(&phi_square[row]) << SQUARE_SHIFT; /* < 2^26 */
    square += (uint32_t)fx_table16(&phi_cube[row]) * back16 >> CUBE_SHIFT;
    uint32_t slope = fx_table32(&phi_linear[row]) + fx_product_shift16(square, back16);
    return fx_table32(&phi_end[row]) + fx_high_product(back, slope); /* <= 1.45, Q1.31 */
}

uint32_t fx_phi(fx_depth depth)
{
    uint32_t whole = (uint32_t)(depth >> 32), fraction = (uint32_t)depth;
    if (whole < 2u)
        return octave_value(0, whole << 31 | fraction >> 1);
    unsigned zeros = fx_leading_zeros(whole), octave = 31u - zeros; /* depth in 2^octave .. */
    uint32_t position = whole << zeros << 1 | fraction >> octave;   /* octave >= 1 */
    uint32_t value = octave_value(octave < OCTAVES ? octave : OCTAVES - 1u, position);
    return ((value >> (octave - 1u)) + 1u) >> 1; /* value < 2^32 - 1 */
}
