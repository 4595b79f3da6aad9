/*
 * command_splat.c - from a FreeVoxel file to a picture.
 */
#include "commands.h"
#include "frame_file.h"
#include "report_splat.h"
#include "splat_frame.h"
#include "splat_scene.h"

#include <stdlib.h>

/* The picture gets its name last: where it is, its report is too. */
int command_splat(const struct settings *settings)
{
    picture_writer *writer = frame_file_writer(settings);
    struct freevoxel_file file;
    struct frame frame;
    struct view view;
    qv_splats splats;
    output picture, report;
    struct json json;
    uint64_t drawn;
    frame_create(&frame, settings);
    freevoxel_file_open(&file, settings->operands[0]);
    splat_scene_create(&splats, &view, &file, settings);
    drawn = splat_frame_render(&frame, &file, &splats, settings);
    output_open(&picture, settings->output);
    frame_file_write(&picture, &frame, writer);
    if (settings->json != NULL) {
        output_open(&report, settings->json);
        json_begin(&json, &report);
        report_splats(&json, &file, &splats, &view, &frame, drawn, settings);
        json_end(&json);
        output_commit(&report);
    }
    output_commit(&picture);
    frame_free(&frame);
    freevoxel_file_close(&file);
    return EXIT_SUCCESS;
}
