/*
 * slice_cases.h - what a pixel of a frame buffer meets: 1000 slices that are not empty, of
 * the kinds that blending in few bits is bad at, and what exact blending makes of them.
 */
#ifndef REF_SLICE_CASES_H
#define REF_SLICE_CASES_H

#include <stdint.h>

#define REF_SLICES      1000
#define REF_SLICES_MOST 4096

typedef enum ref_slice_kind {
    REF_SLICES_CONSTANT, /* a fog of one opacity and colour */
    REF_SLICES_SPARSE,   /* the same where all but every k-th slice are empty */
    REF_SLICES_RANDOM,   /* random opacities and colours, either or both */
    REF_SLICES_GAPS,     /* one opacity and colour, 0 .. 7 empty slices at random between */
    REF_SLICES_TWO_FOGS, /* two opacities and colours in turn, runs of 1 .. 500 slices */
    REF_SLICES_SURFACE,  /* one slice of high opacity in a fog */
    REF_SLICES_RAMP,     /* opacity that rises, falls or both, linearly or by powers */
    REF_SLICE_KINDS
} ref_slice_kind;

extern const char *const ref_slice_kind_names[REF_SLICE_KINDS];

/* Slices in the order in which they are blended. */
typedef struct ref_slice_case {
    ref_slice_kind kind;
    uint32_t count;                    /* of slices: REF_SLICES unless limited */
    uint32_t start;                    /* level before the first one; back to front */
    uint32_t index[REF_SLICES_MOST];   /* of the slice, empty ones counted: for the dither */
    uint32_t opacity[REF_SLICES_MOST]; /* Q0.32, 2^32 - 1 is 1 */
    uint8_t colour[REF_SLICES_MOST];   /* level */
    double over[REF_SLICES_MOST];      /* level after each slice, back to front */
    double under[REF_SLICES_MOST];     /* the same front to back, from 0 on */
    double named;                      /* an opacity in levels that tells the case */
    uint32_t parameter;                /* k, the run, the place: what else tells it */
} ref_slice_case;

/* Opacities of .003 to 255 levels, all seeded: each call visits the same cases. */
typedef void ref_slice_visitor(void *user, const ref_slice_case *slices);
void ref_each_slice_case(ref_slice_visitor *visit, void *user);

/* The same with so many slices each, 1 .. REF_SLICES_MOST, of which none has an opacity below
   `least` levels: those become it. Cases of much less are left out. */
typedef struct ref_slice_limits {
    uint32_t count;
    double least;
} ref_slice_limits;

void ref_each_slice_case_within(ref_slice_visitor *visit, void *user,
                                const ref_slice_limits *limits);

#endif /* REF_SLICE_CASES_H */
