/*
 * paged.h - golden scenes whose voxels come through pages: the same pictures.
 */
#ifndef GOLDEN_PAGED_H
#define GOLDEN_PAGED_H

#include "scenes.h"

/* Shapes of bricks, each with so many pages: from as few as there may be to all. */
enum { GOLDEN_CACHES = 9 };

/* What the last scene has read. */
extern qv_pages golden_pages;

/* Whether there is such a mode through pages: there is none for pyramids. */
bool golden_is_paged(const golden_mode *mode);

/* Chooses the cache for the scenes to come. */
void golden_choose_cache(unsigned number, const golden_mode *mode);

/* Takes the voxels away from a scene and leaves pages. */
golden_change golden_page;

#endif /* GOLDEN_PAGED_H */
