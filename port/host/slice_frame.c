/*
 * slice_frame.c - draws slices into a frame buffer, through chunks and bricks where asked for.
 */
#include "bricks.h"
#include "error.h"
#include "slicing.h"

#include <stdlib.h>
#include <string.h>

/* What a tile does not see it does not pay for. A multiple of 8: each starts with a byte of
   every pixel format. */
#define TILE_COLUMNS 32

/* A rectangle, and what it is drawn into. */
struct tile {
    const struct slicing *slicing;
    const qv_scene *scene;
    qv_context clear; /* of parts: nothing stands behind them */
    qv_rect rect;
    qv_buffer picture, brick, chunk;
    struct slice_range met;
};

static void check(qv_status status)
{
    if (status < 0) {
        data_error("frame", "slices", "%s", qv_status_text(status));
    }
}

static void buffer_create(qv_buffer *buffer, const qv_blend *blend, const qv_rect *rect)
{
    size_t height = (size_t)(rect->bottom - rect->top);
    memset(buffer, 0, sizeof *buffer);
    buffer->blend = blend;
    buffer->stride = TILE_COLUMNS * blend->bytes;
    buffer->beside_stride = TILE_COLUMNS * blend->beside;
    buffer->bytes = (size_t)buffer->stride * height;
    buffer->beside_bytes = (size_t)buffer->beside_stride * height;
    buffer->pixels = allocate(buffer->bytes, "frame", "slices");
    buffer->beside = allocate(buffer->beside_bytes, "frame", "slices");
}

static void buffer_free(qv_buffer *buffer)
{
    free(buffer->pixels);
    free(buffer->beside);
}

void slice_range_join(struct slice_range *range, struct slice_range other)
{
    if (other.first == other.end) {
        return;
    }
    if (range->first == range->end) {
        *range = other;
    }
    range->first = other.first < range->first ? other.first : range->first;
    range->end = other.end > range->end ? other.end : range->end;
}

static void draw_slices(const qv_buffer *buffer, const struct tile *tile, const qv_context *context,
                        int32_t first, int32_t end)
{
    const struct slicing *slicing = tile->slicing;
    for (int32_t i = 0; i < end - first; i++) {
        int32_t slice = slicing->front_to_back ? first + i : end - 1 - i;
        check(qv_slice(buffer, &slicing->dither, context, &tile->rect, slice));
    }
}

/* Rounds down, for negative slices too. */
static int32_t chunk_of(int32_t slice, int32_t slices)
{
    return slice >= 0 ? slice / slices : -1 - (-1 - slice) / slices;
}

/* Chunks are counted from slice 0 on, so that every tile has the same ones. */
static void draw_chunks(const qv_buffer *buffer, const struct tile *tile, const qv_context *context,
                        int32_t first, int32_t end)
{
    int32_t slices = (int32_t)tile->slicing->chunk;
    while (first < end) {
        int32_t number = chunk_of(end - 1, slices);
        int32_t nearest = number * slices > first ? number * slices : first;
        check(qv_clear(&tile->chunk, &tile->clear, &tile->rect));
        draw_slices(&tile->chunk, tile, context, nearest, end);
        check(qv_combine(buffer, &tile->chunk, &tile->slicing->dither, &tile->rect, number));
        end = nearest;
    }
}

/* Slices of a volume or a brick; false where the tile sees none. */
static bool draw_volume(const qv_buffer *buffer, struct tile *tile, const qv_context *context)
{
    int32_t first, end;
    check(qv_slice_range(&first, &end, context, &tile->rect));
    if (first == end) {
        return false;
    }
    if (tile->slicing->chunk != 0) {
        draw_chunks(buffer, tile, context, first, end);
    } else {
        draw_slices(buffer, tile, context, first, end);
    }
    slice_range_join(&tile->met, (struct slice_range){first, end});
    return true;
}

/* Like slices they are counted from the nearest on. */
static void draw_bricks(struct tile *tile)
{
    const struct slicing *slicing = tile->slicing;
    uint32_t bricks = slicing->bricks[0] * slicing->bricks[1] * slicing->bricks[2];
    for (uint32_t number = 0; number < bricks; number++) {
        qv_scene scene;
        qv_context context;
        brick_scene(&scene, tile->scene, slicing->bricks, number);
        check(qv_init(&context, &scene));
        check(qv_clear(&tile->brick, &tile->clear, &tile->rect));
        if (draw_volume(&tile->brick, tile, &context)) {
            check(qv_combine(&tile->picture, &tile->brick, &slicing->dither, &tile->rect,
                             (int32_t)(bricks - 1 - number)));
        }
    }
}

static void draw_tile(const qv_image *image, struct tile *tile, const qv_context *context)
{
    check(qv_clear(&tile->picture, context, &tile->rect));
    if (tile->slicing->in_bricks) {
        draw_bricks(tile);
    } else {
        draw_volume(&tile->picture, tile, context);
    }
    check(qv_read_out(image, &tile->picture, context, &tile->rect));
}

/* The part of an image from a column on. */
static qv_image image_from(const qv_image *image, uint32_t column)
{
    size_t offset = (size_t)column * image->format->bits / 8;
    qv_image part = *image;
    part.pixels = (uint8_t *)image->pixels + offset;
    part.bytes -= offset;
    return part;
}

static void tile_create(struct tile *tile, const struct slicing *slicing, const qv_context *context,
                        const qv_rect *rect)
{
    qv_scene scene = context->scene;
    memset(tile, 0, sizeof *tile);
    memset(scene.background, 0, sizeof scene.background);
    check(qv_init(&tile->clear, &scene));
    tile->slicing = slicing;
    tile->scene = &context->scene;
    tile->rect = *rect;
    buffer_create(&tile->picture, slicing->blend, rect);
    buffer_create(&tile->brick, slicing->blend, rect);
    buffer_create(&tile->chunk, slicing->blend, rect);
}

struct slice_range slicing_render(const qv_image *image, const struct slicing *slicing,
                                  const qv_context *context, const qv_rect *rect)
{
    struct tile tile;
    tile_create(&tile, slicing, context, rect);
    for (int32_t left = rect->left; left < rect->right; left += TILE_COLUMNS) {
        qv_image part = image_from(image, (uint32_t)(left - rect->left));
        tile.rect.left = left;
        tile.rect.right = rect->right - left < TILE_COLUMNS ? rect->right : left + TILE_COLUMNS;
        draw_tile(&part, &tile, context);
    }
    buffer_free(&tile.picture);
    buffer_free(&tile.brick);
    buffer_free(&tile.chunk);
    return tile.met;
}
