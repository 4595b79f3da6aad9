/*
 * head.h - the head of Debian's mricron-data as a volume.
 */
#ifndef PAPERS_FREEVOXELS_HEAD_H
#define PAPERS_FREEVOXELS_HEAD_H

#include "papers/paper.h"

/* Voxels of 16-bit RGBA of the scan, reduced by a factor on each axis; opacities are for a voxel
   of the scan, which is 1 long. */
void head_make(paper_volume *made, const qv_transfer *transfer, unsigned factor);

/* A skin that light hardly enters. */
void skin_transfer(qv_transfer *made);

/* Skin like glass over a brain. */
void glass_transfer(qv_transfer *made);

#endif /* PAPERS_FREEVOXELS_HEAD_H */
