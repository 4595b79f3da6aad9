/*
 * settings_cache.h - the options of voxels that come through pages.
 */
#ifndef QVOL_HOST_SETTINGS_CACHE_H
#define QVOL_HOST_SETTINGS_CACHE_H

#include "settings.h"

void set_cache(struct settings *settings, const char *option, const char *value);
void set_page(struct settings *settings, const char *option, const char *value);

#endif
