/*
 * report.h - the resolved scene as JSON: every number that determines the
 * picture, so that anyone can compute it again, and what rendering took.
 */
#ifndef QVOL_HOST_REPORT_H
#define QVOL_HOST_REPORT_H

#include "frame.h"
#include "paging.h"
#include "report_model.h"
#include "scene.h"

/* Where the viewer is, and what became of the picture: of rays, slices and splats. */
void report_view(struct json *json, const struct view *view);
void report_frame(struct json *json, const uint8_t background[4], const struct frame *frame);

/* Levels are reported where the scene has a pyramid, pages where the volume has; slicing: null for
   rays. */
void report_scene(output *out, const struct model *model, const qv_scene *scene,
                  const struct levels *levels, const struct paging *paging, const struct view *view,
                  const struct slicing *slicing, const struct frame *frame,
                  const struct settings *settings);

#endif
