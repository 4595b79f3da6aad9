/*
 * Three cuts take the curve through its octants in the order of a Gray code: from one to the next
 * it crosses a single cut. Within each octant it must enter next to where it left the one before,
 * and leave next to the following one. A Hilbert curve enters a cube at a corner and leaves it at
 * the other end of one edge; so does each octant's curve, and these are the corners and edges that
 * fit together. Call the axes A, B and C in the order of the cuts; the curve of the whole cube
 * enters at 000 and leaves along A, at 100.
 */
#include "curve.h"

/* The axis along which the curve of an octant leaves, and so the first one that cuts it. */
enum { A = 0, B = 2, C = 1 };

FX_TABLE qv_turn hilbert[8] = {
    /*      enters, leaves along        the octant, and where its curve leaves */
    QV_TURN(0u, C), /* 000: 000 .. 001 */
    QV_TURN(0u, B), /* 001: 000 .. 010 */
    QV_TURN(0u, B), /* 011: 000 .. 010 */
    QV_TURN(3u, A), /* 010: 011 .. 111 */
    QV_TURN(3u, A), /* 110: 011 .. 111 */
    QV_TURN(6u, B), /* 111: 110 .. 100 */
    QV_TURN(6u, B), /* 101: 110 .. 100 */
    QV_TURN(5u, C), /* 100: 101 .. 100 */
};

static uint64_t hilbert_index(const uint16_t size[3], const uint16_t position[3])
{
    return qv_curve_index(size, position, hilbert);
}

static void hilbert_position(uint16_t position[3], const uint16_t size[3], uint64_t index)
{
    qv_curve_position(position, size, index, hilbert);
}

QV_DESCRIPTOR qv_order qv_order_hilbert = {hilbert_index, hilbert_position};
