/*
 * splat_frame.c - each thread adds its share of the voxels to sums of its own: sums of integers
 * do not depend on who added what.
 */
#include "splat_frame.h"
#include "error.h"
#include "parallel.h"
#include "splat_over.h"

#include <stdlib.h>
#include <string.h>

/* Long enough to read memory in order, short enough that shares are alike. */
#define RUN_RECORDS 4096

static void check(qv_status status, const char *name)
{
    if (status < 0) {
        data_error(name, "frame", "%s", qv_status_text(status));
    }
}

void sums_create(qv_sums *sums, const struct frame *frame, const qv_splats *splats)
{
    uint64_t count = (uint64_t)frame->width * frame->height * QV_SUM_CHANNELS;
    sums->sums = allocate(count * sizeof *sums->sums, "frame", "sums");
    sums->count = (size_t)count;
    sums->rect = (qv_rect){0, 0, (int32_t)frame->width, (int32_t)frame->height};
    check(qv_sums_clear(sums, splats), "sums");
}

void sums_free(qv_sums *sums)
{
    free(sums->sums);
}

/* The records of a run that have opacity. */
static uint64_t splat_run(const qv_sums *sums, const qv_splats *splats,
                          const struct freevoxel_file *file, uint8_t level, uint64_t first,
                          uint64_t end, uint32_t stride)
{
    uint64_t drawn = 0;
    for (uint64_t index = first; index < end; index += stride) {
        struct freevoxel_record record;
        if (freevoxel_file_is_clear(file, level, index)) {
            continue;
        }
        freevoxel_file_record(&record, file, level, index);
        check(qv_splat(sums, splats, &record.voxel), file->name);
        drawn++;
    }
    return drawn;
}

/* Indices stay below 2^36 + 2^12 * 2^32 * 2^8, in 64 bits. */
static uint64_t splat_level(const qv_sums *sums, const qv_splats *splats,
                            const struct freevoxel_file *file, uint8_t level,
                            const struct share *share)
{
    uint64_t voxels = file->header.levels[level].voxels;
    uint64_t run = (uint64_t)share->stride * RUN_RECORDS;
    uint64_t drawn = 0;
    for (uint64_t first = share->first + run * share->worker; first < voxels;
         first += run * share->workers) {
        uint64_t end = voxels - first < run ? voxels : first + run;
        drawn += splat_run(sums, splats, file, level, first, end, share->stride);
    }
    return drawn;
}

uint64_t splat_records(const qv_sums *sums, const qv_splats *splats,
                       const struct freevoxel_file *file, const struct share *share)
{
    uint64_t drawn = 0;
    for (unsigned l = splats->scene.level; l <= splats->scene.coarsest; l++) {
        drawn += splat_level(sums, splats, file, (uint8_t)l, share);
    }
    return drawn;
}

void splat_frame_finish(struct frame *frame, const qv_sums *sums, const qv_splats *splats)
{
    qv_image image = {frame->bytes, frame->byte_count, (ptrdiff_t)frame->row_bytes,
                      frame->format->format};
    check(qv_sums_read_out(&image, sums, splats), "sums");
}

struct worker {
    qv_sums sums;
    uint64_t drawn;
};

struct workers {
    struct worker *workers;
    unsigned count;
    const struct frame *frame;
    const struct freevoxel_file *file;
    const qv_splats *splats;
    const struct splat_settings *settings;
};

static void work(void *context, uint32_t piece)
{
    const struct workers *w = context;
    struct worker *worker = &w->workers[piece];
    struct share share = {0, 1, piece, w->count};
    if (w->settings->parts != 0) {
        share.first = w->settings->part - 1;
        share.stride = w->settings->parts;
    }
    sums_create(&worker->sums, w->frame, w->splats);
    worker->drawn = splat_records(&worker->sums, w->splats, w->file, &share);
}

/* All sums become those of the first worker. */
static uint64_t join(struct workers *w)
{
    uint64_t drawn = w->workers[0].drawn;
    for (unsigned i = 1; i < w->count; i++) {
        check(qv_sums_add(&w->workers[0].sums, &w->workers[i].sums), w->file->name);
        drawn += w->workers[i].drawn;
        sums_free(&w->workers[i].sums);
    }
    return drawn;
}

static uint64_t render_added(struct frame *frame, const struct freevoxel_file *file,
                             const qv_splats *splats, const struct settings *settings)
{
    struct workers w = {
        NULL, parallel_threads(settings->threads), frame, file, splats, &settings->splat};
    struct parallel parallel = {work, &w, w.count, settings->threads,
                                progress_label(settings->quiet, "splatting")};
    uint64_t drawn;
    w.workers = allocate(w.count * sizeof *w.workers, "frame", "threads");
    parallel_run(&parallel);
    drawn = join(&w);
    splat_frame_finish(frame, &w.workers[0].sums, splats);
    sums_free(&w.workers[0].sums);
    free(w.workers);
    return drawn;
}

uint64_t splat_frame_render(struct frame *frame, const struct freevoxel_file *file,
                            const qv_splats *splats, const struct settings *settings)
{
    double start = seconds_now();
    uint64_t drawn;
    if (settings->splat.splatting == SPLATTING_OVER) {
        drawn = splat_over_render(frame, file, splats, settings);
    } else {
        drawn = render_added(frame, file, splats, settings);
    }
    frame->seconds = seconds_now() - start;
    return drawn;
}
