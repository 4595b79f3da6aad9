/*
 * vector_files.c - finds and reads fields.tsv and the CSV file of a stage.
 */
#include "vector_files.h"
#include "error.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Where make install puts them; the Makefile knows PREFIX. */
#ifndef QVOL_VECTORS
#define QVOL_VECTORS "/usr/local/share/qvol/vectors"
#endif

static void read_from(struct table_file *table, char *path, const struct settings *settings,
                      const char *name, const char *ending, char separator)
{
    const char *folder = settings->from != NULL ? settings->from : QVOL_VECTORS;
    int length = snprintf(path, VECTORS_PATH_BYTES, "%s/%s%s", folder, name, ending);
    if (length < 0 || length >= VECTORS_PATH_BYTES) {
        usage_error("--from", "the name is too long");
    }
    table_file_read(table, path, separator);
}

static void check_fields(const struct table_file *fields)
{
    static const char *const headings[FIELDS] = {"stage", "section", "column",
                                                 "role",  "format",  "text"};
    for (size_t i = 0; i < FIELDS; i++) {
        if (fields->columns != FIELDS || strcmp(table_file_heading(fields, i), headings[i]) != 0) {
            data_error(fields->name, "line 1", "not the columns of qvol's test vectors");
        }
    }
}

/* The first column of a stage; a name that is known is safe as that of a file, too. */
static void find_stage(struct vectors *vectors)
{
    const struct table_file *fields = &vectors->fields;
    size_t row = 0;
    while (row < fields->rows &&
           strcmp(table_file_cell(fields, row, FIELD_STAGE), vectors->stage) != 0) {
        row++;
    }
    if (row == fields->rows) {
        usage_error("stage", "'%s' is none of %s", vectors->stage, fields->name);
    }
    vectors->first_field = row;
}

/* Columns are those of fields.tsv, which has as many rows of the stage. */
static void check_columns(const struct vectors *vectors)
{
    const struct table_file *rows = &vectors->rows;
    bool known = rows->columns > VECTOR_FIRST &&
                 vectors->first_field + rows->columns - VECTOR_FIRST <= vectors->fields.rows &&
                 strcmp(table_file_heading(rows, VECTOR_ID), "id") == 0 &&
                 strcmp(table_file_heading(rows, VECTOR_FLAGS), "flags") == 0;
    for (size_t i = VECTOR_FIRST; known && i < rows->columns; i++) {
        known = strcmp(table_file_heading(rows, i), vectors_field(vectors, i, FIELD_NAME)) == 0 &&
                strcmp(vectors->stage, vectors_field(vectors, i, FIELD_STAGE)) == 0;
    }
    if (!known) {
        data_error(rows->name, "line 1", "not the columns that %s tells", vectors->fields.name);
    }
}

void vectors_open(struct vectors *vectors, const struct settings *settings, const char *stage)
{
    vectors->stage = stage;
    read_from(&vectors->fields, vectors->path[0], settings, "fields", ".tsv", '\t');
    check_fields(&vectors->fields);
    find_stage(vectors);
    read_from(&vectors->rows, vectors->path[1], settings, stage, ".csv", ',');
    check_columns(vectors);
}

void vectors_close(struct vectors *vectors)
{
    table_file_free(&vectors->rows);
    table_file_free(&vectors->fields);
}

bool vectors_find(size_t *row, const struct vectors *vectors, const char *id)
{
    const char *number = strrchr(id, '-');
    if (number == NULL || !isdigit((unsigned char)number[1])) {
        return false;
    }
    *row = (size_t)strtoull(number + 1, NULL, 10); /* row n is STAGE-n */
    return *row < vectors->rows.rows &&
           strcmp(table_file_cell(&vectors->rows, *row, VECTOR_ID), id) == 0;
}

const char *vectors_field(const struct vectors *vectors, size_t column, int which)
{
    return table_file_cell(&vectors->fields, vectors->first_field + column - VECTOR_FIRST,
                           (size_t)which);
}

bool vector_number_read(struct vector_number *number, const char *text)
{
    char *end;
    number->negative = *text == '-';
    text += number->negative;
    bool hexadecimal = text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
    if (!isdigit((unsigned char)*text)) { /* strtoull would pass blanks and signs */
        return false;
    }
    errno = 0;
    number->magnitude = strtoull(text, &end, hexadecimal ? 16 : 10);
    number->negative = number->negative && number->magnitude != 0;
    return errno == 0 && *end == '\0';
}
