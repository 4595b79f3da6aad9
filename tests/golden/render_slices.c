/*
 * render_slices.c - a golden scene by slices, in four ways: the frame buffer, what lies beside
 * it, the same of a chunk's, and the picture that is read out.
 */
#include "scenes.h"

/* Memory with a row for each row of the rectangle's pixels. */
typedef struct plane {
    uint8_t *top;
    ptrdiff_t stride;
    size_t row_bytes;
} plane;

enum { PIXELS, BESIDE, PLANES_OF_BUFFER };

/* All that a scene's slices go through. */
typedef struct frame {
    const golden_scene *golden;
    qv_context context, transparent; /* without a background, for chunks */
    plane behind[PLANES_OF_BUFFER], front[PLANES_OF_BUFFER], picture;
    int32_t middle; /* the slice to hand out */
} frame;

/* ---- Memory --------------------------------------------------------------- */

/* Takes a plane off the memory that is left. */
static void place(plane *p, uint8_t **left, const golden_scene *golden, size_t row_bytes,
                  int32_t rows)
{
    p->row_bytes = row_bytes;
    p->stride = (ptrdiff_t)row_bytes + (ptrdiff_t)golden->padding;
    p->top = *left;
    *left += p->stride * rows;
    if (golden->bottom_up) {
        p->top += p->stride * (rows - 1);
        p->stride = -p->stride;
    }
}

static void place_buffer(plane planes[PLANES_OF_BUFFER], uint8_t **left, const golden_scene *golden,
                         const golden_blend *blend)
{
    const qv_rect *rect = &golden->rect;
    size_t width = (size_t)(rect->right - rect->left);
    int32_t height = rect->bottom - rect->top;
    place(&planes[PIXELS], left, golden, width * QV_FIELD(blend->blend, bytes), height);
    place(&planes[BESIDE], left, golden, width * QV_FIELD(blend->blend, beside), height);
}

static qv_status place_all(frame *f, golden_memory *memory)
{
    const golden_scene *golden = f->golden;
    const qv_rect *rect = &golden->rect;
    const qv_format *format = golden_find_format(golden);
    int32_t lines = 1 << QV_FIELD(format, line_shift), height = rect->bottom - rect->top;
    uint8_t *left = memory->pixels;
    place_buffer(f->behind, &left, golden, golden->slices.blend);
    if (golden->slices.front)
        place_buffer(f->front, &left, golden, golden->slices.front);
    place(&f->picture, &left, golden,
          (size_t)qv_row_bytes(format, (uint16_t)(rect->right - rect->left)),
          (height + lines - 1) / lines);
    golden_untouch(memory);
    return left <= memory->pixels + sizeof memory->pixels ? QV_OK : QV_ERROR_BUFFER;
}

/* Where a part of the rectangle lies, and exactly the bytes that it needs. */
static size_t cut(void **at, const plane *p, const qv_rect *rect, const qv_rect *part,
                  unsigned pixel_bytes)
{
    ptrdiff_t between = p->stride < 0 ? -p->stride : p->stride;
    int32_t rows = part->bottom - part->top, columns = part->right - part->left;
    *at = p->top + (part->top - rect->top) * p->stride +
          (ptrdiff_t)(part->left - rect->left) * (ptrdiff_t)pixel_bytes;
    return (size_t)((rows - 1) * between) + (size_t)columns * pixel_bytes;
}

static qv_buffer buffer_of(const plane planes[PLANES_OF_BUFFER], const golden_blend *blend,
                           const qv_rect *rect, const qv_rect *part)
{
    qv_buffer buffer = {.stride = planes[PIXELS].stride,
                        .beside_stride = planes[BESIDE].stride,
                        .blend = blend->blend};
    buffer.bytes = cut(&buffer.pixels, &planes[PIXELS], rect, part, QV_FIELD(blend->blend, bytes));
    buffer.beside_bytes =
        cut(&buffer.beside, &planes[BESIDE], rect, part, QV_FIELD(blend->blend, beside));
    return buffer;
}

/* ---- Slices --------------------------------------------------------------- */

/* Blends first <= k < end in the order of the blend. */
static qv_status add_slices(const frame *f, const qv_buffer *buffer, golden_direction direction,
                            const qv_rect *part, int32_t first, int32_t end)
{
    qv_status status = QV_OK;
    for (int32_t i = 0; i < end - first && status == QV_OK; i++) {
        int32_t slice = direction == GOLDEN_UNDER ? first + i : end - 1 - i;
        status = qv_slice(buffer, &f->golden->slices.dither, &f->context, part, slice);
    }
    return status;
}

/* The chunk's slices in a buffer of their own, which is then put in front, and cleared. */
static qv_status add_chunk(const frame *f, const qv_buffer *behind, const qv_buffer *front,
                           const qv_rect *part, int32_t first)
{
    const golden_slicing *slices = &f->golden->slices;
    qv_status status =
        add_slices(f, front, slices->front->direction, part, first, first + slices->chunk);
    if (status == QV_OK)
        status = qv_combine(behind, front, &slices->dither, part, first);
    return status == QV_OK ? qv_clear(front, &f->transparent, part) : status;
}

/* Chunks begin at multiples of their length, so that all parts have the same. */
static qv_status add_chunks(const frame *f, const qv_buffer *behind, const qv_rect *part,
                            int32_t first, int32_t end)
{
    qv_buffer front = buffer_of(f->front, f->golden->slices.front, &f->golden->rect, part);
    int32_t chunk = f->golden->slices.chunk, left = first % chunk;
    int32_t nearest = first - (left < 0 ? left + chunk : left);
    int32_t at = nearest + (end - 1 - nearest) / chunk * chunk;
    qv_status status = qv_clear(&front, &f->transparent, part);
    for (; at >= nearest && status == QV_OK; at -= chunk)
        status = add_chunk(f, behind, &front, part, at);
    return status;
}

static qv_status render_part(const frame *f, const qv_rect *part)
{
    const golden_slicing *slices = &f->golden->slices;
    qv_buffer behind = buffer_of(f->behind, slices->blend, &f->golden->rect, part);
    int32_t first, end;
    qv_status status = qv_slice_range(&first, &end, &f->context, part);
    if (status == QV_OK)
        status = qv_clear(&behind, &f->context, part);
    if (status != QV_OK)
        return status;
    if (slices->blend->direction == GOLDEN_HAND_OUT)
        return qv_slice(&behind, &slices->dither, &f->context, part, f->middle);
    if (slices->front)
        return add_chunks(f, &behind, part, first, end);
    return add_slices(f, &behind, slices->blend->direction, part, first, end);
}

/* ---- The picture ---------------------------------------------------------- */

static qv_status render_parts(const frame *f, int32_t width, int32_t height)
{
    const qv_rect *whole = &f->golden->rect;
    qv_status status = QV_OK;
    for (int32_t y = whole->top; y < whole->bottom; y += height)
        for (int32_t x = whole->left; x < whole->right && status == QV_OK; x += width) {
            qv_rect part = {x, y, x + width, y + height};
            part.right = part.right < whole->right ? part.right : whole->right;
            part.bottom = part.bottom < whole->bottom ? part.bottom : whole->bottom;
            status = render_part(f, &part);
        }
    return status;
}

static qv_status render_way(const frame *f, golden_way way)
{
    const qv_rect *rect = &f->golden->rect;
    int32_t width = rect->right - rect->left;
    switch (way) {
    case GOLDEN_STRIPS:
        return render_parts(f, width, f->golden->strip);
    case GOLDEN_ROWS:
        return render_parts(f, width, 1);
    case GOLDEN_PIECES:
        return render_parts(f, f->golden->piece, f->golden->strip);
    default:
        return render_parts(f, width, rect->bottom - rect->top);
    }
}

static qv_status read_out(const frame *f)
{
    const qv_rect *rect = &f->golden->rect;
    qv_buffer behind = buffer_of(f->behind, f->golden->slices.blend, rect, rect);
    const qv_format *format = golden_find_format(f->golden);
    ptrdiff_t between = f->picture.stride < 0 ? -f->picture.stride : f->picture.stride;
    int32_t gaps = (rect->bottom - rect->top - 1) >> QV_FIELD(format, line_shift);
    qv_image image = {f->picture.top, (size_t)(gaps * between) + f->picture.row_bytes,
                      f->picture.stride, format};
    return qv_read_out(&image, &behind, &f->context, rect);
}

/* Both contexts, and the slice in the middle of what is seen. */
static qv_status look(frame *f, golden_memory *memory)
{
    qv_scene scene;
    int32_t first, end;
    qv_status status = golden_make(&scene, memory, f->golden);
    if (status == QV_OK)
        status = qv_init(&f->context, &scene);
    for (unsigned channel = 0; channel < 4; channel++)
        scene.background[channel] = 0;
    if (status == QV_OK)
        status = qv_init(&f->transparent, &scene);
    if (status == QV_OK)
        status = qv_slice_range(&first, &end, &f->context, &f->golden->rect);
    if (status == QV_OK)
        f->middle = first + (end - first) / 2;
    return status;
}

qv_status golden_render_slices(uint32_t *checksum, golden_memory *memory,
                               const golden_scene *golden, golden_way way)
{
    frame f = {.golden = golden};
    qv_status status = look(&f, memory);
    if (status == QV_OK)
        status = place_all(&f, memory);
    if (status == QV_OK)
        status = render_way(&f, way);
    if (status == QV_OK)
        status = read_out(&f);
    if (status == QV_OK)
        *checksum = golden_checksum(memory);
    return status;
}
