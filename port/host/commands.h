/*
 * commands.h - what the command can do. Each returns the exit status.
 */
#ifndef QVOL_HOST_COMMANDS_H
#define QVOL_HOST_COMMANDS_H

#include "options.h"

int command_render(const struct settings *settings);
int command_info(const struct settings *settings);
int command_compare(const struct settings *settings);
int command_classify(const struct settings *settings);
int command_pyramid(const struct settings *settings);
int command_freevoxel(const struct settings *settings);
int command_splat(const struct settings *settings);
int command_advise(const struct settings *settings);
int command_vectors_check(const struct settings *settings);
int command_vectors_show(const struct settings *settings);

#endif
