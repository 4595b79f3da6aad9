/*
 * settings_freevoxel.h - the options of FreeVoxels: making a file of them, drawing it, light.
 */
#ifndef QVOL_HOST_SETTINGS_FREEVOXEL_H
#define QVOL_HOST_SETTINGS_FREEVOXEL_H

#include "settings.h"

typedef void freevoxel_setter(struct settings *settings, const char *option, const char *value);

freevoxel_setter set_directions, set_voxel_order, set_level_count, set_hierarchy, set_uncorrected;
freevoxel_setter set_splatting, set_kernel, set_interpolation, set_finest_level, set_coarser_levels,
    set_detail, set_part;
freevoxel_setter set_lamp, set_ambient;

/* Names of the values, for reports as well. */
extern const choice voxel_order_names[];
extern const choice hierarchy_names[], interpolation_names[];
extern const choice splatting_names[];
extern const choice kernel_names[];

/* Whether a FreeVoxel file gets levels, as far as the settings tell. */
bool settings_make_levels(const struct settings *settings, int groups);

/* Of --detail, Q8.8. */
uint16_t settings_detail(const struct settings *settings);

/* Refuses options that would change nothing, or make no sense together; `groups` are those of
   the command. */
void settings_check_freevoxel(const struct settings *settings, int groups);

#endif
