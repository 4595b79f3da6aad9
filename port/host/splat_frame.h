/*
 * splat_frame.h - splats a FreeVoxel file into a frame, on several threads.
 */
#ifndef QVOL_HOST_SPLAT_FRAME_H
#define QVOL_HOST_SPLAT_FRAME_H

#include "frame.h"
#include "freevoxel_file.h"

/* Some of a file's records: first, first + stride and so on, of each level. Workers take runs of
   these in turn. {0, 1, 0, 1} is all. */
struct share {
    uint32_t first, stride;
    uint32_t worker, workers;
};

/* Sums of a whole frame, cleared, in memory of their own. */
void sums_create(qv_sums *sums, const struct frame *frame, const qv_splats *splats);
void sums_free(qv_sums *sums);

/* Adds a share of the records of all levels that the scene shows. Returns how many of them have
   opacity. Runs on any thread. */
uint64_t splat_records(const qv_sums *sums, const qv_splats *splats,
                       const struct freevoxel_file *file, const struct share *share);

/* Turns sums into the frame's pixels. */
void splat_frame_finish(struct frame *frame, const qv_sums *sums, const qv_splats *splats);

/* Draws the file. Returns how many voxels had opacity. */
uint64_t splat_frame_render(struct frame *frame, const struct freevoxel_file *file,
                            const qv_splats *splats, const struct settings *settings);

#endif
