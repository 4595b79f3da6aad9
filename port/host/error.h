/*
 * error.h - the ways the command ends early: one line on standard error.
 *
 * Exit status 2: the command line is wrong. Exit status 1: the data are, or a
 * file cannot be read or written. Both remove unfinished outputs on their way.
 */
#ifndef QVOL_HOST_ERROR_H
#define QVOL_HOST_ERROR_H

#define EXIT_DATA  1
#define EXIT_USAGE 2

/* The name before every message, "qvol" until a command is known. */
void error_set_command(const char *name);

/* Who tells the line of an error, and with which exit status the program then ends. Unless another
   is set, this process does, with the status that the error has. */
typedef int error_teller(const char *line, int status);
void error_set_teller(error_teller *teller);

/* "COMMAND: OPTION: reason (see COMMAND --help)" */
void usage_error(const char *option, const char *format, ...)
    __attribute__((noreturn, format(printf, 2, 3)));

/* "COMMAND: FILE: FIELD: reason"; field may be null. */
void data_error(const char *file, const char *field, const char *format, ...)
    __attribute__((noreturn, format(printf, 3, 4)));

/* data_error with the text of errno as the reason. */
void system_error(const char *file, const char *field) __attribute__((noreturn));

/* Zeroed, and never null; `file` and `field` name who asks. */
void *allocate(unsigned long long bytes, const char *file, const char *field);

#endif
