/*
 * settings_input.h - the options of files that are read: raw data and palettes.
 */
#ifndef QVOL_HOST_SETTINGS_INPUT_H
#define QVOL_HOST_SETTINGS_INPUT_H

#include "settings.h"

typedef void input_setter(struct settings *settings, const char *option, const char *value);

input_setter set_dims, set_type, set_skip, set_spacing, set_palette, set_endian;

/* Keeps the name of a file or a preset; an empty one is a usage error. */
void settings_keep_name(const char **name, const char *option, const char *value);

#endif
