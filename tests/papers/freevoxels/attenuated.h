/*
 * attenuated.h - attenuation of a volume in memory of its own, and scenes of splats.
 */
#ifndef PAPERS_ATTENUATED_H
#define PAPERS_ATTENUATED_H

#include "papers/paper.h"

/* A set with one direction. */
#define ONLY(direction) ((uint32_t)1 << (direction))

/* The coarsest level that is shown. */
enum { coarsest_level = 5 };

/* The bytes of level 0 and, where wanted, of those that are made of it (equation 7). */
typedef struct attenuated {
    qv_attenuation level[coarsest_level + 1];
    uint8_t *bytes[coarsest_level + 1];
} attenuated;

void attenuated_make(attenuated *made, const qv_volume *volume, uint32_t directions,
                     uint8_t coarsest);
void attenuated_free(attenuated *made);

/* The byte of a voxel of level 0 for the lowest of its directions. */
uint8_t attenuated_byte(const attenuated *of, unsigned x, unsigned y, unsigned z);

/* The directions around a vector in voxels: those between which the library looks for light. */
uint32_t directions_around(const double v[3]);

/* World axes, which for cubic voxels are a volume's: from a view to the viewer. */
void to_viewer(double v[3], const qv_view *view);

/* Splats of a volume by equation 10, with a smooth kernel, between the directions around the
   viewer. */
void splat_scene_make(qv_splat_scene *scene, const qv_volume *volume, const paper_view *view);

#endif /* PAPERS_ATTENUATED_H */
