/*
 * command_vectors.c - compares somebody's results with the test vectors of a stage, and explains
 * one of them.
 */
#include "commands.h"
#include "error.h"
#include "json.h"
#include "vector_explain.h"
#include "vector_files.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXIT_DIFFERENT 1

/* ---- Comparison --------------------------------------------------------------- */

/* Results, and which column of the truth each of their columns is. */
struct results {
    bool *seen; /* of each row of the truth, whether there is a result */
    struct table_file table;
    size_t *truth;
    size_t id;     /* its column */
    size_t fields; /* those that are compared */
};

/* The first field that differs, in the order of the results. */
struct first_difference {
    bool found;
    size_t row, column; /* of the results */
    const char *expected;
};

static void find_columns(struct results *results, const struct vectors *vectors)
{
    const struct table_file *table = &results->table;
    results->truth = allocate(sizeof(size_t) * table->columns, table->name, NULL);
    results->id = table_file_column(table, "id");
    if (results->id == table->columns) {
        data_error(table->name, "line 1", "no column id");
    }
    for (size_t i = 0; i < table->columns; i++) {
        const char *heading = table_file_heading(table, i);
        results->truth[i] = table_file_column(&vectors->rows, heading);
        if (results->truth[i] == vectors->rows.columns) {
            data_error(table->name, heading, "no column of the stage %s", vectors->stage);
        }
        if (table_file_column(table, heading) != i) {
            data_error(table->name, heading, "two columns of that name");
        }
        results->fields += results->truth[i] >= VECTOR_FIRST;
    }
    if (results->fields == 0 || table->rows == 0) {
        data_error(table->name, NULL, results->fields == 0 ? "no column beside id" : "no rows");
    }
}

static bool is_equal(const struct results *results, size_t row, size_t column, const char *expected)
{
    struct vector_number wanted, given;
    const char *text = table_file_cell(&results->table, row, column);
    if (!vector_number_read(&given, text)) {
        data_error(results->table.name, table_file_heading(&results->table, column),
                   "line %zu: '%s' is no whole number of 64 bits", row + 2, text);
    }
    return vector_number_read(&wanted, expected) && wanted.negative == given.negative &&
           wanted.magnitude == given.magnitude;
}

static void compare_row(struct first_difference *first, const struct results *results, size_t row,
                        const struct vectors *vectors, size_t truth)
{
    for (size_t i = 0; i < results->table.columns; i++) {
        if (results->truth[i] < VECTOR_FIRST) {
            continue;
        }
        const char *expected = table_file_cell(&vectors->rows, truth, results->truth[i]);
        if (!is_equal(results, row, i, expected) && !first->found) {
            *first = (struct first_difference){true, row, i, expected};
        }
    }
}

/* Every row is read, so that what is no number is told wherever it stands. */
static void compare(struct first_difference *first, struct results *results,
                    const struct vectors *vectors)
{
    const struct table_file *table = &results->table;
    results->seen = allocate(vectors->rows.rows + 1, table->name, NULL);
    for (size_t row = 0; row < table->rows; row++) {
        const char *id = table_file_cell(table, row, results->id);
        size_t truth;
        if (!vectors_find(&truth, vectors, id)) {
            data_error(table->name, "id", "line %zu: '%s' is no row of %s", row + 2, id,
                       vectors->rows.name);
        }
        if (results->seen[truth]) {
            data_error(table->name, "id", "line %zu: '%s' stands there twice", row + 2, id);
        }
        results->seen[truth] = true;
        compare_row(first, results, row, vectors, truth);
    }
}

static void print_comparison(const struct first_difference *first, const struct results *results,
                             const struct vectors *vectors)
{
    const struct table_file *table = &results->table;
    if (first->found) {
        printf("%s: %s: expected %s, found %s\n", table_file_cell(table, first->row, results->id),
               table_file_heading(table, first->column), first->expected,
               table_file_cell(table, first->row, first->column));
    } else {
        printf("%s: %zu of %zu rows, %zu columns: equal\n", vectors->stage, table->rows,
               vectors->rows.rows, results->fields);
    }
}

static void write_report(const struct first_difference *first, const struct results *results,
                         const struct vectors *vectors, const char *name)
{
    const struct table_file *table = &results->table;
    struct json json;
    output out;
    output_open(&out, name);
    json_begin(&json, &out);
    json_text(&json, "stage", vectors->stage);
    json_unsigned(&json, "rows", table->rows);
    json_unsigned(&json, "of", vectors->rows.rows);
    json_unsigned(&json, "columns", results->fields);
    json_boolean(&json, "equal", !first->found);
    if (first->found) {
        json_object(&json, "first");
        json_text(&json, "id", table_file_cell(table, first->row, results->id));
        json_text(&json, "field", table_file_heading(table, first->column));
        json_text(&json, "expected", first->expected);
        json_text(&json, "found", table_file_cell(table, first->row, first->column));
        json_close(&json);
    }
    json_end(&json);
    output_commit(&out);
}

/* Fails where something differs, as where the results cannot be read. */
int command_vectors_check(const struct settings *settings)
{
    struct vectors vectors;
    struct results results = {.id = 0};
    struct first_difference first = {.found = false};
    vectors_open(&vectors, settings, settings->operands[0]);
    table_file_read(&results.table, settings->operands[1], ',');
    find_columns(&results, &vectors);
    compare(&first, &results, &vectors);
    if (settings->json != NULL) {
        write_report(&first, &results, &vectors, settings->json);
    } else if (!settings->quiet) {
        print_comparison(&first, &results, &vectors);
    }
    free(results.seen);
    free(results.truth);
    table_file_free(&results.table);
    vectors_close(&vectors);
    if (fflush(stdout) != 0) {
        system_error("standard output", NULL);
    }
    return first.found ? EXIT_DIFFERENT : EXIT_SUCCESS;
}

/* ---- Explanation -------------------------------------------------------------- */

/* A row's id is its stage and its number. */
int command_vectors_show(const struct settings *settings)
{
    struct vectors vectors;
    const char *id = settings->operands[0], *number = strrchr(id, '-');
    size_t length = number != NULL ? (size_t)(number - id) : 0, row;
    if (length == 0) {
        usage_error("id", "'%s' is no id like weights-00000", id);
    }
    char *stage = allocate(length + 1, id, NULL);
    memcpy(stage, id, length);
    vectors_open(&vectors, settings, stage);
    if (!vectors_find(&row, &vectors, id)) {
        usage_error("id", "'%s' is none of the %zu rows of %s", id, vectors.rows.rows,
                    vectors.rows.name);
    }
    vector_explain(&vectors, row);
    vectors_close(&vectors);
    free(stage);
    finish_output();
}
