/*
 * ranks.h - the processes of one mpirun, its ranks: they end together, and rank 0 gets what all of
 * them have drawn.
 */
#ifndef QVOL_MPI_RANKS_H
#define QVOL_MPI_RANKS_H

#include "qvol.h"

/* Joins the other ranks; leaves them whenever the program exits. Standard output is rank 0's. */
void ranks_begin(int *argc, char ***argv);

uint32_t ranks_own(void); /* 0 .. ranks_count() - 1 */
uint32_t ranks_count(void);

/*
 * All ranks call this when each has done what may fail by itself. Where one has failed, none comes
 * back: all exit with the status of the first that has, which alone tells its error. So nobody
 * waits for a rank that is not there any more.
 */
void ranks_agree(void);

/* Makes numbers of every rank those of rank 0. */
void ranks_share(uint32_t *numbers, int count);

/* Adds the sums of all ranks, of one rectangle, to those of rank 0. Elsewhere they are only read. */
void ranks_add_sums(const qv_sums *sums);

/* Collects one number of each rank, in their order: to[ranks_count()], of rank 0 alone. */
void ranks_gather(uint64_t *to, uint64_t own);
void ranks_gather_seconds(double *to, double own);

#endif
