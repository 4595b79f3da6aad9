/*
 * sampling.h - which of the library's sampling modes the settings ask for.
 */
#ifndef QVOL_HOST_SAMPLING_H
#define QVOL_HOST_SAMPLING_H

#include "settings.h"

/* The enum sampling_mode, also where --sampling leaves it to the storage. */
int sampling_mode(const struct settings *settings, qv_storage storage);

/* The descriptor, or a usage error where the mode does not read the storage. */
const qv_sampling *sampling_choose(const struct settings *settings, qv_storage storage);

/* Whether it weighs by length; else each sample stands for one step. */
bool sampling_by_length(const struct settings *settings, qv_storage storage);

#endif
