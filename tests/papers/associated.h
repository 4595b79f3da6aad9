/*
 * associated.h - section 7 of Wittenbrink et al. 1998: what is left of a colour that is weighted by
 * its opacity when it is stored, in 8 bits.
 */
#ifndef PAPERS_ASSOCIATED_H
#define PAPERS_ASSOCIATED_H

#include "paper.h"

/* All 256 colours at an opacity of 1 .. 255, weighted and divided again. */
typedef struct associated_colours {
    double off, exact; /* levels: the worst of the library, and of real numbers rounded once */
    unsigned distinct; /* stored colours that differ */
} associated_colours;

associated_colours associate_colours(unsigned opacity);

#endif /* PAPERS_ASSOCIATED_H */
