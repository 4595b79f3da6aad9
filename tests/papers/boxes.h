/*
 * boxes.h - the scenes corner, graze and phase of Wittenbrink et al. 1998 (figures 7 and 10 to 12).
 *
 * The paper gives neither volumes nor views, so these are our own: one box of a
 * single material in air, seen on a corner, along a face, and almost straight on.
 * Air is black and transparent, as in the paper.
 */
#ifndef PAPERS_BOXES_H
#define PAPERS_BOXES_H

#include "paper.h"

enum { BOX_SCENES = 3, box_coarse = 32, box_fine = 128 /* voxels an axis */ };

typedef struct box_scene {
    const char *name;
    double low[3], high[3];     /* the box, 0 .. 1 of the volume */
    bool antialiased[3];        /* axes whose faces are the principal ones */
    double azimuth, elevation;  /* degrees */
    double width;               /* of the frame, in volumes */
    const char *paper_ratio[2]; /* RMS error of 32^3 to 128^3 in the paper, antialiased last */
} box_scene;

extern const box_scene box_scenes[BOX_SCENES];

/* Its volume of n^3 voxels, antialiased or not, is `box_coarse` world units long whatever n. */
void box_make(paper_volume *made, const box_scene *of, unsigned n, bool antialiased);

/* The scene's view of it, at a step of one world unit, in a square frame. */
void box_look(qv_scene *scene, const paper_volume *made, const box_scene *of, uint16_t edge);

#endif /* PAPERS_BOXES_H */
