/*
 * blend_worst.h - how far the blends that qv_recommend chooses from lie from exact ones, back
 * to front, over the contents of slice_cases.h: its table is made of this, and tested by it.
 */
#ifndef REF_BLEND_WORST_H
#define REF_BLEND_WORST_H

#include "slice_cases.h"

/* What a channel of the frame buffer holds: bits, or 8-bit levels with fraction bits. */
typedef enum ref_state {
    REF_STATE_5,
    REF_STATE_6,
    REF_STATE_8,
    REF_STATE_8_4,
    REF_STATE_8_8,
    REF_STATE_8_16,
    REF_STATES
} ref_state;

/* How the blend rounds: as hardware does, of opacities with as many bits; or by dither. States
   of 8.16 are rounded to nearest in either case, and those of 8.8 always dithered. */
typedef enum ref_rounding {
    REF_ROUNDING_PLAIN,
    REF_ROUNDING_GOLDEN,
    REF_ROUNDING_HASH,
    REF_ROUNDING_BLOCKS,
    REF_ROUNDINGS
} ref_rounding;

/* The largest deviation after any slice, in 8-bit levels as they are shown: of a constant fog, and
   of any content. */
typedef struct ref_worst {
    double fog, any;
} ref_worst;

/* How much is tried: one of so many cases, and phases of the dither, 1 .. 64. */
typedef struct ref_effort {
    unsigned every, phases;
} ref_effort;

/* Not measured where there is no such blend: 0. */
void ref_blend_worst(ref_worst worst[REF_STATES][REF_ROUNDINGS], const ref_slice_limits *limits,
                     const ref_effort *effort);

#endif /* REF_BLEND_WORST_H */
