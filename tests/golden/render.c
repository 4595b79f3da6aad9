/*
 * render.c - a golden scene as one picture, rendered in four ways.
 */
#include "scenes.h"
#include "crc32.h"

/* What the pixels hold before: neither black nor white nor a likely result. */
enum { UNTOUCHED = 0xA5 };

const char *const golden_way_name[GOLDEN_WAYS] = {
    [GOLDEN_WHOLE] = "whole",
    [GOLDEN_STRIPS] = "strips",
    [GOLDEN_ROWS] = "rows",
    [GOLDEN_PIECES] = "pieces",
};

const qv_format *golden_find_format(const golden_scene *golden)
{
    static const qv_format *const table[GOLDEN_FORMATS] = {
        [GOLDEN_RGBA8888] = &qv_format_rgba8888,
        [GOLDEN_BGRA8888] = &qv_format_bgra8888,
        [GOLDEN_RGB888] = &qv_format_rgb888,
        [GOLDEN_RGB565_LE] = &qv_format_rgb565_le,
        [GOLDEN_RGB565_BE] = &qv_format_rgb565_be,
        [GOLDEN_L8] = &qv_format_l8,
        [GOLDEN_GREY4] = &qv_format_grey4,
        [GOLDEN_MONO_HORIZONTAL] = &qv_format_mono_horizontal,
        [GOLDEN_MONO_VERTICAL] = &qv_format_mono_vertical,
    };
    return table[golden->format];
}

void golden_view(qv_view *view, const golden_scene *golden)
{
    view->pitch = golden->pitch;
    view->step = golden->step;
    view->width = golden->width;
    view->height = golden->height;
    qv_rotation(view->rotation, golden->azimuth, golden->elevation, golden->roll);
}

static qv_status point_camera(qv_scene *scene, const golden_scene *golden)
{
    qv_view view;
    golden_view(&view, golden);
    if (golden->field_of_view == 0)
        return qv_orthographic(&scene->camera, &scene->volume, &view);
    return qv_perspective(&scene->camera, &scene->volume, &view, golden->field_of_view);
}

qv_status golden_make(qv_scene *scene, golden_memory *memory, const golden_scene *golden)
{
    *scene = (qv_scene){.sampling = golden->mode->sampling,
                        .phase = golden->phase,
                        .termination = golden->termination,
                        .level = golden->level,
                        .level_distance = golden->level_distance};
    for (unsigned channel = 0; channel < 4; channel++)
        scene->background[channel] = golden->background[channel];
    qv_status status = golden_volume(&scene->volume, memory, golden);
    if (status == QV_OK && golden->mode->order == GOLDEN_LEVELS) {
        status = golden_pyramid(memory, &scene->volume, golden);
        scene->pyramid = &memory->pyramid;
    }
    if (status == QV_OK)
        status = point_camera(scene, golden);
    return status == QV_OK && memory->change ? memory->change(scene, memory) : status;
}

void golden_untouch(golden_memory *memory)
{
    for (size_t i = 0; i < sizeof memory->pixels; i++)
        memory->pixels[i] = UNTOUCHED;
}

uint32_t golden_checksum(const golden_memory *memory)
{
    return crc32_update(0, memory->pixels, sizeof memory->pixels);
}

/* The picture's place in memory->pixels. */
typedef struct picture {
    uint8_t *top;
    ptrdiff_t stride;
    size_t row_bytes;
    int32_t rows;          /* rows of bytes */
    int32_t lines_per_row; /* rows of pixels that share one */
} picture;

static qv_status place_picture(picture *p, golden_memory *memory, const golden_scene *golden)
{
    const qv_rect *rect = &golden->rect;
    const qv_format *format = golden_find_format(golden);
    p->lines_per_row = 1 << QV_FIELD(format, line_shift);
    p->rows = (rect->bottom - rect->top + p->lines_per_row - 1) / p->lines_per_row;
    p->row_bytes = (size_t)qv_row_bytes(format, (uint16_t)(rect->right - rect->left));
    p->stride = (ptrdiff_t)p->row_bytes + (ptrdiff_t)golden->padding;
    p->top = memory->pixels;
    if ((size_t)(p->stride * p->rows) > sizeof memory->pixels)
        return QV_ERROR_BUFFER;
    if (golden->bottom_up) {
        p->top += p->stride * (p->rows - 1);
        p->stride = -p->stride;
    }
    golden_untouch(memory);
    return QV_OK;
}

/* The part of the picture from one row of bytes to another, and its pixels. */
static void cut(qv_image *image, qv_rect *rect, const picture *p, const golden_scene *golden,
                int32_t first, int32_t end)
{
    ptrdiff_t between = p->stride < 0 ? -p->stride : p->stride;
    if (end > p->rows)
        end = p->rows;
    image->pixels = p->top + first * p->stride;
    image->bytes = (size_t)((end - first - 1) * between) + p->row_bytes;
    image->stride = p->stride;
    image->format = golden_find_format(golden);
    *rect = golden->rect;
    rect->top = golden->rect.top + first * p->lines_per_row;
    if (end < p->rows)
        rect->bottom = golden->rect.top + end * p->lines_per_row;
}

static qv_status draw_strips(const picture *p, const golden_scene *golden, int32_t height,
                             golden_part *draw, void *user)
{
    qv_status status = QV_OK;
    for (int32_t row = 0; row < p->rows && status == QV_OK; row += height) {
        qv_image image;
        qv_rect rect;
        cut(&image, &rect, p, golden, row, row + height);
        status = draw(user, &image, &rect);
    }
    return status;
}

qv_status golden_draw_parts(golden_memory *memory, const golden_scene *golden, int32_t height,
                            golden_part *draw, void *user)
{
    picture p;
    qv_status status = place_picture(&p, memory, golden);
    return status == QV_OK ? draw_strips(&p, golden, height == 0 ? p.rows : height, draw, user)
                           : status;
}

static qv_status draw_rays(void *context, const qv_image *image, const qv_rect *rect)
{
    return qv_render(image, context, rect);
}

static qv_status draw_pieces(golden_memory *memory, const qv_context *context,
                             const golden_scene *golden)
{
    picture p;
    qv_image image;
    qv_rect rect;
    qv_progress progress = {0};
    qv_status status = place_picture(&p, memory, golden);
    if (status != QV_OK)
        return status;
    cut(&image, &rect, &p, golden, 0, p.rows);
    do {
        status = qv_render_some(&image, &progress, context, &rect, golden->piece);
    } while (status == QV_MORE);
    return status;
}

static qv_status render_way(golden_memory *memory, qv_context *context, const golden_scene *golden,
                            golden_way way)
{
    switch (way) {
    case GOLDEN_STRIPS:
        return golden_draw_parts(memory, golden, golden->strip, draw_rays, context);
    case GOLDEN_ROWS:
        return golden_draw_parts(memory, golden, 1, draw_rays, context);
    case GOLDEN_PIECES:
        return draw_pieces(memory, context, golden);
    default:
        return golden_draw_parts(memory, golden, 0, draw_rays, context);
    }
}

qv_status golden_render_scene(uint32_t *checksum, golden_memory *memory, const golden_scene *golden,
                              const qv_scene *scene, golden_way way)
{
    qv_context context;
    qv_status status = qv_init(&context, scene);
    if (status == QV_OK)
        status = render_way(memory, &context, golden, way);
    if (status == QV_OK)
        *checksum = golden_checksum(memory);
    return status;
}

qv_status golden_render_rays(uint32_t *checksum, golden_memory *memory, const golden_scene *golden,
                             golden_way way)
{
    qv_scene scene;
    qv_status status = golden_make(&scene, memory, golden);
    return status == QV_OK ? golden_render_scene(checksum, memory, golden, &scene, way) : status;
}
