/*
 * settings_advise.h - the options of qvol advise.
 */
#ifndef QVOL_HOST_SETTINGS_ADVISE_H
#define QVOL_HOST_SETTINGS_ADVISE_H

#include "settings.h"

typedef void advise_setter(struct settings *settings, const char *option, const char *value);

advise_setter set_target, set_error, set_rms, set_against, set_voxel_bytes, set_opacity,
    set_content;

/* Whether a frame buffer is asked for, by any option of it; else rays are. */
bool settings_advise_buffer(const struct settings *settings);

/* Refuses what is missing, or makes no sense together. */
void settings_check_advise(const struct settings *settings);

#endif
