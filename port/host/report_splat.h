/*
 * report_splat.h - a picture of splats as JSON: every number that determines it.
 */
#ifndef QVOL_HOST_REPORT_SPLAT_H
#define QVOL_HOST_REPORT_SPLAT_H

#include "frame.h"
#include "freevoxel_file.h"
#include "json.h"
#include "scene.h"

void report_splats(struct json *json, const struct freevoxel_file *file, const qv_splats *splats,
                   const struct view *view, const struct frame *frame, uint64_t drawn,
                   const struct settings *settings);

#endif
