/*
 * frame.c - renders strips; threads share nothing but the queue of strips.
 */
#define _POSIX_C_SOURCE 200809L

#include "frame.h"
#include "error.h"
#include "parallel.h"

#include <stdlib.h>
#include <string.h>
#include <time.h>

#define STRIP_ROWS 16
/* A ray takes at most 2^23 samples, so 256 pixels do not wrap the counters of
   the library, which are modulo 2^32, more than once. */
#define PIECE_PIXELS 256

struct tally {
    uint64_t samples;
    uint64_t skipped;
    uint64_t terminated;
    struct slice_range slices;
};

struct strips {
    const struct frame *frame;
    const qv_context *context;
    const struct slicing *slicing; /* null: rays */
    uint32_t rows;
    struct tally *tallies; /* one for each strip */
};

/* Differences modulo 2^32 are exact: a piece takes fewer than 2^32 samples. */
static void count_piece(struct tally *tally, const qv_progress *before, const qv_progress *after)
{
    tally->samples += (uint32_t)(after->samples - before->samples);
    tally->skipped += (uint32_t)(after->skipped - before->skipped);
    tally->terminated += (uint32_t)(after->terminated - before->terminated);
}

static void render_rays(const qv_image *image, const qv_context *context, const qv_rect *rect,
                        struct tally *tally)
{
    qv_progress progress = {0};
    qv_status status;
    do {
        qv_progress before = progress;
        status = qv_render_some(image, &progress, context, rect, PIECE_PIXELS);
        count_piece(tally, &before, &progress);
    } while (status == QV_MORE);
    if (status != QV_OK) {
        data_error("frame", NULL, "%s", qv_status_text(status));
    }
}

/* One strip into its own rows of the frame; runs on any thread. */
static void render_strip(void *argument, uint32_t piece)
{
    const struct strips *strips = argument;
    const struct frame *frame = strips->frame;
    uint32_t top = piece * strips->rows;
    uint32_t rows = frame->height - top < strips->rows ? frame->height - top : strips->rows;
    size_t offset = top / pixel_format_lines(frame->format) * frame->row_bytes;
    size_t bytes = pixel_format_rows(frame->format, rows) * frame->row_bytes;
    qv_rect rect = {0, (int32_t)top, (int32_t)frame->width, (int32_t)(top + rows)};
    qv_image image = {frame->bytes + offset, bytes, (ptrdiff_t)frame->row_bytes,
                      frame->format->format};
    struct tally *tally = &strips->tallies[piece];
    if (strips->slicing != NULL) {
        tally->slices = slicing_render(&image, strips->slicing, strips->context, &rect);
    } else {
        render_rays(&image, strips->context, &rect, tally);
    }
}

/* A strip shares no byte with the next. */
static uint32_t strip_rows(const struct frame *frame, const struct settings *settings)
{
    uint32_t lines = pixel_format_lines(frame->format);
    uint32_t rows = settings->strip != 0 ? settings->strip : STRIP_ROWS;
    if (rows % lines != 0) {
        usage_error("--strip", "%s packs %u rows in a byte, so rows must be a multiple",
                    frame->format->name, lines);
    }
    return rows;
}

/* Alpha is kept where the background leaves any. */
static const struct pixel_format *chosen_format(const struct settings *settings)
{
    const char *by_default = settings->background[3] == 255 ? "rgb888" : "rgba8888";
    return pixel_format_find("--format", settings->format != NULL ? settings->format : by_default);
}

void frame_create(struct frame *frame, const struct settings *settings)
{
    memset(frame, 0, sizeof *frame);
    frame->format = chosen_format(settings);
    frame->width = settings->size[0];
    frame->height = settings->size[1];
    frame->row_bytes = qv_row_bytes(frame->format->format, (uint16_t)frame->width);
    frame->byte_count = frame->row_bytes * pixel_format_rows(frame->format, frame->height);
    strip_rows(frame, settings);
    frame->bytes = allocate(frame->byte_count, "frame", "size");
}

void frame_free(struct frame *frame)
{
    free(frame->bytes);
}

double seconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

static void add_tally(struct frame *frame, const struct tally *tally)
{
    frame->samples += tally->samples;
    frame->skipped += tally->skipped;
    frame->terminated += tally->terminated;
    slice_range_join(&frame->slices, tally->slices);
}

void frame_render(struct frame *frame, const qv_scene *scene, const struct slicing *slicing,
                  const struct settings *settings)
{
    qv_context context;
    struct strips strips = {frame, &context, slicing, 0, NULL};
    unsigned threads = scene->volume.pages != NULL ? 1 : settings->threads; /* one uses pages */
    struct parallel work = {render_strip, &strips, 0, threads,
                            progress_label(settings->quiet, "rendering")};
    double start = seconds_now();
    qv_init(&context, scene); /* checked when the scene was made */
    strips.rows = strip_rows(frame, settings);
    work.pieces = (frame->height + strips.rows - 1) / strips.rows;
    strips.tallies = allocate(work.pieces * sizeof *strips.tallies, "frame", "size");
    parallel_run(&work);
    for (uint32_t i = 0; i < work.pieces; i++) {
        add_tally(frame, &strips.tallies[i]);
    }
    free(strips.tallies);
    frame->seconds = seconds_now() - start;
}
