/*
 * settings_slices.h - the options of rendering slice by slice, and what they need.
 */
#ifndef QVOL_HOST_SETTINGS_SLICES_H
#define QVOL_HOST_SETTINGS_SLICES_H

#include "settings.h"

/* 5, 6 and 5 bits of one word. */
#define FRAMEBUFFER_565 565

typedef void option_setter(struct settings *settings, const char *option, const char *value);

option_setter set_compositing, set_framebuffer, set_dither, set_residual, set_sequence, set_period,
    set_slope, set_cutoff, set_frame, set_still, set_chunk, set_slices, set_bricks,
    set_dither_table;

/* Names of the values, for reports as well. */
extern const choice framebuffer_names[];
extern const choice dither_names[];
extern const choice sequence_names[];

/* The values that stand for options that were not given. */
int settings_framebuffer(const struct settings *settings);
int settings_dither(const struct settings *settings);
unsigned settings_residual(const struct settings *settings);

/* What makes opacities of 8 bits: period, slopes and cutoff. */
void settings_alpha(qv_dither *dither, const struct settings *settings);

/* Refuses options that would change nothing, or make no sense together; `groups` are those of
   the command. */
void settings_check_slices(const struct settings *settings, int groups);

#endif
