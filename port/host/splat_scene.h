/*
 * splat_scene.h - the library's scene of splats from settings and a FreeVoxel file.
 */
#ifndef QVOL_HOST_SPLAT_SCENE_H
#define QVOL_HOST_SPLAT_SCENE_H

#include "freevoxel_file.h"
#include "scene.h"

/* A checked scene; what cannot be drawn ends the command. */
void splat_scene_create(qv_splats *splats, struct view *view, const struct freevoxel_file *file,
                        const struct settings *settings);

#endif
