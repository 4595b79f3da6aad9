/*
 * slices_fixture.h - a frame buffer in guarded memory, filled by slices, and a blend that only
 * notes down what a slice shows.
 */
#ifndef SLICES_FIXTURE_H
#define SLICES_FIXTURE_H

#include "blend.h"
#include "scene_fixture.h"

enum {
    FRAME_GAP = 5, /* bytes before, between and behind rows */
    FRAME_ROW = 16 * FIXTURE_WIDTH + FRAME_GAP,
    FRAME_BYTES = FRAME_ROW * FIXTURE_HEIGHT + FRAME_GAP
};

/* The planes of a frame buffer, of the bytes that a pixel and what lies beside it have. */
typedef struct frame {
    uint8_t pixels[FRAME_BYTES], beside[FRAME_BYTES];
    const qv_blend *blend;
    int upwards; /* rows run downwards in memory */
} frame;

static inline void frame_make(frame *f, const qv_blend *blend, int upwards)
{
    fixture_poison(f->pixels, sizeof f->pixels);
    fixture_poison(f->beside, sizeof f->beside);
    f->blend = blend;
    f->upwards = upwards;
}

/* Where a part of the frame lies in a plane; the bytes are exactly those that it needs. */
static inline void frame_cut(uint8_t *plane, const frame *f, unsigned pixel_bytes,
                             const qv_rect *part, void **at, size_t *bytes, ptrdiff_t *stride)
{
    const ptrdiff_t row = (ptrdiff_t)pixel_bytes * FIXTURE_WIDTH + FRAME_GAP;
    const ptrdiff_t rows = part->bottom - part->top;
    const ptrdiff_t line = f->upwards ? FIXTURE_HEIGHT - 1 - part->top : part->top;
    *at = plane + FRAME_GAP + line * row + part->left * (ptrdiff_t)pixel_bytes;
    *bytes = (size_t)((rows - 1) * row) + (size_t)(part->right - part->left) * pixel_bytes;
    *stride = f->upwards ? -row : row;
}

static inline qv_buffer frame_part(frame *f, const qv_rect *part)
{
    qv_buffer b = {.blend = f->blend};
    frame_cut(f->pixels, f, f->blend->bytes, part, &b.pixels, &b.bytes, &b.stride);
    if (f->blend->beside != 0)
        frame_cut(f->beside, f, f->blend->beside, part, &b.beside, &b.beside_bytes,
                  &b.beside_stride);
    return b;
}

/* All slices of a part, in the order of the blend; a slice handed out is the one in the middle. */
static inline void frame_render(frame *f, const qv_dither *dither, const qv_context *context,
                                const qv_rect *part)
{
    const qv_buffer b = frame_part(f, part);
    int32_t first, end;
    assert_int_equal(qv_slice_range(&first, &end, context, part), QV_OK);
    assert_int_equal(qv_clear(&b, context, part), QV_OK);
    for (int32_t i = 0; i < end - first; i++) {
        const int32_t slice = f->blend->kind == QV_UNDER ? first + i : end - 1 - i;
        assert_int_equal(qv_slice(&b, dither, context, part, slice), QV_OK);
    }
}

/* The frame as RGBA8888. */
static inline void frame_read(fixture_pixels pixels, frame *f, const qv_context *context)
{
    const qv_image image = {pixels, sizeof(fixture_pixels), FIXTURE_WIDTH * 4, &qv_format_rgba8888};
    const qv_buffer b = frame_part(f, &fixture_frame);
    assert_int_equal(qv_read_out(&image, &b, context, &fixture_frame), QV_OK);
}

/* ---- The probe -------------------------------------------------------------- */

/* What the probe notes in a pixel. */
typedef struct note {
    qv_fragment fragment;
    uint32_t u;
    uint32_t count; /* of the blends since it was cleared */
} note;

static inline void probe_blend(uint8_t *pixel, uint8_t *beside, const qv_fragment *fragment,
                               const qv_moment *moment)
{
    note n;
    (void)beside;
    memcpy(&n, pixel, sizeof n);
    n.fragment = *fragment;
    n.u = moment->u;
    n.count++;
    memcpy(pixel, &n, sizeof n);
}

static inline void probe_clear(uint8_t *pixel, uint8_t *beside, const qv_fragment *background)
{
    const note n = {*background, 0, 0};
    (void)beside;
    memcpy(pixel, &n, sizeof n);
}

static inline void probe_read(qv_fragment *fragment, const uint8_t *pixel, const uint8_t *beside)
{
    note n;
    (void)beside;
    memcpy(&n, pixel, sizeof n);
    *fragment = n.fragment;
}

static const qv_blend probe = {probe_blend, probe_clear, probe_read, 0, sizeof(note), 0, QV_OVER};

/* The notes of one slice. */
typedef note notes[FIXTURE_HEIGHT][FIXTURE_WIDTH];

static inline void take_notes(notes of, const qv_context *context, int32_t slice)
{
    static const qv_dither none = {.sequence = qv_sequence_rounded};
    const qv_buffer b = {
        .pixels = of, .bytes = sizeof(notes), .stride = sizeof of[0], .blend = &probe};
    assert_int_equal(qv_clear(&b, context, &fixture_frame), QV_OK);
    assert_int_equal(qv_slice(&b, &none, context, &fixture_frame, slice), QV_OK);
}

#endif /* SLICES_FIXTURE_H */
