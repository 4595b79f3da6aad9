/*
 * slicing.h - how slices are blended: the library's names for what the settings ask for.
 */
#ifndef QVOL_HOST_SLICING_H
#define QVOL_HOST_SLICING_H

#include "advice.h"

struct slicing {
    const qv_blend *blend; /* of the picture, and of its chunks and bricks */
    qv_dither dither;
    int kind;     /* enum dither_kind, never auto */
    int sequence; /* enum sequence_kind; SEQUENCE_ROUNDED where none is read */
    bool front_to_back;
    uint32_t chunk; /* slices; 0: all */
    uint32_t bricks[3];
    bool in_bricks;
    struct advice advice;
};

/* The scene is complete. */
void slicing_create(struct slicing *slicing, const qv_scene *scene,
                    const struct settings *settings);

/* Slices first <= k < end. */
struct slice_range {
    int32_t first, end;
};

/* Adds those of another range, which may be empty, and all between. */
void slice_range_join(struct slice_range *range, struct slice_range other);

/* Draws a rectangle by slices; tells which of them it met. Runs on any thread. */
struct slice_range slicing_render(const qv_image *image, const struct slicing *slicing,
                                  const qv_context *context, const qv_rect *rect);

#endif
