/*
 * buffer.h - tests/SPEC.md, sections 58 to 60: pixels of a frame buffer of few bits.
 */
#ifndef BUFFER_H
#define BUFFER_H

#include "number.h"
#include "pixels.h"
#include "slices.h"

enum family { FAMILY_OVER, FAMILY_UNDER, FAMILY_HARDWARE, FAMILY_HAND_OUT };

/* A blend: its channels, their fraction bits, and where these lie. */
typedef struct blend_kind {
    enum family family;
    unsigned channels, f;
    bool has_residual, is_565;
} blend_kind;

/* Strings of bits, from the lowest of the first byte on. */
typedef struct stored_pixel {
    number pixel, beside;
} stored_pixel;

/* S of each channel, and T front to back. */
typedef struct state {
    number S[4], T;
} state;

state read_state(const blend_kind *kind, const stored_pixel *from);
stored_pixel write_state(const blend_kind *kind, const state *s);

typedef struct slice {
    triple light;
    number o32, u;
} slice;

enum technique_kind {
    TECHNIQUE_ROUNDED,
    TECHNIQUE_RANDOM,
    TECHNIQUE_ORDERED,
    TECHNIQUE_BUMPED,
    TECHNIQUE_BUMPED_RANDOM,
    TECHNIQUE_CORRECTED
};

/* How hardware_* and hand_out make an opacity of 8 bits. */
typedef struct choice {
    enum technique_kind kind;
    technique of;
    number phase;
} choice;

state blend_slice(const blend_kind *kind, const state *before, const slice *s, const choice *how);
state cleared_state(const blend_kind *kind, const channels *background);

/* What a pixel shows: light and o32; and its channels before a background. */
slice shown(const blend_kind *kind, const state *s);
channels shown_channels(const blend_kind *kind, const slice *shows, const channels *background);

#endif /* BUFFER_H */
