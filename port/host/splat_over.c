/*
 * splat_over.c - the order matters here, so that threads share the frame, not the voxels.
 */
#include "splat_over.h"
#include "error.h"
#include "parallel.h"
#include "voxel_storage.h"

#include <stdlib.h>
#include <string.h>

struct strips {
    const qv_sums *sums; /* of the whole frame */
    uint32_t rows;       /* of a strip */
    const struct freevoxel_file *file;
    const qv_splats *splats;
    qv_volume level; /* its voxels, x fastest */
    uint8_t number;
};

/* The level as a volume of its own, without voxels. */
static void describe(qv_volume *volume, const struct freevoxel_file *file, uint8_t number)
{
    const struct freevoxel_level *level = &file->header.levels[number];
    *volume = file->header.volume;
    volume->storage = level->storage;
    if (!storage_is_indexed((qv_storage)level->storage)) {
        volume->palette = NULL;
        volume->palette_bytes = 0;
    }
    for (unsigned a = 0; a < 3; a++) {
        volume->size[a] = level->size[a];
    }
    volume->stride[0] = level->voxel_bytes;
    volume->stride[1] = volume->stride[0] * level->size[0]; /* at most 2^15 */
    volume->stride[2] = volume->stride[1] * level->size[1]; /* at most 2^27 */
    volume->voxels_bytes = level->voxels * level->voxel_bytes;
}

/* Takes a level's voxels out of their records, whatever the file's order. Returns how many of
   them have opacity. */
static uint64_t unpack(uint8_t *voxels, const qv_volume *volume, const struct freevoxel_file *file,
                       uint8_t number)
{
    const struct freevoxel_level *level = &file->header.levels[number];
    uint64_t drawn = 0;
    for (uint64_t index = 0; index < level->voxels; index++) {
        struct freevoxel_record record;
        uint64_t place = 0;
        freevoxel_file_record(&record, file, number, index);
        for (unsigned a = 0; a < 3; a++) {
            place += (uint64_t)volume->stride[a] * record.voxel.position[a];
        }
        memcpy(voxels + place, record.voxel.voxel, level->voxel_bytes);
        drawn += !freevoxel_file_is_clear(file, number, index);
    }
    return drawn;
}

/* The rows of one strip; the sums of a frame are rows without gaps. */
static void draw_strip(void *context, uint32_t piece)
{
    const struct strips *s = context;
    const qv_rect *frame = &s->sums->rect;
    int32_t top = (int32_t)(piece * s->rows);
    int32_t bottom =
        frame->bottom - top < (int32_t)s->rows ? frame->bottom : top + (int32_t)s->rows;
    size_t row = (size_t)frame->right * QV_SUM_CHANNELS;
    qv_sums sums = {s->sums->sums + (size_t)top * row,
                    (size_t)(bottom - top) * row,
                    {0, top, frame->right, bottom}};
    qv_block all = {{0, 0, 0}, {s->level.size[0], s->level.size[1], s->level.size[2]}};
    qv_attenuation attenuation;
    qv_status status;
    freevoxel_file_attenuation(&attenuation, s->file, s->number);
    status = qv_splat_block(&sums, s->splats, &s->level, &attenuation, s->number, &all);
    if (status < 0) {
        data_error(s->file->name, "frame", "%s", qv_status_text(status));
    }
}

uint64_t splat_over_render(struct frame *frame, const struct freevoxel_file *file,
                           const qv_splats *splats, const struct settings *settings)
{
    qv_sums sums;
    struct strips strips = {&sums, 0, file, splats, {0}, splats->scene.level};
    struct parallel work = {draw_strip, &strips, parallel_threads(settings->threads),
                            settings->threads, progress_label(settings->quiet, "splatting")};
    uint8_t *voxels;
    uint64_t drawn;
    describe(&strips.level, file, strips.number);
    voxels = allocate(strips.level.voxels_bytes, file->name, "voxels");
    drawn = unpack(voxels, &strips.level, file, strips.number);
    strips.level.voxels = voxels;
    strips.rows = (frame->height + work.pieces - 1) / work.pieces;
    work.pieces = (frame->height + strips.rows - 1) / strips.rows;
    sums_create(&sums, frame, splats);
    parallel_run(&work);
    splat_frame_finish(frame, &sums, splats);
    sums_free(&sums);
    free(voxels);
    return drawn;
}
