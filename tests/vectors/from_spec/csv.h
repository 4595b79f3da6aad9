/*
 * csv.h - a stage's vectors as tests/vectors/README.md lays them out in a CSV: `id,flags`
 * and the fields, in decimal.
 *
 * A field is an input, which a stage reads, or a result, which it computes in every row.
 * The program ends where a field is both or neither: results are never read.
 */
#ifndef CSV_H
#define CSV_H

#include <stdbool.h>
#include <stdio.h>

#include "number.h"

enum { FIELDS_MAX = 1024, LINE_BYTES = 1 << 16, NAME_BYTES = 64 };

enum field_role { ROLE_UNKNOWN, ROLE_INPUT, ROLE_RESULT };

typedef struct csv {
    FILE *from, *to;
    unsigned fields; /* id and flags are none */
    char header[LINE_BYTES], line[LINE_BYTES];
    const char *name[FIELDS_MAX];
    enum field_role role[FIELDS_MAX];
    /* Of the row: as it is read, and what is computed. */
    const char *id, *flags, *text[FIELDS_MAX];
    number result[FIELDS_MAX];
    unsigned long rows;
} csv;

/* Reads the first line and writes it. */
void csv_open(csv *c, FILE *from, FILE *to);
bool csv_next(csv *c); /* false at the end */
void csv_write(csv *c);
void csv_close(csv *c); /* every field has a role */

/* A field of the row. Its name is a format: in(c, "w%u", q). */
number in(csv *c, const char *format, ...);
void out(csv *c, number value, const char *format, ...);

#endif /* CSV_H */
