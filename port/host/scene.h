/*
 * scene.h - the library's scene from settings: angles, zoom and lengths become
 * the integers that determine the picture.
 */
#ifndef QVOL_HOST_SCENE_H
#define QVOL_HOST_SCENE_H

#include "model.h"

struct view {
    qv_view view;
    qv_angle angles[3];     /* azimuth, elevation, roll: what the rotation is made of */
    qv_angle field_of_view; /* 0: orthographic */
};

/* From the plane across the view that first touches a box of this size and spacing to the one that
   leaves it, in world units. */
double scene_depth(const uint16_t size[3], const uint32_t spacing[3],
                   const struct settings *settings);

/* Between samples, Q16.16 world units: that of --step, or what --slices makes of a box of this
   size and spacing. */
uint32_t scene_step(const uint16_t size[3], const uint32_t spacing[3],
                    const struct settings *settings);

/* Every number of the settings becomes the integer that the report prints. */
void view_create(struct view *view, const qv_volume *volume, const struct settings *settings);

/* Fills a zeroed scene in which volume, pyramid and sampling are set. */
void scene_create(qv_scene *scene, struct view *view, const struct model *model,
                  const struct settings *settings);

#endif
