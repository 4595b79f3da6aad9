/*
 * frame.h - the bytes of a whole frame, rendered in strips on several threads.
 */
#ifndef QVOL_HOST_FRAME_H
#define QVOL_HOST_FRAME_H

#include "pixel_format.h"
#include "slicing.h"

struct frame {
    const struct pixel_format *format;
    uint32_t width, height;
    size_t row_bytes; /* no padding */
    size_t byte_count;
    uint8_t *bytes;
    struct slice_range slices; /* that were drawn */
    uint64_t samples;          /* statistics; of rays */
    uint64_t skipped;
    uint64_t terminated;
    double seconds;
};

/* Size, format and memory; usage errors of --format and --strip come here. */
void frame_create(struct frame *frame, const struct settings *settings);

void frame_free(struct frame *frame);

/* Of a clock that is never set back. */
double seconds_now(void);

/* slicing: null for rays. */
void frame_render(struct frame *frame, const qv_scene *scene, const struct slicing *slicing,
                  const struct settings *settings);

#endif
