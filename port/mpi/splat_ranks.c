/*
 * splat_ranks.c - every rank maps the file and draws its voxels; the sums meet at rank 0.
 */
#include "splat_ranks.h"
#include "error.h"
#include "frame_file.h"
#include "freevoxel_header.h"
#include "ranks.h"
#include "report_splat.h"
#include "splat_frame.h"
#include "splat_scene.h"

#include <stdlib.h>
#include <string.h>

/* The picture on one rank. */
struct drawing {
    struct frame frame;
    struct freevoxel_file file;
    struct view view;
    qv_splats splats;
    qv_sums sums;
    struct share share;
};

/* What the ranks have drawn, at rank 0. */
struct work {
    uint64_t *voxels;
    double *seconds;
};

/* Of each level, the voxels whose index modulo the ranks is this rank's (section 4.4 of the
   paper); of a part of the voxels, the same among those of the part. */
static struct share share_of_rank(const struct settings *settings)
{
    uint32_t part = settings->splat.parts != 0 ? settings->splat.part - 1 : 0;
    uint32_t parts = settings->splat.parts != 0 ? settings->splat.parts : 1;
    if (parts > UINT32_MAX / ranks_count()) {
        usage_error("--part", "%u parts for %u ranks are too many", parts, ranks_count());
    }
    return (struct share){part + parts * ranks_own(), parts * ranks_count(), 0, 1};
}

static void prepare(struct drawing *drawing, const struct settings *settings)
{
    if (settings->splat.splatting == SPLATTING_OVER) {
        usage_error("--splatting", "over needs all voxels in one order; qvol splat has it");
    }
    drawing->share = share_of_rank(settings);
    frame_create(&drawing->frame, settings);
    freevoxel_file_open(&drawing->file, settings->operands[0]);
    splat_scene_create(&drawing->splats, &drawing->view, &drawing->file, settings);
    sums_create(&drawing->sums, &drawing->frame, &drawing->splats);
}

/* A machine's copy of another file would leave holes in the picture, and sums of another frame
   cannot be added. */
static void compare_with_first(const struct drawing *drawing)
{
    const struct freevoxel_file *file = &drawing->file;
    const uint32_t own[] = {
        (uint32_t)little_get(file->bytes + FREEVOXEL_AT_CHECKSUM, sizeof(uint32_t)),
        drawing->frame.width,
        drawing->frame.height,
    };
    uint32_t first[sizeof own / sizeof own[0]];
    memcpy(first, own, sizeof first);
    ranks_share(first, sizeof first / sizeof first[0]);
    if (own[0] != first[0]) {
        data_error(file->name, "checksum", "is not that of the file of rank 0");
    }
    if (memcmp(own, first, sizeof own) != 0) {
        usage_error("--size", "is not that of rank 0");
    }
}

/* The first rank hears of all others' work. */
static void draw(struct drawing *drawing, struct work *work)
{
    double start = seconds_now(), seconds;
    uint64_t voxels =
        splat_records(&drawing->sums, &drawing->splats, &drawing->file, &drawing->share);
    seconds = seconds_now() - start;
    work->voxels = allocate(ranks_count() * sizeof *work->voxels, "ranks", NULL);
    work->seconds = allocate(ranks_count() * sizeof *work->seconds, "ranks", NULL);
    ranks_agree();
    ranks_add_sums(&drawing->sums);
    drawing->frame.seconds = seconds_now() - start;
    ranks_gather(work->voxels, voxels);
    ranks_gather_seconds(work->seconds, seconds);
}

static void report_ranks(struct json *json, const struct work *work)
{
    json_array(json, "ranks");
    for (uint32_t i = 0; i < ranks_count(); i++) {
        json_object(json, NULL);
        json_unsigned(json, "voxels_with_opacity", work->voxels[i]);
        json_decimal(json, "seconds", work->seconds[i]);
        json_close(json);
    }
    json_close(json);
}

static void report(const struct drawing *drawing, const struct work *work,
                   const struct settings *settings)
{
    uint64_t drawn = 0;
    struct json json;
    output out;
    for (uint32_t i = 0; i < ranks_count(); i++) {
        drawn += work->voxels[i];
    }
    output_open(&out, settings->json);
    json_begin(&json, &out);
    report_splats(&json, &drawing->file, &drawing->splats, &drawing->view, &drawing->frame, drawn,
                  settings);
    report_ranks(&json, work);
    json_end(&json);
    output_commit(&out);
}

/* The picture gets its name last: where it is, its report is too. */
static void write_picture(struct drawing *drawing, const struct work *work, picture_writer *writer,
                          const struct settings *settings)
{
    output picture;
    splat_frame_finish(&drawing->frame, &drawing->sums, &drawing->splats);
    output_open(&picture, settings->output);
    frame_file_write(&picture, &drawing->frame, writer);
    if (settings->json != NULL) {
        report(drawing, work, settings);
    }
    output_commit(&picture);
}

int splat_on_ranks(const struct settings *settings)
{
    picture_writer *writer = frame_file_writer(settings);
    struct drawing drawing;
    struct work work;
    prepare(&drawing, settings);
    ranks_agree();
    compare_with_first(&drawing);
    ranks_agree();
    draw(&drawing, &work);
    if (ranks_own() == 0) {
        write_picture(&drawing, &work, writer, settings);
    }
    ranks_agree();
    free(work.voxels);
    free(work.seconds);
    sums_free(&drawing.sums);
    frame_free(&drawing.frame);
    freevoxel_file_close(&drawing.file);
    return EXIT_SUCCESS;
}
