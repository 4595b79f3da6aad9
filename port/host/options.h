/*
 * options.h - from the command line to settings, and the help made from the
 * same table.
 */
#ifndef QVOL_HOST_OPTIONS_H
#define QVOL_HOST_OPTIONS_H

#include "settings.h"

struct command {
    const char *name;     /* "qvol render" */
    const char *synopsis; /* operands and required options */
    const char *summary;
    const char *details; /* after the options; may be null */
    int groups;          /* enum option_group */
    int operands;        /* exactly so many */
    int (*run)(const struct settings *settings);
};

/* Sets defaults, then reads argv[1] and what follows; argv[0] is the command's own name. --help
   and --version print and end the program. */
void options_read(struct settings *settings, const struct command *command, int argc, char **argv);

/* End the program; a full disk under standard output is an error. */
void finish_output(void) __attribute__((noreturn));
void print_help(const struct command *command) __attribute__((noreturn));
void print_version(void) __attribute__((noreturn));

#endif
