/*
 * subject.h - what the pyramids are made of.
 */
#ifndef PAPERS_SUBJECT_H
#define PAPERS_SUBJECT_H

#include "papers/paper.h"

/* A volume of opacities for a length of 1, the view of it, and how many coarser levels to
   show. */
typedef struct subject {
    const char *name;
    paper_volume made;
    paper_view view;
    uint8_t levels;
    uint8_t kept; /* the channel that coarser levels should keep: 3 opacity, 0 red */
} subject;

/* Spheres one voxel thick: closed, of opacity 1/2; and half of one, of opacity 0.98. */
void make_shell(subject *made);
void make_dome(subject *made);

/* The head of Debian's mricron-data: all red light is the skin's, and behind it is blue. */
void make_head(subject *made);

#endif /* PAPERS_SUBJECT_H */
