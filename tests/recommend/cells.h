/*
 * cells.h - the cells of core/recommend_table.h, as they are measured.
 */
#ifndef RECOMMEND_CELLS_H
#define RECOMMEND_CELLS_H

#include "blend_worst.h"

#include <math.h>

/* Least opacities: any, and from 1, 4, 16 and 64 levels on. */
#define CELL_ROWS 5

/* Numbers of slices: up to 64, 256, 1024 and 4096. */
#define CELL_COLUMNS 4

static inline ref_slice_limits cell_limits(unsigned row, unsigned column)
{
    const ref_slice_limits limits = {(uint32_t)64 << 2 * column,
                                     row == 0 ? 0 : (double)(1 << 2 * (row - 1))};
    return limits;
}

/* A higher least opacity is one that a lower one allows: what showed there counts here. So do
   fewer slices. */
static inline void cell_raise(ref_worst to[REF_STATES][REF_ROUNDINGS],
                              ref_worst from[REF_STATES][REF_ROUNDINGS])
{
    for (unsigned state = 0; state < REF_STATES; state++)
        for (unsigned r = 0; r < REF_ROUNDINGS; r++) {
            to[state][r].fog = fmax(to[state][r].fog, from[state][r].fog);
            to[state][r].any = fmax(to[state][r].any, from[state][r].any);
        }
}

/* What tells a state in qv_recommend: one frame buffer that has it. */
typedef struct cell_state {
    const char *name;
    uint8_t bits, residual_bits;
} cell_state;

static const cell_state cell_states[REF_STATES] = {{"5 bits", 5, 0},   {"6 bits", 6, 0},
                                                   {"8 bits", 8, 0},   {"12 bits", 12, 0},
                                                   {"16 bits", 16, 0}, {"24 bits", 24, 0}};

/* 32 phases of all cases; of those of 4096 slices, of every fourth. */
static inline ref_effort cell_effort(unsigned column)
{
    const ref_effort effort = {column + 1 < CELL_COLUMNS ? 1 : 4, 32};
    return effort;
}

#endif /* RECOMMEND_CELLS_H */
