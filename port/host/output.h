/*
 * output.h - files that appear whole or not at all.
 *
 * An output is written to a temporary file beside its target and renamed when
 * everything has succeeded. "-" is standard output; a target that exists and is
 * no regular file (a device, a pipe), or is standard output by another name, is
 * written directly. A link stays: what it leads to is replaced. A large output may
 * be mapped into memory and written in place.
 */
#ifndef QVOL_HOST_OUTPUT_H
#define QVOL_HOST_OUTPUT_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct output {
    const char *target; /* as the user named it */
    char *path;         /* what the target leads to; null: there is nothing yet */
    char *temporary;    /* null: written directly */
    FILE *stream;
    void *map; /* of output_map; else null */
    size_t map_bytes;
} output;

void output_open(output *out, const char *target);

/* Writes bytes; a failure is a data error that names the target. */
void output_write(output *out, const void *bytes, size_t count);

/* The memory of an output that is to have so many bytes, zeroed; in place of output_write. A data
   error where the disk is full or the target is no regular file. */
void *output_map(output *out, uint64_t bytes);

/* Flushes, checks and closes; gives the file its name. */
void output_commit(output *out);

/* A name that is removed at exit, on a signal too: an unfinished output or the
   copy of standard input. Takes over the string. */
void remove_at_exit(char *path);

bool is_standard_stream(const char *name);

/* Before any file is opened: none gets the number of a standard stream that was
   closed, or the report would end up in the picture. */
void claim_standard_streams(void);

#endif
