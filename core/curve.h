/*
 * curve.h - Morton and Hilbert curves through the voxels of a box, both ways.
 *
 * Both fill the least cube of 2^b voxels an axis that holds the box by octants, and each octant in
 * the same way. Octants come of three cuts, one on each axis, and of the two halves that a cut
 * makes, one is filled before the other is begun. So the index of a voxel is what the box has in
 * those first halves whose second half the voxel lies in; what a piece has of the box is a product
 * of three lengths. Where the box is the cube, they are powers of 2, and the halves are the bits
 * of the index as it is known.
 *
 * Morton curves cut on z, y and x, and fill the lower half first. Hilbert curves do either by
 * turns, order_hilbert.c; they reverse a cut besides where the one before it went to its second
 * half, since they go on from where they are.
 */
#ifndef QV_CURVE_H
#define QV_CURVE_H

#include "fx_inline.h"
#include "fx_table.h"
#include "fx_wide.h"
#include "qvol.h"

/* How an octant at some place on the curve is filled, as seen from the piece that it is of. */
typedef uint16_t qv_turn;
#define QV_TURN(corner, axis) ((corner) << 2 | (axis))

/* A piece of the cube that is about to be cut. */
typedef struct qv_piece {
    uint32_t extent[3]; /* voxels of the box in it, on each axis: 0 .. 4096 */
    uint32_t half;      /* half the edge of the octant that the cuts are of: 2^11 .. 1; 0: none */
    unsigned axis;      /* of the next cut; then the one below it, of 0 that is 2 */
    unsigned corner;    /* where the curve enters the octant: bit a for the upper half of axis a */
} qv_piece;

FX_INLINE unsigned qv_axis_below(unsigned axis)
{
    return axis == 0 ? 2 : axis - 1;
}

FX_INLINE qv_piece qv_piece_of(const uint16_t size[3])
{
    qv_piece piece = {{size[0], size[1], size[2]}, 0, 2, 0};
    uint32_t edge = 1;
    for (unsigned axis = 0; axis < 3; axis++)
        while (edge < size[axis])
            edge *= 2;
    piece.half = edge / 2;
    return piece;
}

/* Voxels of the box in the upper or the lower half on the axis of the cut: 0 .. 2^11. */
FX_INLINE uint32_t qv_piece_half(const qv_piece *piece, unsigned upper)
{
    uint32_t extent = piece->extent[piece->axis];
    uint32_t lower = extent < piece->half ? extent : piece->half;
    return upper ? extent - lower : lower;
}

/* Voxels of the box in that half, on all axes: at most 2^11 * 2^24. */
FX_INLINE uint64_t qv_piece_voxels(const qv_piece *piece, unsigned upper)
{
    unsigned next = qv_axis_below(piece->axis), last = qv_axis_below(next);
    return fx_wide_product(piece->extent[next] * piece->extent[last], qv_piece_half(piece, upper));
}

/* Goes on with that half. */
FX_INLINE void qv_piece_take(qv_piece *piece, unsigned upper)
{
    piece->extent[piece->axis] = qv_piece_half(piece, upper);
    piece->axis = qv_axis_below(piece->axis);
}

/* Goes on with the octant that three cuts have left. Of a turn's corner, bit 2 is the axis that
   was cut first, bit 1 the next one and bit 0 the last; of its axis, 0, 2 and 1 are those. */
FX_INLINE void qv_piece_turn(qv_piece *piece, qv_turn turn)
{
    unsigned up = piece->axis == 2 ? 0 : piece->axis + 1; /* bit 0 belongs to this axis */
    unsigned corner = (unsigned)turn >> 2;
    piece->corner ^= (corner << up | corner >> (3 - up)) & 7u;
    piece->axis += turn & 3u;
    if (piece->axis >= 3)
        piece->axis -= 3;
}

/* The index of a voxel of the box. turns: null for Morton, else 8 of them, a table. */
FX_INLINE uint64_t qv_curve_index(const uint16_t size[3], const uint16_t position[3],
                                  const qv_turn *turns)
{
    uint64_t index = 0;
    for (qv_piece piece = qv_piece_of(size); piece.half != 0; piece.half /= 2) {
        unsigned place = 0; /* of the octant on the curve: a bit for each second half */
        for (unsigned cut = 0; cut < 3; cut++) {
            unsigned upper = (position[piece.axis] & piece.half) != 0;
            unsigned first = (piece.corner >> piece.axis ^ (turns ? place : 0)) & 1u;
            if (upper != first)
                index += qv_piece_voxels(&piece, first); /* < 2^36, as the box has no more */
            qv_piece_take(&piece, upper);
            place = 2 * place + (upper ^ first);
        }
        if (turns)
            qv_piece_turn(&piece, fx_table16(turns + place));
    }
    return index;
}

/* The reverse, for an index below the voxels of the box: so that a voxel is never looked for in
   a half that the box does not reach. */
FX_INLINE void qv_curve_position(uint16_t position[3], const uint16_t size[3], uint64_t index,
                                 const qv_turn *turns)
{
    uint32_t found[3] = {0, 0, 0};
    for (qv_piece piece = qv_piece_of(size); piece.half != 0; piece.half /= 2) {
        unsigned place = 0;
        for (unsigned cut = 0; cut < 3; cut++) {
            unsigned first = (piece.corner >> piece.axis ^ (turns ? place : 0)) & 1u;
            uint64_t voxels = qv_piece_voxels(&piece, first);
            unsigned second = index >= voxels;
            if (second)
                index -= voxels;
            if (first ^ second)
                found[piece.axis] |= piece.half;
            qv_piece_take(&piece, first ^ second);
            place = 2 * place + second;
        }
        if (turns)
            qv_piece_turn(&piece, fx_table16(turns + place));
    }
    for (unsigned axis = 0; axis < 3; axis++)
        position[axis] = (uint16_t)found[axis];
}

#endif /* QV_CURVE_H */
