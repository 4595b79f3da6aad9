/*
 * error.c - one line on standard error, then the end.
 */
#define _POSIX_C_SOURCE 200809L

#include "error.h"

#include <errno.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LINE_BYTES 1024

static int tell(const char *line, int status)
{
    fprintf(stderr, "%s\n", line);
    return status;
}

static const char *command = "qvol";
static error_teller *teller = tell;

/* Never unlocked: of threads that find the same error, one tells it. */
static pthread_mutex_t ending = PTHREAD_MUTEX_INITIALIZER;

void error_set_command(const char *name)
{
    command = name;
}

void error_set_teller(error_teller *other)
{
    teller = other;
}

/* Names of files and texts of libraries may hold line breaks or control
   characters: one error stays one printable line. */
static void end(char *line, int status) __attribute__((noreturn));
static void end(char *line, int status)
{
    pthread_mutex_lock(&ending);
    for (char *c = line; *c != '\0'; c++) {
        if ((unsigned char)*c < ' ' || *c == 127) {
            *c = '?';
        }
    }
    exit(teller(line, status));
}

/* What does not fit in the line is cut off. */
static void append(char *line, const char *text)
{
    size_t used = strlen(line);
    snprintf(line + used, LINE_BYTES - used, "%s", text);
}

static void append_formatted(char *line, const char *format, va_list arguments)
{
    size_t used = strlen(line);
    vsnprintf(line + used, LINE_BYTES - used, format, arguments);
}

void usage_error(const char *option, const char *format, ...)
{
    char line[LINE_BYTES];
    va_list arguments;
    snprintf(line, sizeof line, "%s: %s: ", command, option);
    va_start(arguments, format);
    append_formatted(line, format, arguments);
    va_end(arguments);
    append(line, " (see ");
    append(line, command);
    append(line, " --help)");
    end(line, EXIT_USAGE);
}

void data_error(const char *file, const char *field, const char *format, ...)
{
    char line[LINE_BYTES];
    va_list arguments;
    snprintf(line, sizeof line, "%s: %s: ", command, file);
    if (field != NULL) {
        append(line, field);
        append(line, ": ");
    }
    va_start(arguments, format);
    append_formatted(line, format, arguments);
    va_end(arguments);
    end(line, EXIT_DATA);
}

void system_error(const char *file, const char *field)
{
    data_error(file, field, "%s", strerror(errno));
}

void *allocate(unsigned long long bytes, const char *file, const char *field)
{
    void *memory = bytes <= SIZE_MAX ? calloc(bytes > 0 ? (size_t)bytes : 1, 1) : NULL;
    if (memory == NULL) {
        data_error(file, field, "no memory for %llu bytes", bytes);
    }
    return memory;
}
