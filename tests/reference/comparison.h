/*
 * comparison.h - seeded scenes rendered by the library against the reference.
 */
#ifndef REFERENCE_COMPARISON_H
#define REFERENCE_COMPARISON_H

#include "seeded.h"
#include "tally.h"

/* Which of the reference's cameras: with the library's points, or with ideal ones. */
typedef enum ref_camera { REF_STORED_CAMERA, REF_IDEAL_CAMERA } ref_camera;

/* Renders a scene, complete with its sampling mode, as rgba8888 and tallies the pixels that
   the volume covers in the reference's picture of the expected one, of the same view. Returns
   what the library does. */
qv_status compare_scenes(tally *into, const seeded_scene *made, const seeded_scene *expected,
                         ref_mode mode, ref_camera camera);

/* The same against the scene itself. */
qv_status compare_scene(tally *into, const seeded_scene *made, ref_mode mode, ref_camera camera);

#endif /* REFERENCE_COMPARISON_H */
