/*
 * table_file.c - reads the whole file, and parts it where it lies.
 */
#include "table_file.h"
#include "error.h"
#include "input.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_BYTES ((uint64_t)1 << 32)

static size_t count_of(const char *text, char wanted)
{
    size_t count = 0;
    for (; *text != '\0'; text++) {
        count += *text == wanted;
    }
    return count;
}

/* All of a file, and a null behind it. */
static char *read_text(const char **shown, const char *name)
{
    struct source source;
    source_open(&source, name, MOST_BYTES);
    char *text = allocate(source.bytes + 1, source.name, NULL);
    FILE *file = fopen(source.path, "rb");
    if (file == NULL || fread(text, 1, (size_t)source.bytes, file) != source.bytes) {
        system_error(source.name, NULL);
    }
    fclose(file);
    if (source.more || strlen(text) != source.bytes) {
        data_error(source.name, NULL, source.more ? "longer than 4 GB" : "holds a null byte");
    }
    *shown = source.name;
    return text;
}

/* Ends the line at *next, with or without a carriage return; *next becomes the following one. */
static char *take_line(char **next)
{
    char *line = *next, *end = strchr(line, '\n');
    *next = end == NULL ? line + strlen(line) : end + 1;
    if (end == NULL) {
        end = *next;
    } else {
        *end = '\0';
    }
    if (end > line && end[-1] == '\r') {
        end[-1] = '\0';
    }
    return line;
}

/* Parts a line; `number` counts from 1. */
static void part_line(struct table_file *table, char *line, size_t number, char separator)
{
    char **cell = table->cells + (number - 1) * table->columns;
    size_t found = count_of(line, separator) + 1;
    if (found != table->columns) {
        data_error(table->name, NULL, "line %zu: %zu cells, not %zu", number, found,
                   table->columns);
    }
    for (size_t i = 0; i < table->columns; i++) {
        char *end = strchr(line, separator);
        cell[i] = line;
        if (end != NULL) {
            *end = '\0';
            line = end + 1;
        }
    }
}

void table_file_read(struct table_file *table, const char *name, char separator)
{
    memset(table, 0, sizeof *table);
    table->text = read_text(&table->name, name);
    size_t lines = count_of(table->text, '\n') + 1; /* at most */
    char *next = table->text, *line = take_line(&next);
    table->columns = count_of(line, separator) + 1;
    table->cells = allocate(sizeof(char *) * lines * table->columns, table->name, NULL);
    part_line(table, line, 1, separator);
    while (*next != '\0') {
        line = take_line(&next);
        part_line(table, line, ++table->rows + 1, separator);
    }
}

void table_file_free(struct table_file *table)
{
    free(table->cells);
    free(table->text);
}

const char *table_file_heading(const struct table_file *table, size_t column)
{
    return table->cells[column];
}

const char *table_file_cell(const struct table_file *table, size_t row, size_t column)
{
    return table->cells[(row + 1) * table->columns + column];
}

size_t table_file_column(const struct table_file *table, const char *heading)
{
    size_t column = 0;
    while (column < table->columns && strcmp(table->cells[column], heading) != 0) {
        column++;
    }
    return column;
}
