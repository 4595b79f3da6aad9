/*
 * splat_ranks.h - the command splat on all ranks.
 */
#ifndef QVOL_MPI_SPLAT_RANKS_H
#define QVOL_MPI_SPLAT_RANKS_H

#include "settings.h"

/* All ranks call it with the same settings. Returns the exit status. */
int splat_on_ranks(const struct settings *settings);

#endif
