/*
 * table_file.h - text files of rows: a line of column names, then as many cells a line.
 */
#ifndef QVOL_HOST_TABLE_FILE_H
#define QVOL_HOST_TABLE_FILE_H

#include <stddef.h>

struct table_file {
    const char *name; /* for messages */
    char *text;       /* what cells point into */
    char **cells;     /* row by row, the names first */
    size_t columns;
    size_t rows; /* without the names */
};

/* Reads a file, or standard input for "-"; cells end at the separator or with the line. Anything
   else but a full table is a data error that names the line. */
void table_file_read(struct table_file *table, const char *name, char separator);
void table_file_free(struct table_file *table);

const char *table_file_heading(const struct table_file *table, size_t column);
const char *table_file_cell(const struct table_file *table, size_t row, size_t column);

/* The number of a column, or `columns` where there is none of that name. */
size_t table_file_column(const struct table_file *table, const char *heading);

#endif
