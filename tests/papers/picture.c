/*
 * picture.c - pictures of the papers: rendered, compared and written.
 */
#include "paper.h"

#include "pixels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Rendering ------------------------------------------------------------ */

/* A pixel format of the tests' own: every bit of the finished pixel. */
static void store_all(uint8_t *row, uint32_t column, uint32_t line, const qv_pixel *pixel)
{
    (void)line;
    memcpy(row + sizeof pixel->channel * column, pixel->channel, sizeof pixel->channel);
}

static const qv_format format_all = {store_all, 128, 0};

void paper_picture_make(paper_picture *made, uint32_t width, uint32_t height)
{
    made->width = width;
    made->height = height;
    made->rgba = paper_memory((size_t)width * height, sizeof made->rgba[0]);
}

void paper_picture_free(paper_picture *made)
{
    free(made->rgba);
    made->rgba = NULL;
}

static size_t pixels_of(const paper_picture *picture)
{
    return (size_t)picture->width * picture->height;
}

/* Memory for finished pixels of a frame. */
static qv_image frame_make(uint32_t width, uint32_t height)
{
    const size_t pixel = 4 * sizeof(uint32_t);
    const qv_image image = {paper_memory((size_t)width * height, pixel),
                            (size_t)width * height * pixel, (ptrdiff_t)(width * pixel),
                            &format_all};
    return image;
}

/* Turns them into a picture, and frees their memory. */
static void frame_finish(paper_picture *made, const qv_image *frame, uint32_t width,
                         uint32_t height)
{
    const double one = 255.0 * 65536;
    uint32_t(*const levels)[4] = frame->pixels;
    paper_picture_make(made, width, height);
    for (size_t i = 0; i < pixels_of(made); i++) {
        for (int channel = 0; channel < 4; channel++) {
            made->rgba[i][channel] = levels[i][channel] / one;
        }
    }
    free(levels);
}

void paper_render(paper_picture *made, const qv_scene *scene, uint32_t width, uint32_t height)
{
    const qv_rect rect = {0, 0, (int32_t)width, (int32_t)height};
    const qv_image frame = frame_make(width, height);
    qv_context context;
    const qv_status status = qv_init(&context, scene);
    paper_require(status == QV_OK, qv_status_text(status));
    paper_require(qv_render(&frame, &context, &rect) == QV_OK, "cannot render");
    frame_finish(made, &frame, width, height);
}

/* Back to front or front to back, as the blend is. */
static void blend_slices(const qv_buffer *buffer, const qv_dither *dither,
                         const qv_context *context, const qv_rect *rect)
{
    const bool front_to_back = buffer->blend == &qv_under_rgb888 ||
                               buffer->blend == &qv_under_rgb16 || buffer->blend == &qv_under_rgb24;
    int32_t first, end;
    paper_require(qv_slice_range(&first, &end, context, rect) == QV_OK, "cannot count slices");
    paper_require(qv_clear(buffer, context, rect) == QV_OK, "cannot clear");
    for (int32_t i = first; i < end; i++) {
        const int32_t k = front_to_back ? i : first + end - 1 - i;
        const qv_status status = qv_slice(buffer, dither, context, rect, k);
        paper_require(status == QV_OK, qv_status_text(status));
    }
}

void paper_render_slices(paper_picture *made, const qv_scene *scene, const qv_blend *blend,
                         const qv_dither *dither, uint32_t width, uint32_t height)
{
    const qv_rect rect = {0, 0, (int32_t)width, (int32_t)height};
    const qv_image frame = frame_make(width, height);
    const size_t pixels = (size_t)width * height;
    const qv_buffer buffer = {paper_memory(pixels, blend->bytes),
                              paper_memory(pixels, blend->beside + 1u),
                              pixels * blend->bytes,
                              pixels * blend->beside,
                              (ptrdiff_t)(width * blend->bytes),
                              (ptrdiff_t)(width * blend->beside),
                              blend};
    qv_context context;
    const qv_status status = qv_init(&context, scene);
    paper_require(status == QV_OK, qv_status_text(status));
    blend_slices(&buffer, dither, &context, &rect);
    paper_require(qv_read_out(&frame, &buffer, &context, &rect) == QV_OK, "cannot read out");
    frame_finish(made, &frame, width, height);
    free(buffer.pixels);
    free(buffer.beside);
}

void paper_splat(paper_picture *made, const qv_splat_scene *scene, const qv_volume *level,
                 const qv_attenuation *attenuation)
{
    const uint16_t width = scene->view.width, height = scene->view.height;
    const uint16_t *size = level->size;
    const qv_block all = {{0, 0, 0}, {size[0], size[1], size[2]}};
    const qv_image frame = frame_make(width, height);
    const size_t count = (size_t)width * height * QV_SUM_CHANNELS;
    const qv_sums sums = {paper_memory(count, sizeof(uint32_t)), count, {0, 0, width, height}};
    qv_splats splats;
    const qv_status status = qv_splat_init(&splats, scene);
    paper_require(status == QV_OK, qv_status_text(status));
    paper_require(qv_sums_clear(&sums, &splats) == QV_OK, "cannot clear sums");
    paper_require(qv_splat_block(&sums, &splats, level, attenuation, scene->level, &all) == QV_OK,
                  "cannot splat");
    paper_require(qv_sums_read_out(&frame, &sums, &splats) == QV_OK, "cannot read out sums");
    frame_finish(made, &frame, width, height);
    free(sums.sums);
}

void paper_render_ray(double rgba[4], const qv_scene *scene)
{
    paper_picture pixel;
    paper_render(&pixel, scene, 1, 1);
    memcpy(rgba, pixel.rgba[0], sizeof pixel.rgba[0]);
    paper_picture_free(&pixel);
}

void paper_reference_ray(double rgba[4], const qv_scene *scene, ref_mode mode)
{
    ref_pixel pixel;
    ref_render(&pixel, scene, mode, 0, 0);
    memcpy(rgba, pixel.rgba, sizeof pixel.rgba);
}

static uint32_t thinned(uint32_t length)
{
    return (length + paper_lattice - 1) / paper_lattice;
}

void paper_render_reference(paper_picture *made, const qv_scene *scene, ref_mode mode,
                            uint32_t width, uint32_t height)
{
    paper_picture_make(made, thinned(width), thinned(height));
    for (uint32_t y = 0; y < made->height; y++) {
        for (uint32_t x = 0; x < made->width; x++) {
            ref_pixel pixel;
            ref_render(&pixel, scene, mode, (int32_t)(x * paper_lattice),
                       (int32_t)(y * paper_lattice));
            memcpy(made->rgba[x + (size_t)y * made->width], pixel.rgba, sizeof pixel.rgba);
        }
    }
}

void paper_thin_out(paper_picture *made, const paper_picture *from)
{
    paper_picture_make(made, thinned(from->width), thinned(from->height));
    for (uint32_t y = 0; y < made->height; y++) {
        for (uint32_t x = 0; x < made->width; x++) {
            const size_t at = ((size_t)y * from->width + x) * paper_lattice;
            memcpy(made->rgba[x + (size_t)y * made->width], from->rgba[at], sizeof from->rgba[0]);
        }
    }
}

/* ---- Comparison ----------------------------------------------------------- */

void paper_difference(paper_picture *made, const paper_picture *a, const paper_picture *b)
{
    paper_picture_make(made, a->width, a->height);
    for (size_t i = 0; i < pixels_of(made); i++) {
        for (int channel = 0; channel < 3; channel++) {
            made->rgba[i][channel] = fabs(a->rgba[i][channel] - b->rgba[i][channel]);
        }
        made->rgba[i][3] = 1;
    }
}

double paper_rms(const paper_picture *a, const paper_picture *b)
{
    double sum = 0, channels = 0;
    for (size_t i = 0; i < pixels_of(a); i++) {
        for (int channel = 0; channel < 3 && a->rgba[i][3] > 0; channel++) {
            sum += pow(255 * (a->rgba[i][channel] - b->rgba[i][channel]), 2);
            channels++;
        }
    }
    return channels > 0 ? sqrt(sum / channels) : 0;
}

enum { brightness_levels = 4096 };

static unsigned brightness(const double rgba[4])
{
    return ref_level(ref_grey(rgba), brightness_levels - 1);
}

/* Level 0 stays black and counts for nothing: it is where the pictures agree. */
void paper_equalise(paper_picture *picture)
{
    size_t below[brightness_levels] = {0}, all = 0;
    for (size_t i = 0; i < pixels_of(picture); i++) {
        below[brightness(picture->rgba[i])]++;
    }
    for (unsigned level = 1; level < brightness_levels; level++) {
        all += below[level];
        below[level] = all;
    }
    for (size_t i = 0; i < pixels_of(picture); i++) {
        const unsigned level = brightness(picture->rgba[i]);
        const double rank = level == 0 ? 0 : (double)below[level] / (double)all;
        for (int channel = 0; channel < 3; channel++) {
            picture->rgba[i][channel] = rank;
        }
    }
}

/* ---- Files ---------------------------------------------------------------- */

void paper_write_picture(const char *folder, const char *name, const paper_picture *picture)
{
    char file_name[FILENAME_MAX];
    (void)snprintf(file_name, sizeof file_name, "%s.ppm", name);
    FILE *file = paper_open(folder, file_name);
    fprintf(file, "P6\n%u %u\n255\n", (unsigned)picture->width, (unsigned)picture->height);
    for (size_t i = 0; i < pixels_of(picture); i++) {
        for (int channel = 0; channel < 3; channel++) {
            fputc((int)ref_level(picture->rgba[i][channel], 255), file);
        }
    }
    paper_close(file);
}
